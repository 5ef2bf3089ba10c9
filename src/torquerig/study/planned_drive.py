"""One drive of a study before its runs: margins, the scenarios of its samples, and what is known of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import pi, prod
from typing import TYPE_CHECKING

from torquerig.metrics.drive_margins import Duty, drive_margins
from torquerig.metrics.figure import Figure
from torquerig.metrics.omitted_ripple import omitted_six_pulse
from torquerig.rig.parts import Motor, SpeedController
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.kinematics import stages_to, torque_gain, turns_to
from torquerig.scenario.mean_load import mean_load
from torquerig.simulation.inputs import Span
from torquerig.study.candidates import reader_of, tuned_scenario
from torquerig.study.exchanged_data import is_new_stage, look_up_stage
from torquerig.study.loop_margin import has_stable_loop
from torquerig.study.preflight import out_of_reach
from torquerig.study.results import DriveResult
from torquerig.study.settings import SpeedLoopRule, metrics_of
from torquerig.study.sized_candidates import sizing_figures

if TYPE_CHECKING:
    from torquerig.scenario.model import Scenario
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study

TIME_CONSTANTS = 7.5  # [1] settling time over that of the slowest pole; 0.06 % of it remains


@dataclass(frozen=True, kw_only=True)
class PlannedDrive:
    """One motor on one stage before its runs.

    Parameters
    ----------
    result : DriveResult
        With everything that no simulation is needed for.
    samples : tuple of Scenario
        The Monte Carlo samples of the catalog, to be simulated, without those whose speed loop is unstable; empty for a
        drive that cannot reach its speed, torque or voltage.
    """

    result: DriveResult
    samples: tuple[Scenario, ...]


def planned_drive(candidate: Candidate, scenario: Scenario, study: Study) -> PlannedDrive:
    """Return the margins of one motor on one stage, and the scenarios of its samples; ``scenario`` is the first."""
    seed, draws = study.settings.seed, study.settings.draws
    motor = scenario.rig.part(study.exchanged.motor)
    assert isinstance(motor, Motor)
    controller = next(one for one in scenario.rig.parts_of(SpeedController) if one.motor == motor.name)
    reason = out_of_reach(candidate, scenario, study)
    result = DriveResult(
        candidate=candidate,
        margins=_margins(candidate, scenario, study, torque_limit=motor.torque_limit),
        out_of_reach=reason,
        motor_speed=scenario.rig.run.speed or 0.0,
        torque_limit=motor.torque_limit,
        kp=controller.kp,
        assumed=scenario.assumed,
        shares=None,
        disturbance=Figure(unit=study.effort_unit, missing=reason),
        chains={},
        omitted=_omitted(candidate, scenario, study),
        taken=scenario.taken,
    )
    if reason:
        return PlannedDrive(result=result, samples=())
    reader = reader_of(candidate, study)
    further = [tuned_scenario(reader, study, seed=seed + number) for number in range(1, draws + 1)]
    stable = [one for one in further if has_stable_loop(one.rig, rate=one.recording.sample_rate)]
    result = replace(result, unstable_samples=len(further) - len(stable))
    return PlannedDrive(result=result, samples=(scenario, *stable))


def sample_span(scenario: Scenario, study: Study, *, number: int = 0, settling: float = 0.0) -> Span:
    """Return length, load, settling, wander and rate of a sample: the same for all samples, phases by its number.

    It settles as long as the scenario and the study's speed loop ask for, at least ``settling`` [s].
    """
    settings = study.settings
    return Span.of(
        duration=settings.duration, seed=settings.seed, rate=scenario.recording.sample_rate,
        settling=max(settling, scenario.recording.settling, settling_of(settings.speed_loop)),
        wander=scenario.operating_point.slow_speed_wander, phase_seed=settings.seed + number if number else None,
    )  # fmt: skip


def settling_of(rule: SpeedLoopRule) -> float:
    """Return the settling time [s] of a drive tuned by this rule, from the slower of its two corners."""
    corners = [corner for corner in (rule.crossover, rule.integral_corner) if corner > 0]
    return round(TIME_CONSTANTS / (2 * pi * min(corners)), 1)


def _omitted(candidate: Candidate, scenario: Scenario, study: Study) -> Figure:
    torque = mean_load(scenario.rig) / torque_gain(scenario.rig)
    return omitted_six_pulse(scenario.rig, study.catalog.motor(candidate.motor), motor_torque=torque)


def _margins(candidate: Candidate, scenario: Scenario, study: Study, *, torque_limit: float) -> Mapping[str, Figure]:
    rig, present = scenario.rig, study.settings.present
    entry = study.catalog.motor(candidate.motor)
    stage = look_up_stage(candidate.gearbox, study) if candidate.gearbox else None
    ratio = turns_to(rig, reading_place(rig))
    duty = Duty(
        output_speed=abs(rig.run.speed or 0.0) / ratio,
        mean_torque=mean_load(rig),
        ratio=ratio,
        efficiency=prod(crossed.efficiency for crossed in stages_to(rig, reading_place(rig))),
        torque_limit=torque_limit,
        unit=study.effort_unit,
    )
    margins = drive_margins(
        entry,
        stage,
        duty,
        new_motor=(entry.stands_for or entry.name) != present.motor,
        new_stage=stage is not None and is_new_stage(candidate.gearbox, candidate.ratio, study),
    )
    return {**margins, **sizing_figures(candidate, study, metrics_of(study.settings))}
