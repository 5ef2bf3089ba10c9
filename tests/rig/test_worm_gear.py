"""Worm gears by Shigley's Mechanical Engineering Design, chapter 13: efficiency both ways, self-locking."""

from __future__ import annotations

from math import atan, cos, pi, radians, sin, tan
from pathlib import Path
from typing import Any

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.mechanisms import ParticleLoad, QuadraticDrag
from torquerig.orders.kinematics.worm import Worm
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.drive_train import drive_train
from torquerig.rig.parts import Body, Motor, SpeedController, TorqueController, WormGear
from torquerig.rig.terms import Spring
from torquerig.scenario.kinematics import kinematics_of, torque_gain
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

MOTOR = Motor(name="motor", inertia=1.5e-4, torque_limit=50.0)


def worm(**changed: Any) -> WormGear:
    stated: dict[str, Any] = {
        "name": "worm", "after": "motor", "starts": 2, "wheel_teeth": 60, "lead_angle": radians(10.0), "friction": 0.05,
        "stiffness": 5000.0, "damping": 2.0, "worm_inertia": 1e-5, "wheel_inertia": 2e-3,
    }  # fmt: skip
    return WormGear(**{**stated, **changed})


def rig_of(gear: Part, *parts: Part, speed: float = 60.0) -> Rig:
    drum = Body(name="wear_part", after="worm", inertia=2e-3)
    return Rig((MOTOR, gear, drum, *parts, SpeedController(name="loop", kp=0.05, ki=1.0)), Run(speed=speed),
               measured="worm")  # fmt: skip


@pytest.mark.parametrize("friction", [0.0, 0.03, 0.1])
@pytest.mark.parametrize("lead", [4.0, 10.0, 25.0])
def test_efficiencies_are_those_of_the_forces_on_the_thread(friction: float, lead: float) -> None:
    """Shigley eq. 13-46: (cos a - f tan l) / (cos a + f cot l); backward the friction changes its sign."""
    gear, a, angle = worm(friction=friction, lead_angle=radians(lead)), pi / 9, radians(lead)
    forward = (cos(a) - friction * tan(angle)) / (cos(a) + friction / tan(angle))
    backward = (cos(a) * tan(angle) - friction) / (tan(angle) * (cos(a) + friction * tan(angle)))
    assert gear.efficiency == pytest.approx(forward, rel=1e-12)
    assert gear.backward_efficiency == pytest.approx(backward, rel=1e-12)
    assert gear.is_self_locking == (backward <= 0)
    work = sin(angle) / cos(angle)
    assert gear.is_self_locking == (work <= friction / cos(a))


def test_a_stated_efficiency_gives_the_friction_and_the_size_gives_the_lead_angle() -> None:
    by_friction = worm()
    by_efficiency = worm(friction=None, forward_efficiency=by_friction.efficiency)
    assert by_efficiency.backward_efficiency == pytest.approx(by_friction.backward_efficiency, rel=1e-12)
    by_size = worm(lead_angle=None, module=2e-3, worm_diameter=36e-3)
    assert by_size.lead == pytest.approx(atan(2 * 2 / 36), rel=1e-12)


@pytest.mark.parametrize("reverses", [False, True])
def test_a_worm_transmits_by_its_ratio_and_its_forward_efficiency(reverses: bool) -> None:
    drag = QuadraticDrag(name="drag", coefficient=2.0 / 2.0**2)
    rig = rig_of(worm(reverses=reverses), drag)
    made = simulate(rig, duration=0.3, seed=1, settling=6.0)
    gain = made.torque().mean() / made.channels["true_motor_torque_Nm"].values.mean()
    assert gain == pytest.approx((-1 if reverses else 1) * 30 * worm().efficiency, rel=1e-3)
    assert torque_gain(rig) == pytest.approx(30 * worm().efficiency)
    assert kinematics_of(rig).ratio == 30
    mesh = [line for line in kinematics_of(rig).lines(1) if line.family == "gear_mesh"]
    assert [(line.motor_order, line.output_order) for line in mesh] == [(2.0, 60.0)]


