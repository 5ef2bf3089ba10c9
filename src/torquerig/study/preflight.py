"""Checks of a study before its first run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.scenario.checks.requirement_check import requirement_faults
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.study.criteria import criteria_of, requirements_of
from torquerig.study.loop_figures import LoopMargin
from torquerig.study.loop_margin import loop_margin

if TYPE_CHECKING:
    from torquerig.scenario.model import Scenario
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study


def check_study(study: Study, scenarios: Mapping[Candidate, Scenario]) -> None:
    """Raise InputError for a study that could not be ranked after its runs.

    Raises
    ------
    InputError
        With file, line and key: no speed, a profile of segments, an unusable requirement or criterion, or a present
        drive that cannot be the baseline.
    """
    place = study.document.place
    requirements_of(study)
    criteria_of(study)
    if not all(scenario.rig.run.speed for scenario in scenarios.values()):
        raise InputError(f"{place(('operating_point',))}: a study needs a speed; write output_speed, such as 200 rpm")
    _refuse_cycles(study, next(iter(scenarios.values())))
    study.chains(next(iter(scenarios.values())))
    present = study.settings.present
    there = {one: made for one, made in scenarios.items() if one.motor == present.motor}
    faults = [out_of_reach(one, made, study) for one, made in there.items()]
    if all(faults):
        fault = f"is out of reach ({faults[0]})" if there else "is not among the motors of the study"
        raise InputError(
            f"{place(('study', 'present', 'motor'))}: the present motor {present.motor!r} {fault}, and the Pugh matrix "
            "needs it as its baseline; list it under motors, or name another present drive"
        )


def out_of_reach(candidate: Candidate, scenario: Scenario, study: Study) -> str:
    """Return why a drive cannot reach the speed, torque or voltage of its run, or hold a speed; empty where it can."""
    too_much = beyond_the_drive(candidate, scenario, study)
    margin = None if too_much else margin_of(scenario, study)
    return too_much or ("" if margin is None else margin.fault)


def beyond_the_drive(candidate: Candidate, scenario: Scenario, study: Study) -> str:
    """Return which speed, torque or voltage of its run a drive cannot reach; empty for none."""
    demand = drive_requirement(scenario.rig, duration=study.settings.duration)
    faults = requirement_faults(demand, scenario.rig, study.catalog.motor(candidate.motor))
    return next((fault.text for fault in faults if fault.impossible), "")


def margin_of(scenario: Scenario, study: Study) -> LoopMargin | None:
    """Return the margin of the speed loop that the study tunes."""
    return loop_margin(
        scenario.rig, motor=study.exchanged.motor, crossover=study.settings.speed_loop.crossover,
        rate=scenario.recording.sample_rate,
    )  # fmt: skip


def _refuse_cycles(study: Study, scenario: Scenario) -> None:
    if scenario.rig.run.set_points is not None:
        raise InputError(
            f"{study.document.place(('operating_point', 'profile'))}: a study compares drives at one operating point, "
            f"and {scenario.rig.run.profile} has many; write steady, and use torquerig duty for the cycle of one drive"
        )
