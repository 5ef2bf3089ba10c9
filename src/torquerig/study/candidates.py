"""Each motor on each stage as a rig: catalog values inserted, speed loop tuned, drive limited."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING

from torquerig.errors import InputError, UnknownNameError
from torquerig.rig.leading_part import leading_part
from torquerig.rig.parts import LinearDrive, Motor, SpeedController
from torquerig.rig.parts.gear_stage import GearStage
from torquerig.rig.reading_place import reading_place
from torquerig.rig.terms import Inertia
from torquerig.scenario.kinematics import kinematics_of, torque_gain, turns_to
from torquerig.scenario.reading import ScenarioReader
from torquerig.study.candidate import Candidate
from torquerig.study.exchange import pinned_ratio
from torquerig.study.exchanged_data import document_of, look_up_stage

if TYPE_CHECKING:
    from torquerig.rig.assembly import Rig
    from torquerig.scenario.model import Scenario
    from torquerig.study.definition import Study
    from torquerig.study.settings import SpeedLoopRule


def candidates(study: Study) -> tuple[Candidate, ...]:
    """Return all motors on all stages; a ratio next to the catalog entry of the rig's gear fixes the gearbox."""
    _refuse_unknown(study)
    boxes = compared_gearboxes(study) or ("",)
    made = {box: candidate_of(study, motor=study.settings.present.motor, gearbox=box) for box in boxes}
    texts = [one.ratio_text for one in made.values()]
    told = {box: box if texts.count(one.ratio_text) > 1 else "" for box, one in made.items()}
    return tuple(
        replace(made[box], motor=motor, told_apart=told[box]) for motor in study.motors for box in boxes
    )  # fmt: skip


def compared_gearboxes(study: Study) -> tuple[str, ...]:
    """Return the gearboxes that the study compares: that of a stated ratio alone, else all; empty without a stage."""
    stage = study.exchanged.stage
    if pinned_ratio(study.document, stage) is None:
        return study.gearboxes
    return (str(study.document.data["rig"][stage]["catalog"]),)


def refuse_pinned(gearbox: str, study: Study) -> None:
    """Raise InputError where ``--gearbox`` names another gearbox than the one that a stated ratio fixes."""
    stage = study.exchanged.stage
    if pinned_ratio(study.document, stage) is None:
        return
    part = study.document.data["rig"][stage]
    if gearbox != part["catalog"]:
        place = study.document.place(("rig", stage, "ratio"))
        raise InputError(
            f"--gearbox {gearbox}: {place}: {part['ratio']:g} is stated next to the catalog entry {part['catalog']} "
            "and fixes the gearbox; leave out this ratio, or --gearbox"
        )


def candidate_of(study: Study, *, motor: str, gearbox: str) -> Candidate:
    """Return the candidate with the ratios of its chain, as it is read with the seed of the study."""
    parts = study.exchanged
    asked = Candidate(motor=motor, gearbox=gearbox, ratio=1.0, parts=parts)
    rig = candidate_scenario(reader_of(asked, study), study, seed=study.settings.seed).rig
    whole = kinematics_of(rig).ratio
    if not gearbox:
        return replace(asked, ratio=whole)
    part = rig.part(parts.stage)
    assert isinstance(part, GearStage)
    if isinstance(part, LinearDrive):
        return replace(
            asked, ratio=abs(part.ratio), whole_ratio=turns_to(rig, reading_place(rig)), moves_in_a_line=True
        )  # fmt: skip
    return replace(asked, ratio=abs(part.ratio), whole_ratio=whole)


def scenario_of(candidate: Candidate, study: Study, *, seed: int) -> Scenario:
    """Return the scenario with the candidate's motor and stage, its loop tuned by the rule, its drive limited.

    ``seed`` determines the values drawn from the catalog's intervals.
    """
    return tuned_scenario(reader_of(candidate, study), study, seed=seed)


def reader_of(candidate: Candidate, study: Study) -> ScenarioReader:
    """Return the reader of the scenario with the candidate's motor and stage, for many seeds."""
    return ScenarioReader(document_of(candidate.motor, candidate.gearbox, study), study.catalog)


def tuned_scenario(reader: ScenarioReader, study: Study, *, seed: int) -> Scenario:
    """Return what :func:`scenario_of` returns for the candidate of a reader."""
    scenario = candidate_scenario(reader, study, seed=seed)
    motor = study.exchanged.motor
    tuned = loop_tuned(scenario.rig, study.settings.speed_loop, motor=motor)
    return replace(scenario, rig=drive_limited(tuned, study.settings.sensor_limit, motor=motor))


def candidate_scenario(reader: ScenarioReader, study: Study, *, seed: int) -> Scenario:
    """Return the scenario with the candidate's parts, loop and limit as the scenario states them.

    Raises
    ------
    InputError
        Where the motor does not follow the set-point under a speed_controller, which the study tunes.
    """
    scenario, motor = reader.at(seed), study.exchanged.motor
    tuned = [one.name for one in scenario.rig.parts_of(SpeedController) if one.motor == motor]
    if not tuned or leading_part(scenario.rig) != motor:
        raise InputError(
            f"{study.document.place(('rig', motor))}: a study tunes the speed loop of the motor that it exchanges, and "
            f"{motor!r} does not follow the set-point; add a speed_controller with motor: {motor}, or name the driven "
            "motor with study: exchange: {motor: NAME}"
        )
    return scenario


def drive_limited(rig: Rig, sensor_limit: float, *, motor: str) -> Rig:
    """Return the rig with the drive's torque limit lowered to at most ``sensor_limit`` [N m] at the sensor."""
    part = rig.part(motor)
    assert isinstance(part, Motor)
    return rig.changed(replace(part, torque_limit=min(part.torque_limit, sensor_limit / torque_gain(rig))))


def loop_tuned(rig: Rig, rule: SpeedLoopRule, *, motor: str) -> Rig:
    """Return the rig with ``kp = 2 pi crossover J`` and ``ki = kp 2 pi corner``, J all inertia seen by the motor.

    The crossover of the open loop ``kp / (J s)``; it must stay well below the first torsional mode (``loop_margin``).
    """
    controller = next(one for one in rig.parts_of(SpeedController) if one.motor == motor)
    ratios = rig.speed_ratios(rig.node(controller.motor))
    inertias = [term for term in rig.terms() if isinstance(term, Inertia)]
    seen = sum(term.inertia * ratios.get(term.node, 0.0) ** 2 for term in inertias)
    kp = 2 * pi * rule.crossover * seen
    return rig.changed(replace(controller, kp=kp, ki=kp * 2 * pi * rule.integral_corner))


def _refuse_unknown(study: Study) -> None:
    present, catalog = study.settings.present, study.catalog

    def stage(name: str) -> object:
        return look_up_stage(name, study)

    named: Mapping[tuple[str, ...], tuple[tuple[str, ...], Callable[[str], object]]] = {
        ("motors",): (study.motors, catalog.motor),
        ("gearboxes",): (study.gearboxes, stage),
        ("present", "motor"): ((present.motor,), catalog.motor),
        ("present", "gearbox"): ((study.present_gearbox,) if study.present_gearbox else (), stage),
    }
    for key, (names, look_up) in named.items():
        for name in names:
            try:
                look_up(name)
            except UnknownNameError as error:
                raise UnknownNameError(f"{study.document.place(('study', *key))}: {error}") from None
