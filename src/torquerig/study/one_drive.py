"""The drive of a command: that of the scenario, or a candidate of its study."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from torquerig.errors import InputError, UnknownNameError
from torquerig.rig.parts import SpeedController
from torquerig.scenario.reading import read_scenario
from torquerig.study.candidates import candidate_of, refuse_pinned, scenario_of
from torquerig.study.definition import open_study
from torquerig.study.exchanged_data import look_up_stage

if TYPE_CHECKING:
    from torquerig.catalog.reading import Catalog
    from torquerig.document import Document
    from torquerig.scenario.model import Scenario


def scenario_or_candidate(
    document: Document, catalog: Catalog, *, motor: str | None, gearbox: str | None, seed: int
) -> Scenario:
    """Return the scenario unchanged, or with another motor or gearbox, tuned and limited as in its study.

    Raises
    ------
    InputError
        When a speed controller has no speed to hold.
    UnknownNameError
        When the catalog has no such motor or gearbox; with the close matches.
    """
    if motor is None and gearbox is None:
        made = read_scenario(document, catalog, seed=seed)
        if made.rig.parts_of(SpeedController) and made.rig.run.speed is None:
            raise InputError(
                f"{document.path}: operating_point states no speed; write motor_speed or output_speed, such as 200 rpm"
            )
        return made
    study = open_study(document, catalog)
    if gearbox is not None and not study.exchanged.stage:
        raise InputError(
            f"--gearbox {gearbox}: the study of {document.path.name} exchanges no stage; name one with study: "
            "exchange: {stage: PART}, or list gearboxes there"
        )
    box = gearbox or study.present_gearbox
    if box:
        _looked_up("--gearbox", box, lambda name: look_up_stage(name, study))
    if gearbox is not None:
        refuse_pinned(gearbox, study)
    name = motor or study.settings.present.motor
    _looked_up("--motor", name, catalog.motor)
    return scenario_of(candidate_of(study, motor=name, gearbox=box), study, seed=seed)


def _looked_up(option: str, name: str, look_up: Callable[[str], object]) -> None:
    try:
        look_up(name)
    except UnknownNameError as error:
        raise UnknownNameError(f"{option} {name}: {error}") from None
