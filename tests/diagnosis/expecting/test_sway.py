"""How a slow line sways the motor's angle, and what that puts beside a fast one: the simulator beside first order."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.expecting.sway import Sway
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import observed
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.inference.places import order
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate

SLOW, FAST, SPEED = 6.0, 36.0, 500 * pi / 30
SIDES = (FAST - SLOW, FAST + SLOW)


def rig_of(scenario: Scenario, *, slow: float, at: float = SLOW) -> Rig:
    """A motor with torque of order 36, 0.1 N m, and of a slow order; no load."""
    rig = scenario.rig
    for ripple in rig.parts_of(TorqueRipple):
        own = {at: slow, FAST: 0.1} if ripple.name == "motor.mechanical" else {}
        rig = rig.changed(replace(ripple, amplitudes=own))
    return rig.at(replace(rig.run, speed=SPEED, occupancy_percent=0.0, profile="steady"))


def looked(rig: Rig, *, measured: bool) -> Features:
    """A run of the rig along its true angle, or along one that turns evenly."""
    made: Recording = simulate(rig, duration=12.0, seed=2, sample_rate=10_000.0)
    true = made.channels["true_motor_angle_rad"].values
    angle = true if measured else np.polyval(np.polyfit(np.arange(true.size), true, 1), np.arange(true.size))
    run = observed(made, ShaftAngle(angle, measured=measured, origin="test"), ratio=5.0)
    return features(run, [order(at) for at in (SLOW, *SIDES, FAST)], held=None)


def swayed(rig: Rig, seen: Features) -> Sway:
    """How the rig's lines sway its motor in the run."""
    twin, speed = Twin(rig), seen.speed.mean(axis=1)
    motor = quasi_static(twin, speed=speed, acceleration=seen.acceleration).motor
    return Sway(twin, seen, turns=np.abs(speed) / (2 * pi), motor=motor)


def moving(seen: Features) -> Features:
    """The same as of a run whose angle within a turn is not followed."""
    recording = seen.observed.recording
    return replace(
        seen,
        observed=replace(seen.observed, recording=replace(recording, run=replace(recording.run, profile="ramp"))),
    )


def told(rig: Rig, seen: Features) -> dict[float, float]:
    """Size of each side line [N m], mean over the stretches."""
    fast = seen.places.index(order(FAST))
    model, sway = expected(rig, seen), swayed(rig, seen)
    sizes = np.array([model.amplitude[:, seen.places.index(order(line.order))] for line in Twin(rig).lines()])
    assert model.amplitude[:, fast].mean() == pytest.approx(np.abs(seen.amplitude[:, fast]).mean(), rel=0.05)
    orders, beside = sway.beside(sizes, model.power)
    each = zip(orders.round(6).tolist(), beside, strict=True)
    return {at: float(size.mean()) for at, size in each if at in SIDES}


@pytest.mark.long
@pytest.mark.parametrize("slow", [0.03, 0.06, 0.12])
def test_a_line_loses_what_the_slow_one_takes_from_its_phase(slow: float, wear_rig: Scenario) -> None:
    """Bessel's J0, from a twentieth to most of it; whole along an angle that was measured or followed within a turn."""
    rig = rig_of(wear_rig, slow=slow, at=1.0)
    shown = {}
    for measured in (True, False):
        seen = looked(rig, measured=measured)
        column = seen.places.index(order(FAST))
        shown[measured] = float(np.abs(seen.amplitude[:, column]).mean())
        assert np.all(swayed(rig, seen).left == 1.0)
        left = swayed(rig, moving(seen)).left[[line.order for line in Twin(rig).lines()].index(FAST)]
        assert shown[True] == pytest.approx(expected(rig, seen).amplitude[:, column].mean(), rel=0.05)
    assert shown[False] / shown[True] == pytest.approx(left.mean(), abs=0.1 * (1 - left.mean()))
    assert np.all(swayed(rig, moving(looked(rig, measured=True))).left == 1.0)


@pytest.mark.parametrize("measured", [False, True])
def test_a_slow_line_gives_a_fast_one_side_lines(measured: bool, wear_rig: Scenario) -> None:
    """Along an angle that was measured, what the shafts pass otherwise at 30 and 42 than at 36 is left."""
    rig = rig_of(wear_rig, slow=0.05)
    seen = looked(rig, measured=measured)
    sizes = told(rig, seen)
    assert set(sizes) == {*SIDES}
    for side in SIDES:
        shown = float(np.abs(seen.amplitude[:, seen.places.index(order(side))]).mean())
        assert shown == pytest.approx(sizes[side], rel=0.15), side


def test_side_lines_are_a_doubt_and_no_lines(wear_rig: Scenario) -> None:
    """A rig without the slow line has none; with it they stand in the tolerance of their places."""
    with_it, without = (rig_of(wear_rig, slow=slow) for slow in (0.05, 0.0))
    seen = looked(with_it, measured=False)
    assert told(without, seen) == {}
    columns = [seen.places.index(order(side)) for side in SIDES]
    model, bare = expected(with_it, seen), expected(without, seen)
    assert np.all(model.amplitude[:, columns] == 0.0)
    assert np.all(np.broadcast_to(bare.amplitude_tolerance, model.amplitude.shape)[:, columns] == 0.0)
    doubt = np.broadcast_to(model.amplitude_tolerance, model.amplitude.shape)[:, columns].mean(axis=0)
    assert doubt == pytest.approx([told(with_it, seen)[side] for side in SIDES], rel=1e-6)


def test_side_lines_where_nothing_was_asked_for_are_in_their_band(wear_rig: Scenario) -> None:
    """Their power over the width of the band, and that band's density in doubt."""
    rig = rig_of(wear_rig, slow=0.05)
    seen = looked(rig, measured=False)
    asked = features(seen.observed, [order(SLOW), order(FAST)], held=None)
    model, bare = expected(rig, asked), expected(rig_of(wear_rig, slow=0.0), asked)
    beyond = (model.power - bare.power) * asked.width
    assert beyond.sum() == pytest.approx(0.5 * sum(size**2 for size in told(rig, seen).values()), rel=0.1)
    bands = beyond > 1e-3 * beyond.max()
    assert np.flatnonzero(bands).size == 2
    share = (beyond / asked.width / model.power)[bands]
    assert np.broadcast_to(model.power_tolerance, beyond.shape)[bands] == pytest.approx(share, rel=0.05)
