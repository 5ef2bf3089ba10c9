"""``diagnose``: which physics the scenario of a rig leaves out, by recordings of the rig."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.diagnosis_values import Finding, HeldOutResidual, finding_of, mismatch_of, residual_of
from torquerig.api.inputs import recording_from, scenario_from
from torquerig.api.result import Result
from torquerig.errors import InputError
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.whole_file import whole_file

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from torquerig.reporting.diagnosis.diagnosed import Diagnosed

MOST_WORKERS = 4  # where the caller states none: each holds some 200 MB


@dataclass(frozen=True, kw_only=True)
class Answer(Result):
    """What recordings have that the scenario of their rig lacks.

    Parameters
    ----------
    scenario : Scenario
        The nominal rig.
    diagnosed : Diagnosed
        The diagnosis in the contract's form, the completed rig, and what draws both.
    command : str
        Call that reproduces it, for the page.
    """

    scenario: Scenario
    diagnosed: Diagnosed
    command: str

    @property
    def verdict(self) -> str:
        """``adequate``, ``missing_physics``, ``unexplained`` or ``setup_error``."""
        return str(self.diagnosed.data["verdict"])

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The effects that the scenario leaves out, each with its parameters and confidence."""
        return tuple(map(finding_of, self.diagnosed.data["findings"]))

    @property
    def mismatch(self) -> tuple[Mismatch, ...]:
        """Where recordings and model differ."""
        return tuple(map(mismatch_of, self.diagnosed.data["mismatch"]))

    @property
    def fit(self) -> HeldOutResidual:
        """Residuals of held-out data: nominal, calibrated and completed model."""
        return residual_of(self.diagnosed.data["fit"])

    @property
    def model(self) -> Scenario | None:
        """The completed scenario, which simulates; None where nothing was added."""
        completed = self.diagnosed.completed
        if completed is None:
            return None
        known = {part.name for part in self.scenario.rig.parts}
        added = tuple(part for part in completed.parts if part.name not in known)
        return replace(self.scenario, rig=completed, added=(*self.scenario.added, *added), uncertainties={})

    def summary(self) -> str:
        """Return the verdict in sentences."""
        return self.diagnosed.sentence

    def to_frame(self) -> pd.DataFrame:
        """Return one row per parameter of each finding, with its 95 % interval."""
        import pandas as pd

        rows = [
            {
                "mechanism": finding.mechanism, "confidence": finding.confidence, "parameter": name,
                "value": stated.value, "low": stated.low, "high": stated.high, "unit": stated.unit,
            }
            for finding in self.findings
            for name, stated in finding.parameters.items()
        ]  # fmt: skip
        columns = ["mechanism", "confidence", "parameter", "value", "low", "high", "unit"]
        return pd.DataFrame(rows, columns=columns)

    def as_dict(self) -> dict[str, Any]:
        """Return the diagnosis in the form of its JSON schema."""
        return dict(self.diagnosed.data)

    def plot(self) -> Figure:
        """Return the share of the residual by place: where recordings and model differ."""
        from torquerig.reporting.diagnosis.mismatch_figure import mismatch_figure

        if not self.mismatch:
            raise InputError("recordings and model differ nowhere, so that there is no place to draw")
        return mismatch_figure(self.mismatch)

    def report(self, path: str | Path) -> Path:
        """Write the page of the diagnosis, one HTML file, and return its path."""
        page = self.diagnosed.page(self.diagnosed.data, command=self.command, model=None)
        with whole_file(Path(path)) as partial:
            partial.write_text(page, encoding="utf-8", newline="\n")
        return Path(path)


def diagnose(
    scenario: Scenario | str | Path, recordings: Sequence[Recording | str | Path], *,
    held_out: Sequence[str] = (), seed: int = 0,
    workers: int | None = None, progress: Callable[[str], None] = lambda _: None,
) -> Answer:  # fmt: skip
    """Return which physics a scenario leaves out, by recordings of its rig, and how much better the model gets.

    Parameters
    ----------
    scenario : Scenario, or path of its file
        The nominal rig.
    recordings : sequence of Recording or path
        Runs of one rig; several speeds and loads separate most effects.
    held_out : sequence of str
        Names of recordings that are not fitted and judge the models; without them a third of each recording does.
    seed : int
        Fixes every random number.
    workers : int, optional
        Fits at a time; without it one per core, four at most.
    progress : callable, optional
        Called with the name of each stage.

    Returns
    -------
    Answer
        ``.verdict``, ``.findings``, ``.model`` (the completed scenario), ``.report(path)``.

    Raises
    ------
    InputError
        Where recordings and scenario do not fit each other.

    Examples
    --------
    >>> import torquerig as tr
    >>> hum = tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.1,), phases=(0.0,))
    >>> speeds = [{"operating_point.output_speed": f"{rpm} rpm"} for rpm in (140, 180)]
    >>> rigs = [tr.read_scenario("wear_rig.yaml", changes=one) for one in speeds]
    >>> runs = [tr.simulate(rig + hum, duration=6.0, truth=False) for rig in rigs]
    >>> answer = tr.diagnose("wear_rig.yaml", runs)
    >>> [finding.mechanism for finding in answer.findings]
    ['mains_interference']
    """
    from torquerig.parallel import parallel_processes
    from torquerig.reporting.diagnosis.likelihood.made import diagnosed

    made = scenario_from(scenario)
    read = [recording_from(one) for one in recordings]
    if not read:
        raise InputError("a diagnosis needs at least one recording")
    if len({one.name for one in read}) < len(read):
        read = [replace(one, name=f"{place}: {one.name}") for place, one in enumerate(read, start=1)]
    with parallel_processes(workers or min(os.cpu_count() or 1, MOST_WORKERS)):
        found = diagnosed(made, read, held_out=held_out, seed=seed, progress=progress)
    return Answer(
        scenario=made, diagnosed=found, command=f"torquerig.diagnose({made.document.path.name!r}, [...], seed={seed})"
    )
