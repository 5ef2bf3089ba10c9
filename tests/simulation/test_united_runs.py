"""Runs of rigs with other lines and other steps, stepped together; fewer steps where no flanks meet."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.simulation.test_shared_waves import RIGS, SPAN, lines, machine
from torquerig.errors import SimulationError
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.simulation.batch_parts import BatchRun
from torquerig.simulation.inputs import Draws, Span
from torquerig.simulation.reused_memory import ReusedMemory
from torquerig.simulation.simulator import simulate
from torquerig.simulation.united_runs import shared_steps, simulate_united, united

LONGER = Span.of(duration=0.5, settling=0.5, rate=25_000.0, seed=3, wander=0.0)
SENSOR = "true_sensor_torque_Nm"


def with_gear(*, backlash: float, damping: float, brake: float = 0.05, ripple: float = 0.05) -> Rig:
    """Return the machine with another gear: ``brake`` [N m s/rad] closes its flanks, ``ripple`` [N m] opens them."""
    rig = machine(replace(lines(6, 12), amplitudes={6: ripple, 12: ripple}))

    def changed(part: Part) -> Part:
        if isinstance(part, Gear):
            return replace(part, backlash=backlash, damping=damping, output_inertia=2e-4)
        return replace(part, viscous=brake) if isinstance(part, Body) else part

    return replace(rig, parts=tuple(changed(part) for part in rig.parts))


def fine(rig: Rig, *, substeps: int) -> NDArray[np.float64]:
    made = simulate(rig, duration=0.5, settling=0.5, seed=3, substeps=substeps)
    return made.channels[SENSOR].values


STEPS = [(1, 1), (2, 2), (3, 4), (5, 6), (7, 8), (9, 12), (13, 16), (17, 24), (25, 32)]


@pytest.mark.parametrize(("steps", "taken"), STEPS)
def test_few_numbers_of_steps_are_taken_and_never_fewer_than_wanted(steps: int, taken: int) -> None:
    assert shared_steps(steps) == taken


def test_numbers_of_steps_are_at_most_half_as_many_more() -> None:
    assert all(steps <= shared_steps(steps) <= 1.5 * steps for steps in range(1, 1000))


def test_rigs_with_other_lines_are_stepped_together_and_others_apart() -> None:
    coupled = machine(Coupling(name="more", after="wheel", stiffness=9e2, damping=0.1),
                      Body(name="end", after="more", inertia=1e-3))  # fmt: skip
    runs = [BatchRun.of(rig, SPAN) for rig in (*RIGS, coupled, *RIGS)]
    parts = united(runs)
    assert sorted(row for part in parts for row in part) == list(range(len(runs)))
    assert sorted(len(part) for part in parts) == [1, 5, 5]
    assert [5] in parts


@pytest.mark.long
def test_what_a_run_gets_is_that_of_a_single_one() -> None:
    """To 1e-9 of the largest value, as waves are multiplied in another order; here no rig has a gap."""
    runs = [BatchRun.of(rig, SPAN) for rig in RIGS]
    for rig, made in zip(RIGS, simulate_united(runs, scenario="five"), strict=True):
        steps = made.origin["substeps"]
        single = simulate(rig, duration=0.1, settling=0.02, seed=3, scenario="five", substeps=steps)
        assert made.origin == single.origin
        assert made.channels.keys() == single.channels.keys()
        for name, channel in made.channels.items():
            expected = single.channels[name].values
            assert np.abs(channel.values - expected).max() <= 1e-9 * np.abs(expected).max(), name


@pytest.mark.long
@pytest.mark.parametrize("damping", [3.0, 6.0])
def test_flanks_that_stay_together_need_the_steps_of_a_spring(damping: float) -> None:
    """An overdamped twist in a gap: fewer steps than for an impact, within 1e-4 of the run with 16 times the steps."""
    rig = with_gear(backlash=3e-3, damping=damping)
    run = BatchRun.of(rig, LONGER)
    made = simulate_united([run])[0]
    steps = made.origin["substeps"]
    assert steps == shared_steps(run.steps_without_impacts(Draws())) < run.probable_steps
    exact = fine(rig, substeps=16 * run.probable_steps)
    error = np.sqrt(np.mean((made.channels[SENSOR].values - exact) ** 2)) / exact.std()
    assert error < 1e-4


@pytest.mark.long
def test_flanks_that_meet_are_simulated_with_the_steps_of_an_impact() -> None:
    """One of two rigs rattles; only that one is simulated again, and the other keeps the values it had."""
    calm, rattling = (
        with_gear(backlash=3e-3, damping=3.0),
        with_gear(backlash=3e-3, damping=3.0, brake=1e-4, ripple=0.4),
    )
    runs = [BatchRun.of(rig, LONGER) for rig in (calm, rattling)]
    made = simulate_united(runs)
    assert (made[1].channels[SENSOR].values == 0).sum() == 0  # the sensor is behind the gear
    few, many = (one.origin["substeps"] for one in made)
    assert few < many == shared_steps(runs[1].probable_steps)
    expected = fine(rattling, substeps=many)
    assert np.abs(made[1].channels[SENSOR].values - expected).max() <= 1e-6 * np.abs(expected).max()
    np.testing.assert_array_equal(made[0].channels[SENSOR].values, simulate_united(runs[:1])[0].channels[SENSOR].values)


@pytest.mark.long
def test_memory_is_used_again_and_by_one_thread() -> None:
    memory = ReusedMemory()
    first = memory.array((2, 3))
    assert np.shares_memory(first, memory.array((6,)))
    assert not np.shares_memory(first, memory.array((7,)))
    runs = [BatchRun.of(rig, SPAN) for rig in RIGS[:2]]
    fresh = simulate_united(runs)
    for one, other in zip(simulate_united(runs, memory=memory.array), fresh, strict=True):
        np.testing.assert_array_equal(one.channels[SENSOR].values, other.channels[SENSOR].values)
        held = memory.array((8 * 6 * SPAN.samples,))
        assert any(np.shares_memory(channel.values, held) for channel in one.channels.values())


@pytest.mark.long
def test_the_one_that_fails_says_so() -> None:
    """A speed loop a thousand times too fast for its sample rate, without a limit of its torque."""
    runs = [BatchRun.of(rig, SPAN) for rig in (RIGS[0], unstable(), RIGS[1])]
    assert united(runs) == [[0, 1, 2]]
    with pytest.raises(SimulationError, match="ceased to be finite"):
        simulate_united(runs)


def unstable() -> Rig:
    rig = machine(lines(6))

    def changed(part: Part) -> Part:
        if isinstance(part, Motor):
            return replace(part, torque_limit=1e300)
        return replace(part, kp=500.0) if isinstance(part, SpeedController) else part

    return replace(rig, parts=tuple(changed(part) for part in rig.parts))