@pytest.mark.parametrize("lead", [12.0, 3.0])
def test_a_load_that_drives_back_counts_by_the_backward_efficiency(lead: float) -> None:
    """A drive that brakes: the motor gives T eta_b / N; where the worm locks, it must push the load down."""
    gear = worm(lead_angle=radians(lead), friction=0.08)
    assert gear.is_self_locking == (lead < 4.9)
    pull = ParticleLoad(name="load", mean_by_occupancy_percent={0.0: -3.0}, hit_rms=0.0, slow_rms=0.0)
    expected = -3.0 * gear.backward_efficiency / 30
    assert drive_train(rig_of(gear, pull), "motor").steady_torque(60.0) == pytest.approx(expected, rel=1e-9)
    pusher = Motor(name="pusher", after="worm", inertia=1e-3, torque_limit=5.0)
    rig = rig_of(gear, pusher)
    made = simulate(rig + TorqueController(name="push", motor="pusher", torque=3.0), duration=0.3, seed=1, settling=6.0)
    assert made.torque().mean() == pytest.approx(-3.0, rel=1e-3)
    assert made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(expected, rel=5e-3)


def test_a_motor_at_the_wheel_cannot_turn_a_worm_that_locks_and_says_so() -> None:
    rig = Rig(
        (
            Body(name="fan", inertia=1e-4, viscous=1e-3),
            worm(after="fan", lead_angle=radians(3.0), friction=0.1),
            Motor(name="motor", after="worm", inertia=1.5e-4, torque_limit=50.0),
            SpeedController(name="loop", kp=0.05, ki=1.0),
        ),
        Run(speed=5.0), measured="worm",
    )  # fmt: skip
    with pytest.raises(InputError, match="a self-locking worm_gear would be driven from its wheel"):
        drive_train(rig, rig.node("motor")).steady_torque(5.0)


def test_a_spring_without_a_backward_efficiency_loses_the_same_both_ways() -> None:
    assert Spring(name="s", a="a", b="b", stiffness=1.0, damping=0.0, efficiency=0.9).backwards == 0.9


STATED = "starts: 2, wheel_teeth: 60, stiffness: 5 kN*m/rad, damping: 2 N*m*s/rad, wheel_inertia: 10 kg*cm^2"


@pytest.mark.parametrize(
    ("gear", "told"),
    [
        (f"{{kind: worm_gear, {STATED}, friction: 0.05}}", "needs either lead_angle, such as 5 deg, or module and"),
        (f"{{kind: worm_gear, {STATED}, lead_angle: 5 deg, module: 2 mm, friction: 0.05}}", "needs either lead_angle"),
        (f"{{kind: worm_gear, {STATED}, lead_angle: 5 deg}}", "needs either friction, such as 0.05, or forward_eff"),
        (f"{{kind: worm_gear, {STATED}, lead_angle: 95 deg, friction: 0.05}}", "are less than 90 degrees"),
        (f"{{kind: worm_gear, {STATED.replace('starts: 2', 'starts: 0')}, lead_angle: 5 deg, friction: 0.05}}",
         "a worm of 0 starts on a wheel of 60 teeth does not exist; write 1 to 12 starts"),
    ],
)  # fmt: skip
def test_worms_that_cannot_be_are_refused_with_their_place(gear: str, told: str) -> None:
    motor = "motor: {kind: motor, inertia: 1 kg*cm^2, torque_limit: 1 N*m}"
    text = f"measured: gearbox\nrig:\n  {motor}\n  gearbox: {gear}\n"
    with pytest.raises(InputError, match=told) as refused:
        read_scenario(parse_document(text, Path("bench.yaml")), load_catalog(shipped_folder()), seed=1)
    assert str(refused.value).startswith("bench.yaml:4: rig.gearbox")


def test_a_worm_in_words() -> None:
    assert Worm(1, 40).spoken == "worm of 1 start on a wheel of 40 teeth"
