"""A run without end is refused before it starts, with a value that can be followed."""

from __future__ import annotations

import re

import pytest

from torquerig.catalog.search import catalog_for
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError, SimulationError
from torquerig.rig.assembly import Rig
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

SCENARIO = shipped_scenarios() / "wear_rig.yaml"


def _rig(*settings: str) -> Rig:
    return read_scenario(overridden(read_document(SCENARIO), settings), catalog_for(SCENARIO, ()), seed=1).rig


@pytest.mark.parametrize(
    ("setting", "steps"),
    [
        ("torque_sensor.stiffness=1e12 N*m/rad", "(twist in 'torque_sensor')"),
        ("motor.inertia=1e-11 kg*m^2", "steps a sample for"),
        ("gearbox.stiffness=1e11 N*m/rad", "(twist in 'gearbox')"),
    ],
)
def test_a_rig_that_needs_steps_without_end_is_refused(setting: str, steps: str) -> None:
    with pytest.raises(SimulationError, match="integration steps a sample for") as refused:
        simulate(_rig(setting), duration=0.01, seed=1)
    assert steps in str(refused.value)
    assert "and 400 are the most" in str(refused.value)


@pytest.mark.parametrize("setting", ["coupling.stiffness=1e12 N*m/rad", "wear_part.inertia=1e-11 kg*m^2"])
def test_what_nothing_reads_is_condensed_and_not_refused(setting: str) -> None:
    made = simulate(_rig(setting), duration=0.01, settling=0.0, seed=1)
    assert "condensed: 4 inertias to 3" in made.origin["condensed"]


@pytest.mark.parametrize("part", ["torque_sensor", "gearbox"])
def test_the_stated_stiffness_can_be_followed(part: str) -> None:
    with pytest.raises(SimulationError) as refused:
        simulate(_rig(f"{part}.stiffness=1e11 N*m/rad"), duration=0.01, seed=1)
    stated = re.search(rf"the stiffness of '{part}' to at most (\S+ N\*m/rad)", str(refused.value))
    assert stated is not None, refused.value
    assert simulate(_rig(f"{part}.stiffness={stated[1]}"), duration=0.001, settling=0.0, seed=1).samples == 25


@pytest.mark.parametrize("duration", [1e3, 1e6, 1e15])
def test_a_run_that_fills_the_memory_is_refused_with_the_longest(duration: float) -> None:
    with pytest.raises(InputError, match=r"too many for the memory; ask for at most 398\.5 s"):
        simulate(_rig(), duration=duration, seed=1)
