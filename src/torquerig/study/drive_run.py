"""One drive of a study: simulate, filter, measure, and repeat for Monte Carlo samples of the catalog."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import pi, prod
from typing import TypedDict

import numpy as np

from torquerig.filters.filter_effect import chain_effect
from torquerig.metrics.drive_margins import Duty, drive_margins
from torquerig.metrics.figure import Figure
from torquerig.metrics.load_path import load_path
from torquerig.metrics.omitted_ripple import omitted_six_pulse
from torquerig.metrics.random_error import rms_standard_error
from torquerig.metrics.residual_disturbance import ReadingPair, simulated_reading_pair
from torquerig.metrics.shares import reading_shares
from torquerig.metrics.truth_error import difference, truth_error
from torquerig.recordings.recording import Recording
from torquerig.rig.parts import Motor, SpeedController
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.kinematics import kinematics_of, stages_to, torque_gain, turns_to
from torquerig.scenario.mean_load import mean_load
from torquerig.scenario.model import Scenario
from torquerig.study.candidates import Candidate, scenario_of
from torquerig.study.definition import Study
from torquerig.study.exchanged_data import is_new_stage, look_up_stage
from torquerig.study.preflight import margin_of, out_of_reach
from torquerig.study.results import ChainResult, DriveResult
from torquerig.study.settings import SpeedLoopRule, metrics_of
from torquerig.study.sized_candidates import sizing_figures

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


def _simulated(unsimulated: DriveResult, scenario: Scenario, study: Study) -> DriveResult:
    """Return the drive with the results of its simulated samples, each of the same length and settling."""
    pair, rig = _pair(scenario, study, number=0), scenario.rig
    found = _Samples(study)
    found.add(scenario, pair)
    for number in range(1, study.settings.draws + 1):
        sample = scenario_of(unsimulated.candidate, study, seed=study.settings.seed + number)
        found.add(sample, _pair(sample, study, number=number))
    chains, ratio, unit = {}, kinematics_of(rig).ratio, study.effort_unit
    for name, chain in study.chains(scenario).items():
        after = chain.apply(pair.reading)
        chains[name] = ChainResult(
            chain=name,
            effect=chain_effect(pair.reading, after, ratio=ratio, lines=chain.lines),
            truth_error=_figure(found.errors[name], scenario.assumed, unit=unit),
            left_out=chain.left_out,
            random_error=_random_error(found.errors[name], after, pair.reading),
            **found.remainder(name, scenario.assumed, unit=unit),
        )
    shares = reading_shares(rig, **_conditions(scenario, study), known=(pair.reading, pair.quiet))
    return replace(
        unsimulated, shares=shares, load_path=load_path(rig), loop=margin_of(scenario, study), chains=chains,
        recording=pair.reading,
        disturbance=_figure(found.disturbances, scenario.assumed, unit=unit),
    )  # fmt: skip


def _random_error(errors: list[float], after: Recording, reading: Recording) -> float | None:
    """Return the standard error of the median of the samples by the randomness of the load, from the first record."""
    found = rms_standard_error(difference(after, reading), rate=reading.sample_rate)
    return None if found is None or not errors[0] else found / errors[0] * float(np.median(errors))


class _Samples:
    """Collects the figures of the Monte Carlo samples of one drive, in the order of the samples."""

    def __init__(self, study: Study) -> None:
        self.study = study
        self.errors: dict[str, list[float]] = {}
        self.remaining: dict[str, list[float]] = {}
        self.disturbances: list[float] = []

    def add(self, scenario: Scenario, pair: ReadingPair) -> None:
        """Add one sample; the disturbance behind each chain only where a criterion uses it."""
        self.disturbances.append(pair.disturbance)
        for name, chain in self.study.chains(scenario).items():
            self.errors.setdefault(name, []).append(truth_error(chain.apply(pair.reading), pair.reading))
            if "residual_disturbance" in metrics_of(self.study.settings):
                self.remaining.setdefault(name, []).append(pair.residual_rms(chain))

    def remainder(self, name: str, assumed: Mapping[str, str], *, unit: str) -> _Remainder:
        """Return the disturbance behind a chain, where a criterion uses it."""
        found = self.remaining.get(name)
        return {"residual_disturbance": _figure(found, assumed, unit=unit)} if found else {}


class _Remainder(TypedDict, total=False):
    """The disturbance behind a chain, where a criterion uses it."""

    residual_disturbance: Figure


class _Conditions(TypedDict):
    """What all runs of a drive have in common."""

    duration: float
    seed: int
    settling: float
    wander: float
    sample_rate: float


def _conditions(scenario: Scenario, study: Study) -> _Conditions:
    """Return length, load, settling, wander and rate of every run: the same for all drives and samples."""
    return {
        "duration": study.settings.duration,
        "seed": study.settings.seed,
        "settling": max(scenario.recording.settling, settling_of(study.settings.speed_loop)),
        "wander": scenario.operating_point.slow_speed_wander,
        "sample_rate": scenario.recording.sample_rate,
    }


def _pair(scenario: Scenario, study: Study, *, number: int) -> ReadingPair:
    """Return the reading of one sample with and without its lines, under the load that all samples have."""
    return simulated_reading_pair(
        scenario.rig, **_conditions(scenario, study), scenario=scenario.title,
        phase_seed=study.settings.seed + number if number else None,
    )  # fmt: skip


def _figure(values: list[float], assumed: Mapping[str, str], *, unit: str) -> Figure:
    """Return the median of the samples, with their extremes."""
    missing = ", ".join(assumed) if assumed else ""
    return Figure(value=float(np.median(values)), low=min(values), high=max(values), unit=unit,
                  source=f"simulated, median of {len(values)} samples", missing=missing)  # fmt: skip
