"""A scenario as a value: the rig that a file describes, and what is known of its numbers."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.catalog.reading import Catalog
from torquerig.document import Document
from torquerig.parameter import Estimate
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.catalog_values.filled import FromCatalog
from torquerig.scenario.conditions.operating_point import OperatingPoint
from torquerig.scenario.conditions.recording_settings import RecordingSettings
from torquerig.scenario.measured import written_measured
from torquerig.scenario.numbers.uncertain_text import with_uncertainty
from torquerig.scenario.sections import read_operating_point
from torquerig.scenario.writing import scenario_text, write_scenario, written_part
from torquerig.shown import figure, notebook_html

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Scenario:
    """A scenario file that has been read; ``scenario + mechanism`` is the same rig with one more effect.

    Parameters
    ----------
    document : Document
        The file.
    title : str
    operating_point : OperatingPoint
    rig : Rig
        At the operating point, with nominal values, and drawn ones where the catalog has only an interval.
    uncertainties : mapping of str to Estimate
        By ``part.field``: what a calibration may move.
    assumed : mapping of str to str
        By ``part.field``: what was drawn, and from which interval.
    taken : mapping of str to FromCatalog
        By ``part.field``: what the catalog gave.
    catalog : Catalog or None
        From which the values came.
    seed : int
        Fixed what was drawn.
    kept : mapping of str to str
        Uncertain numbers of the file that have their stated value, with the uncertainty, by ``part.field``.
    added : tuple of Part
        Effects and parts that the file does not have.
    recording : RecordingSettings
        Sample rate, length and settling time of its recordings.
    """

    document: Document
    title: str
    operating_point: OperatingPoint
    rig: Rig
    uncertainties: Mapping[str, Estimate] = field(default_factory=dict)
    assumed: Mapping[str, str] = field(default_factory=dict)
    taken: Mapping[str, FromCatalog] = field(default_factory=dict)
    catalog: Catalog | None = field(default=None, repr=False, compare=False)
    seed: int = 0
    added: tuple[Part, ...] = ()
    recording: RecordingSettings = field(default_factory=RecordingSettings)
    kept: Mapping[str, str] = field(default_factory=dict)

    def __add__(self, part: Part) -> Scenario:
        """Return the scenario with one more effect or part; its terms are checked at once."""
        rig = self.rig + part
        part.terms(rig)
        part.stages(rig)
        return replace(self, rig=rig, added=(*self.added, part))

    def choices(self) -> dict[str, float]:
        """Return the counts that were drawn of a few which the catalog names, such as pole pairs, by ``part.field``."""
        several = {name: one for name, one in self.taken.items() if len(one.known.choices) > 1}
        return {name: one.used for name, one in several.items() if all(of == int(of) for of in one.known.choices)}

    def text(self, *, head: str = "") -> str:
        """Return the scenario as the YAML of a file; ``head`` goes before it as a comment."""
        _, stated = read_operating_point(self.document, seed=self.seed)
        point = with_uncertainty(stated.values, stated.estimates)
        recorded = self.document.data.get("recording")
        return scenario_text(
            self.rig, title=self.title, operating_point=point, recording=recorded, known=self.uncertainties, head=head
        )  # fmt: skip

    def write(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write the scenario as a file that ``read_scenario`` reads; InputError where one may not be replaced."""
        target = Path(path)
        write_scenario(target, self.text(), overwrite=overwrite)
        return target

    def summary(self) -> str:
        """Return the rig, its set-point and where it is read, in one sentence."""
        run = self.rig.run
        speed = "no set-point" if run.speed_rpm is None else f"motor at {run.speed_rpm:g} rpm"
        return f"{self.title}: {len(self.rig.parts)} parts and effects, {speed}, read at {', '.join(self.rig.places)}"

    def to_frame(self) -> pd.DataFrame:
        """Return one row per number of the rig: part, kind, parameter, value with unit, uncertainty, what was drawn."""
        import pandas as pd

        rows = []
        for part in self.rig.parts:
            written = written_part(part, in_a_line=self.rig.in_a_line(part))
            for key, value in written.items():
                if key == "kind":
                    continue
                known = self.uncertainties.get(f"{part.name}.{key}")
                rows.append({
                    "part": part.name, "kind": part.kind, "parameter": key,
                    "value": value if isinstance(value, str | int | float) else json.dumps(value, default=str),
                    "rel_sd": known.rel_sd if known is not None else None,
                    "drawn": self.assumed.get(f"{part.name}.{key}", ""),
                })  # fmt: skip
        return pd.DataFrame(rows, columns=["part", "kind", "parameter", "value", "rel_sd", "drawn"])

    def to_json(self) -> str:
        """Return title, measured place and parts with their values as JSON."""
        parts = {part.name: written_part(part, in_a_line=self.rig.in_a_line(part)) for part in self.rig.parts}
        data = {"scenario": self.title, "measured": written_measured(self.rig), "rig": parts}
        return json.dumps(data, indent=2, ensure_ascii=False, default=str) + "\n"

    def plot(self) -> Figure:
        """Return a drawing of the parts along the shaft, with the effects at the parts that they act on."""
        return figure("rig_figure", self.rig, title=self.title)

    def _repr_html_(self) -> str:
        """Return what a notebook shows."""
        return notebook_html(self.summary(), self.to_frame())
