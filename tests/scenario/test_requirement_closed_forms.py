"""The required torque of a stated load by hand: constant, trapezoid and S3, with and without a part that takes it."""

from __future__ import annotations

from math import sqrt

import pytest

from torquerig.errors import InputError
from torquerig.mechanisms import ParticleLoad
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear, Motor, SpeedController
from torquerig.scenario.drive_requirement import drive_requirement

RATIO, EFFICIENCY, SPEED = 5.0, 0.9, 100.0
ROTOR, WHEEL = 1e-4, 2e-3
INERTIA = ROTOR + WHEEL / RATIO**2 / EFFICIENCY  # while it accelerates


def rig(*, time: tuple[float, ...], speed: tuple[float, ...], load: tuple[float, ...], mean: float | None,
        held: bool = True) -> Rig:  # fmt: skip
    """Return a motor, a gear and a wheel; ``mean`` is that of its load, None without one."""
    loads: tuple[Part, ...] = ()
    if mean is not None:
        loads = (
            ParticleLoad(name="load", at="wheel", mean_by_occupancy_percent={0.0: mean}, hit_rms=0.0, slow_rms=0.0),
        )
    parts = (
        Motor(name="motor", inertia=ROTOR, torque_limit=50.0),
        Gear(name="gearbox", after="motor", ratio=RATIO, stiffness=1000.0, damping=1.0, efficiency=EFFICIENCY),
        Body(name="wheel", after="gearbox", inertia=WHEEL),
        SpeedController(name="loop", kp=0.05, ki=1.0),
        *loads,
    )
    rows = Breakpoints(time=time, speed=speed, load=load, held=(held,) * len(time))
    run = Run(speed=SPEED, profile="csv", set_points=Tabulated(rows=rows, repeats=None), occupancy_percent=0.0)
    return Rig(parts, run, measured="gearbox")


LOADED = pytest.mark.parametrize("mean", [None, 0.0, 0.7, 4.0])


@LOADED
def test_a_constant_torque_acts_at_the_output(mean: float | None) -> None:
    made = drive_requirement(rig(time=(0.0, 1.0), speed=(SPEED, SPEED), load=(2.0, 2.0), mean=mean), duration=1.0)
    assert made.rms_torque == pytest.approx(2.0 / RATIO / EFFICIENCY, rel=1e-3)


@LOADED
def test_a_trapezoid_of_speed_under_a_constant_torque(mean: float | None) -> None:
    course = {"time": (0.0, 0.2, 0.8, 1.0), "speed": (0.0, SPEED, SPEED, 0.0), "load": (2.0, 2.0, 2.0, 2.0)}
    made = drive_requirement(rig(**course, mean=mean), duration=1.0)
    acceleration = SPEED / 0.2
    steady, up = 2.0 / RATIO / EFFICIENCY, 2.0 / RATIO / EFFICIENCY + INERTIA * acceleration
    # while braking the wheel's torque and the load cancel before they pass the gear
    at_gear = 2.0 / RATIO - WHEEL / RATIO**2 * acceleration
    down = (at_gear / EFFICIENCY if at_gear > 0 else at_gear * EFFICIENCY) - ROTOR * acceleration
    rms = sqrt(0.2 * up**2 + 0.6 * steady**2 + 0.2 * down**2)
    assert made.rms_torque == pytest.approx(rms, rel=1e-3)


@LOADED
def test_intermittent_duty_counts_its_load_for_its_share_of_the_time(mean: float | None) -> None:
    course = {"time": (0.0, 0.4, 0.4, 1.0), "speed": (SPEED,) * 4, "load": (3.0, 3.0, 0.0, 0.0)}
    made = drive_requirement(rig(**course, mean=mean), duration=1.0)
    assert made.rms_torque == pytest.approx(sqrt(0.4) * 3.0 / RATIO / EFFICIENCY, rel=1e-3)


@LOADED
@pytest.mark.parametrize("held", [True, False])
def test_a_stated_torque_is_held_at_rest(mean: float | None, held: bool) -> None:
    course = {"time": (0.0, 0.4, 0.4, 1.0), "speed": (SPEED, SPEED, 0.0, 0.0), "load": (0.0, 0.0, 3.0, 3.0)}
    made = drive_requirement(rig(**course, mean=mean, held=held), duration=1.0)
    at_rest = (~made.step) & (made.speed == 0).all(axis=1)
    assert made.torque[at_rest] == pytest.approx(3.0 / RATIO / EFFICIENCY if held else 0.0, rel=1e-3)
    assert made.duration[at_rest].sum() == pytest.approx(0.6, abs=0.01)  # the stop takes 4 ms of it


def test_a_train_with_two_ends_asks_where_the_load_acts() -> None:
    made = rig(time=(0.0, 1.0), speed=(SPEED, SPEED), load=(2.0, 2.0), mean=None)
    second = Gear(name="second", after="motor", ratio=2.0, stiffness=1000.0, damping=1.0)
    branched = Rig((*made.parts, second, Body(name="fan", after="second", inertia=1e-3)), made.run, measured="gearbox")
    with pytest.raises(InputError, match=r"no part says at which of .* it acts; add a particle_load"):
        drive_requirement(branched, duration=1.0)
