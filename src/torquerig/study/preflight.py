"""What must hold before a study spends its minute: every fault of the file is told before the first run."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

from torquerig.errors import InputError
from torquerig.scenario.reading import Scenario
from torquerig.study.candidates import Candidate
from torquerig.study.criteria import criteria_of, demands_of
from torquerig.study.study import Study


def check_study(study: Study, scenarios: Mapping[Candidate, Scenario]) -> None:
    """Refuse a study that could not be decided after its runs.

    Raises
    ------
    InputError
        With file, line and key: no speed, an unusable demand or criterion, or a present drive that cannot be the datum.
    """
    place = study.document.place
    demands_of(study)
    criteria_of(study)
    if not all(scenario.rig.run.speed for scenario in scenarios.values()):
        raise InputError(f"{place(('operating_point',))}: a study needs a speed; write output_speed, such as 200 rpm")
    study.chains(next(iter(scenarios.values())))
    present = study.settings.present
    there = {one: made for one, made in scenarios.items() if one.motor == present.motor}
    if all(out_of_reach(one, made, study) for one, made in there.items()):
        fault = "does not reach the speed" if there else "is not among the motors of the study"
        raise InputError(
            f"{place(('study', 'present', 'motor'))}: the present motor {present.motor!r} {fault}, and the Pugh matrix "
            "needs it as its datum; list it under motors, or name another present drive that reaches the speed"
        )


def out_of_reach(candidate: Candidate, scenario: Scenario, study: Study) -> str:
    """Return why a motor cannot turn as fast as its ratio asks, or an empty text."""
    speed, top = scenario.rig.run.speed or 0.0, study.catalog.motor(candidate.motor).max_speed.bounds[1]
    return f"needs {speed * 30 / pi:.0f} rpm, reaches at most {top * 30 / pi:.0f} rpm" if speed > top else ""
