"""``size``: whether motor, gearbox and sensor of a rig are large enough for its duty cycle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.result import Result
from torquerig.api.scenarios import scenario_file
from torquerig.api.values import folders, settings_of
from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS, Sizing, sizing
from torquerig.metrics.sizing.sized_drive import sized_drive
from torquerig.scenario.kinematics import ratio_text
from torquerig.scenario.overrides import overridden
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.study.sized_candidates import with_cycle

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

AMBIENT = 40.0  # [C] for which motors are rated (IEC 60034-1)


@dataclass(frozen=True, kw_only=True)
class SizedRig(Result):
    """The figures of a drive over its duty cycle, each with its limit.

    Parameters
    ----------
    sizing : Sizing
    title : str
    ambient : float
        [C]
    """

    sizing: Sizing
    title: str
    ambient: float

    @property
    def verdict(self) -> str:
        """``holds``, ``exceeds``, ``unsure`` or ``unknown``: the worst word of all limits."""
        return self.sizing.verdict

    def summary(self) -> str:
        """Return the verdict in one sentence, with what to ask the maker where it is not sure."""
        from torquerig.reporting.sizing.sizing_text import verdict_text

        return f"{self.title}: {verdict_text(self.sizing)}"

    def to_frame(self) -> pd.DataFrame:
        """Return one row per figure: value, interval, unit, whether its limit holds, what decides it."""
        import pandas as pd

        rows = {
            name: {
                "value": figure.value, "low": figure.low, "high": figure.high, "unit": SIZING_UNITS[name],
                "limit": self.sizing.word(name), "decided_by": figure.missing,
            }
            for name, figure in self.sizing.figures.items()
        }  # fmt: skip
        return pd.DataFrame.from_dict(rows, orient="index").rename_axis("figure")

    def as_dict(self) -> dict[str, Any]:
        """Return verdict, summary and figures as plain values."""
        figures = {str(name): dict(row) for name, row in self.to_frame().iterrows()}
        return {"verdict": self.verdict, "summary": self.summary(), "ambient_C": self.ambient, "figures": figures}

    def plot(self) -> Figure:
        """Return the speed-torque regions of the motor with the duty cycle in them."""
        from torquerig.reporting.sizing.speed_torque_figure import sizing_figure

        return sizing_figure(self.sizing.drive, None, title=self.title)


def size(
    scenario: str | Path, *, motor: str | None = None, gearbox: str | None = None, ambient: float = AMBIENT,
    changes: Mapping[str, Any] | None = None, catalogs: Sequence[str | Path] = (), seed: int = 1,
) -> SizedRig:  # fmt: skip
    """Return whether motor, gearbox and sensor are large enough for the duty cycle of a scenario.

    Parameters
    ----------
    scenario : str or Path
        A scenario file; a shipped one by its name. Without a duty cycle its profile is sized.
    motor, gearbox : str, optional
        Another entry of the catalog, run as the scenario's study would run it.
    ambient : float
        Temperature of the surroundings [C].
    changes : mapping of str to value, optional
        Values to change without editing the file.
    catalogs : sequence of path
        Further catalog folders.
    seed : int
        Fixes what the catalog leaves open.

    Returns
    -------
    SizedRig
        ``.verdict``, ``.to_frame()``, ``.plot()``.

    Raises
    ------
    InputError
        With file, line, key and remedy.

    Examples
    --------
    >>> import torquerig as tr
    >>> sized = tr.size("wear_rig.yaml", motor="HDS6A-0104A", gearbox="reference-5-1")
    >>> sized.to_frame().loc["rms_torque", "unit"]
    'N*m'
    """
    file = scenario_file(scenario)
    document = with_cycle(overridden(read_document(file), settings_of(changes)))
    catalog = catalog_for(file, folders(catalogs))
    made = scenario_or_candidate(document, catalog, motor=motor, gearbox=gearbox, seed=seed)
    drive = sized_drive(made, catalog)
    title = (
        f"{drive.motor_name}, {ratio_text(made.rig)}, {made.rig.run.profile}, {drive.requirement().duration.sum():g} s"
    )
    return SizedRig(sizing=sizing(drive, ambient=ambient), title=title, ambient=ambient)
