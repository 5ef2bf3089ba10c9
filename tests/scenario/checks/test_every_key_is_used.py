"""Every key of every shipped scenario counts: another value changes a result, is refused, or is reported as unused."""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path as PathOf
from typing import Any

import numpy as np
import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import Document, parse_document, read_document
from torquerig.errors import TorquerigError
from torquerig.inference.knobs import nuisance_knobs
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import driven_motor
from torquerig.scenario.checks.unused import unused_by_simulation
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.recorded.sensor_priors import sensor_priors
from torquerig.simulation.input_channels import driven_parts, with_inputs
from torquerig.simulation.simulator import simulate
from torquerig.study import planned_drive
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.criteria import criteria_of, requirements_of
from torquerig.study.definition import Study, open_study
from torquerig.study.exchanged_data import look_up_stage
from torquerig.study.operating_points import points_of
from torquerig.study.sample_runs import DriveSamples

LENGTH, SETTLING = 0.05, 0.02  # [s] of the simulated stretch: 1250 samples at 25 kHz
Path = tuple[Any, ...]


@cache
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


@cache
def documents() -> dict[str, Document]:
    found = {path.name: read_document(path) for path in sorted(shipped_scenarios().glob("*.yaml"))}
    return {name: one for name, one in found.items() if isinstance(one.data, dict) and "rig" in one.data}


def leaves(data: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    """Yield every value that is no mapping or list, with its path."""
    if isinstance(data, dict | list):
        for key, value in data.items() if isinstance(data, dict) else enumerate(data):
            yield from leaves(value, (*path, key))
    else:
        yield path, data


def others(value: Any) -> tuple[Any, ...]:
    """Return other values of one kind: 7 % more, a twentieth, a neighbouring count, the other word."""
    if isinstance(value, bool):
        return (not value,)
    if isinstance(value, int):
        return value + 1, value - 1, 2 * value + 1
    if isinstance(value, float):
        return value * 1.07 + (0.01 if value == 0 else 0.0), value * 0.05
    number = re.match(r"^([+-]?[\d.]+(?:[eE][+-]?\d+)?)( .*|)$", str(value))
    if number is None:
        return (f"{value}x",)
    return tuple(f"{factor * float(number[1]) or factor}{number[2]}" for factor in (1.07, 0.05))


def changed(document: Document, path: Path, value: Any) -> Document:
    data = copy.deepcopy(document.data)
    held = data
    for key in path[:-1]:
        held = held[key]
    held[path[-1]] = value
    return replace(document, data=data)


def driven(rig: Rig) -> Rig:
    """Return the rig with a recorded torque and angle as inputs, where parts take them of each recording."""
    if not driven_parts(rig):
        return rig
    time = np.arange(1000) / 1000.0
    recorded = {"torque": (np.sin(40 * time), "N*m"), "motor_angle": (90 * time + 0.1 * np.sin(30 * time), "rad")}
    channels = {
        name: Channel(values=values, quantity=name, unit=unit, role="input")
        for name, (values, unit) in recorded.items()
    }
    return with_inputs(rig, Recording(sample_rate=1000.0, channels=channels))


def as_simulated(made: Scenario) -> object:
    """What is recorded: every sample, and the set-point of the speed that later commands read."""
    reading = simulate(
        driven(made.rig), duration=LENGTH, seed=1, wander=made.operating_point.slow_speed_wander, settling=SETTLING,
        sample_rate=made.recording.sample_rate,
    )  # fmt: skip
    return {name: channel.values.tobytes() for name, channel in reading.channels.items()}, reading.run.speed


def as_read(made: Scenario) -> object:
    return made.title, made.rig.terms(), made.rig.stages(), made.recording, kinematics_of(made.rig).lines()


def as_fitted(made: Scenario) -> object:
    """What a diagnosis fits, what it knows of the sensors, and the error of the speed that it permits."""
    knobs = nuisance_knobs(made.rig, made.uncertainties, occupancies=[])
    return knobs, sensor_priors(made), made.operating_point.speed_set_point_error_max


def as_sized_over_its_cycle(made: Scenario) -> object:
    if "duty_cycle" not in made.document.data.get("operating_point", {}):
        return None
    cycle = read(changed(made.document, ("operating_point", "profile"), "duty_cycle"))
    if driven_motor(cycle.rig) is None:
        return None
    needed = drive_requirement(cycle.rig, duration=1.0)
    return needed.duration.tolist(), needed.speed.tolist(), needed.torque.tolist()


def as_loaded_elsewhere(made: Scenario) -> object:
    """The terms at every occupancy at which a load is stated."""
    tables = [getattr(part, "mean_by_occupancy_percent", {}) for part in made.rig.parts]
    known = sorted({each for table in tables for each in table})
    return [made.rig.at(replace(made.rig.run, occupancy_percent=each)).terms() for each in known]


def as_decided(study: Study) -> object:
    return candidates(study), requirements_of(study), criteria_of(study), points_of(study)


def as_driven(study: Study) -> object:
    """A candidate of the study, of the largest ratio, and the filters on it."""
    compared = candidates(study)
    made = scenario_of(compared[-1], study, seed=study.settings.seed)
    stages = [look_up_stage(one.gearbox, study) for one in compared]
    return [*study.chains(made)], made.rig.terms(), planned_drive.settling_of(study.settings.speed_loop), stages


def read(document: Document) -> Scenario:
    return read_scenario(document, catalog(), seed=1)


OF_A_RUN: tuple[Callable[[Scenario], object], ...] = (
    as_read, as_fitted, as_sized_over_its_cycle, as_loaded_elsewhere, as_simulated,
)  # fmt: skip
OF_A_STUDY: tuple[Callable[[Study], object], ...] = (as_decided, as_driven)
OF_WHOLE_STUDIES = {("study", "duration"), ("study", "seed"), ("study", "draws")}
"""Keys that only whole runs show; length and seed are tested below, the draws in tests/study/."""


def results(document: Document, section: str) -> Iterator[tuple[str, object]]:
    """Yield what the values of a section lead to, the quickest first; the document is read once."""
    if section == "study":
        study = open_study(document, catalog())
        yield from ((one.__name__, one(study)) for one in OF_A_STUDY)
    else:
        made = read(document)
        yield from ((one.__name__, one(made)) for one in OF_A_RUN)


def counts(document: Document, path: Path, value: Any, known: dict[str, object]) -> bool:
    try:
        return any(found != known[name] for name, found in results(changed(document, path, value), path[0]))
    except TorquerigError:
        return True


@pytest.mark.long
@pytest.mark.parametrize("name", documents())
def test_another_value_of_every_key_changes_a_result_or_is_reported(name: str) -> None:
    document = documents()[name]
    known = dict([*results(document, "rig"), *(results(document, "study") if "study" in document.data else ())])
    unused = [text.split(":")[0] for text in unused_by_simulation(read(document))]
    silent = [
        ".".join(map(str, path))
        for path, value in leaves(document.data)
        if path not in OF_WHOLE_STUDIES
        and path[-1] != "purpose"  # printed in the report
        and not any(counts(document, path, other, known) for other in others(value))
    ]
    assert [one for one in silent if not any(one.startswith(each) for each in unused)] == []


def test_the_length_and_the_seed_of_a_study_are_those_of_its_runs() -> None:
    document = documents()["wear_rig.yaml"]
    asked = []
    for key, value in (("duration", "7 s"), ("seed", 5)):
        study: Study = open_study(changed(document, ("study", key), value), catalog())
        candidate = candidates(study)[0]
        drive = planned_drive.planned_drive(candidate, scenario_of(candidate, study, seed=study.settings.seed), study)
        spans = [run.run.span for run in DriveSamples(0, drive, study).runs()]
        asked += list({(span.samples / span.rate, span.seed) for span in spans})
    assert asked == [(7.0, 1), (10.0, 5)]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({("operating_point", "load", "particle_size"): "0.6 mm"}, "operating_point.load.particle_size"),
        ({("operating_point", "load", "occupancy"): "7 %"}, "operating_point.load.occupancy"),
    ],
)
def test_a_condition_that_no_part_depends_on_is_reported(changes: dict[Path, Any], said: str) -> None:
    document = documents()["wear_rig.yaml"]
    data = copy.deepcopy(document.data)
    del data["rig"]["load"], data["rig"]["shaft"]
    bare = replace(document, data=data)
    for path, value in changes.items():
        bare = changed(bare, path, value)
    assert said in [text.split(":")[0] for text in unused_by_simulation(read(bare))]


