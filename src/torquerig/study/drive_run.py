"""One drive of a study: simulate, filter, measure, and repeat for Monte Carlo samples of the catalog."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import pi, prod

from torquerig.filters.filter_effect import chain_effect
from torquerig.metrics.drive_margins import Duty, drive_margins
from torquerig.metrics.figure import Figure
from torquerig.metrics.omitted_ripple import omitted_six_pulse
from torquerig.metrics.residual_disturbance import simulated_reading_pair
from torquerig.metrics.shares import disturbance_rms, reading_shares
from torquerig.metrics.truth_error import truth_error
from torquerig.rig.parts import Motor, SpeedController
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.kinematics import kinematics_of, stages_to, torque_gain, turns_to
from torquerig.scenario.mean_load import mean_load
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate
from torquerig.study.candidates import Candidate, scenario_of
from torquerig.study.definition import Study
from torquerig.study.exchanged_data import is_new_stage, look_up_stage
from torquerig.study.preflight import out_of_reach
from torquerig.study.results import ChainResult, DriveResult
from torquerig.study.settings import SpeedLoopRule, metrics_of
from torquerig.study.sized_candidates import sizing_figures

SHARES_DURATION = 3.0  # [s] ten output turns, of each of the five runs that separate the shares
DRAW_DURATION = 6.0  # [s] of each Monte Carlo run
TIME_CONSTANTS = 7.5  # [1] settling time over that of the slowest pole; 0.06 % of it remains


def run_drive(candidate: Candidate, study: Study) -> DriveResult:
    """Return the results of one motor on one gearbox: margins, shares of the reading, and every filter."""
    scenario = scenario_of(candidate, study, seed=study.settings.seed)
    motor = scenario.rig.part(study.exchanged.motor)
    assert isinstance(motor, Motor)
    controller = next(one for one in scenario.rig.parts_of(SpeedController) if one.motor == motor.name)
    speed = scenario.rig.run.speed or 0.0
    reason = out_of_reach(candidate, scenario, study)
    unsimulated = DriveResult(
        candidate=candidate,
        margins=_margins(candidate, scenario, study, torque_limit=motor.torque_limit),
        out_of_reach=reason,
        motor_speed=speed,
        torque_limit=motor.torque_limit,
        kp=controller.kp,
        assumed=scenario.assumed,
        shares=None,
        disturbance=Figure(unit=study.effort_unit, missing=reason),
        chains={},
        recording=None,
        omitted=_omitted(candidate, scenario, study),
        taken=scenario.taken,
    )
    return unsimulated if reason else _simulated(unsimulated, scenario, study)


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
        output_speed=(rig.run.speed or 0.0) / ratio,
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


def _simulated(unsimulated: DriveResult, scenario: Scenario, study: Study) -> DriveResult:
    """Return the drive with the results of its simulation."""
    rig, seed, unit = scenario.rig, study.settings.seed, study.effort_unit
    wander, ratio = scenario.operating_point.slow_speed_wander, kinematics_of(rig).ratio
    settling, rate = settling_of(study.settings.speed_loop), scenario.recording.sample_rate
    reading = simulate(
        rig, duration=study.settings.duration, seed=seed, wander=wander, sample_rate=rate,
        settling=max(scenario.recording.settling, settling), scenario=scenario.title,
    )  # fmt: skip
    shares = reading_shares(
        rig, duration=SHARES_DURATION, seed=seed, wander=wander, settling=settling, sample_rate=rate
    )  # fmt: skip
    errors, disturbances = _monte_carlo_runs(unsimulated.candidate, study)
    chains, remaining = {}, _remaining_disturbances(unsimulated.candidate, scenario, study)
    for name, chain in study.chains(scenario).items():
        after = chain.apply(reading)
        chains[name] = ChainResult(
            chain=name,
            effect=chain_effect(reading, after, ratio=ratio, lines=chain.lines),
            truth_error=_figure(truth_error(after, reading), errors.get(name, []), scenario.assumed, unit=unit),
            left_out=chain.left_out,
            **({"residual_disturbance": remaining[name]} if name in remaining else {}),
        )
    disturbance = _figure(shares.disturbance, disturbances, scenario.assumed, unit=unit)
    return replace(unsimulated, shares=shares, disturbance=disturbance, chains=chains, recording=reading)


def _monte_carlo_runs(candidate: Candidate, study: Study) -> tuple[dict[str, list[float]], list[float]]:
    """Return reading errors by chain, and disturbances, of Monte Carlo samples of the catalog's intervals."""
    errors: dict[str, list[float]] = {}
    disturbances, settling = [], settling_of(study.settings.speed_loop)
    for number in range(1, study.settings.draws + 1):
        seed = study.settings.seed + number
        scenario = scenario_of(candidate, study, seed=seed)
        wander = scenario.operating_point.slow_speed_wander
        reading = simulate(
            scenario.rig, duration=DRAW_DURATION, seed=seed, wander=wander, settling=settling,
            sample_rate=scenario.recording.sample_rate,
        )  # fmt: skip
        for name, chain in study.chains(scenario).items():
            errors.setdefault(name, []).append(truth_error(chain.apply(reading), reading))
        disturbances.append(disturbance_rms(scenario.rig, reading, seed=seed, wander=wander, settling=settling))
    return errors, disturbances


def _remaining_disturbances(candidate: Candidate, scenario: Scenario, study: Study) -> dict[str, Figure]:
    """Return the disturbance behind each chain over all Monte Carlo samples; empty unless a criterion uses it."""
    if "residual_disturbance" not in metrics_of(study.settings):
        return {}
    found: dict[str, list[float]] = {}
    settling = settling_of(study.settings.speed_loop)
    for number in range(1 + study.settings.draws):
        seed = study.settings.seed + number
        made = scenario if number == 0 else scenario_of(candidate, study, seed=seed)
        wander = made.operating_point.slow_speed_wander
        both = simulated_reading_pair(
            made.rig, duration=DRAW_DURATION, seed=seed, wander=wander, settling=settling,
            sample_rate=made.recording.sample_rate,
        )  # fmt: skip
        for name, chain in study.chains(made).items():
            found.setdefault(name, []).append(both.residual_rms(chain))
    return {
        name: _figure(values[0], values[1:], scenario.assumed, unit=study.effort_unit) for name, values in found.items()
    }


def _figure(value: float, others: list[float], assumed: Mapping[str, str], *, unit: str) -> Figure:
    missing = ", ".join(assumed) if assumed else ""
    low, high = min([value, *others]), max([value, *others])
    return Figure(value=value, low=low, high=high, unit=unit, source=f"simulated, {1 + len(others)} samples",
                  missing=missing)  # fmt: skip
