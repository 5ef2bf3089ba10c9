"""A motor on a gearbox sized over the scenario's duty cycle."""

from __future__ import annotations

import copy
from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS, sizing
from torquerig.metrics.sizing.sized_drive import SizedDrive, sized_drive
from torquerig.study.candidates import scenario_of

if TYPE_CHECKING:
    from torquerig.document import Document
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study


def with_cycle(document: Document) -> Document:
    """Return the document with its duty cycle as the profile; unchanged without a cycle or with another profile."""
    data = document.data
    point = data.get("operating_point") if isinstance(data, dict) else None
    if not isinstance(point, dict) or "duty_cycle" not in point or point.get("profile", "steady") != "steady":
        return document
    edited = copy.deepcopy(data)
    edited["operating_point"]["profile"] = "duty_cycle"
    return replace(document, data=edited)


def sized_candidate(candidate: Candidate, study: Study) -> SizedDrive:
    """Return a candidate of the study over the duty cycle, its drive limited for the sensor."""
    cycled = replace(study, document=with_cycle(study.document))
    return sized_drive(scenario_of(candidate, cycled, seed=study.settings.seed), study.catalog)


def sizing_figures(candidate: Candidate, study: Study, wanted: Collection[str]) -> Mapping[str, Figure]:
    """Return the figures of a sizing among ``wanted``; empty without any calculation where none is."""
    names = [name for name in SIZING_UNITS if name in wanted]
    if not names:
        return {}
    found = sizing(sized_candidate(candidate, study), names=names).figures
    absent = {name: Figure(unit=SIZING_UNITS[name], missing=f"catalog entry of {candidate.gearbox}") for name in names}
    return {**absent, **{name: figure for name, figure in found.items() if name in names}}