def test_a_cycle_states_its_own_speed_and_length() -> None:
    cycle = changed(documents()["wear_rig.yaml"], ("operating_point", "profile"), "duty_cycle")
    keys = [text.split(":")[0] for text in unused_by_simulation(read(cycle))]
    assert "operating_point.output_speed" in keys
    assert "operating_point.slow_speed_wander" in keys
    assert "operating_point.duty_cycle" not in keys


LOCKED = """
operating_point: {motor_speed: 0 rpm}
measured: shaft
rig:
  motor: {kind: motor, inertia: 2 kg*cm^2, torque_limit: 5 N*m}
  shaft: {kind: coupling, stiffness: 500 N*m/rad, damping: 0.01 N*m*s/rad, inertia: 1 kg*cm^2}
  box: {kind: gear, ratio: 5, stiffness: 9 kN*m/rad, damping: 2 N*m*s/rad, output_inertia: 6 kg*cm^2,
        input_inertia: 1 kg*cm^2, viscous: 0.1 N*m*s/rad, smoothing: 0.1 rad/s, efficiency: 0.9}
  flange: {kind: body, inertia: 3 kg*cm^2}
  wall: {kind: ground}
  loop: {kind: torque_controller, motor: motor, torque: 0.1 N*m}
"""


def test_what_rests_at_a_locked_end_is_reported() -> None:
    """The gear's loss depends on its smoothing and efficiency; inertia and friction of the output rest."""
    made = read_scenario(parse_document(LOCKED, PathOf("locked.yaml")), catalog(), seed=1)
    keys = [text.split(":")[0] for text in unused_by_simulation(made)]
    assert keys == ["rig.box.output_inertia", "rig.box.input_inertia", "rig.box.viscous", "rig.flange.inertia"]
