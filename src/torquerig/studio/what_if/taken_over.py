"""A what-if as edits of the scenario, after which the commands give its numbers without an option."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.rig.parts import Motor, SpeedController
from torquerig.scenario.overrides import overridden
from torquerig.studio.what_if.question import Question
from torquerig.study.candidates import candidate_of, scenario_of
from torquerig.study.definition import open_study
from torquerig.study.exchanged_data import document_of


@dataclass(frozen=True)
class Edit:
    """A value that replaces what is under ``keys``; None removes the key."""

    keys: tuple[str, ...]
    value: Any


def taken_over(question: Question, catalog: Catalog) -> tuple[Edit, ...]:
    """Return the edits that bring the changes of a question into its scenario.

    Another motor or gearbox brings the gains of the speed loop and the torque limit that the study's rule gives it.

    Raises
    ------
    InputError
        For a scenario or change that cannot be used.
    """
    stated = parse_document(question.text, question.path)
    changed = overridden(stated, question.written_settings())
    edits = [Edit(keys, _at(changed.data, keys)) for keys, _ in question.settings]
    if not question.motor and not question.gearbox:
        return tuple(edits)
    study = open_study(changed, catalog)
    parts = study.exchanged
    motor = question.motor or study.settings.present.motor
    candidate = candidate_of(study, motor=motor, gearbox=question.gearbox or study.present_gearbox)
    made = scenario_of(candidate, study, seed=question.seed)
    rig = document_of(candidate.motor, candidate.gearbox, study).data["rig"]
    part = made.rig.part(parts.motor)
    assert isinstance(part, Motor)
    rig[parts.motor] = {**rig[parts.motor], "torque_limit": f"{part.torque_limit!r} N*m"}
    for controller in made.rig.parts_of(SpeedController):
        if controller.motor == parts.motor:
            gains = {"kp": f"{controller.kp!r} N*m*s/rad", "ki": f"{controller.ki!r} N*m/rad"}
            rig[controller.name] = {**rig[controller.name], **gains}
    before = changed.data["rig"]
    edits += [Edit(("rig", name), one) for name, one in rig.items() if one != before[name]]
    edits += [Edit(("rig", name), None) for name in before if name not in rig]
    return tuple(edits)


def _at(data: Any, keys: tuple[str, ...]) -> Any:
    for key in keys:
        data = data[key]
    return data
