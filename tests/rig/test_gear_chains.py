"""Gears of any ratio, in series and in branches: kinematics, losses and what is refused."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from torquerig.errors import InputError, UnknownNameError
from torquerig.mechanisms import QuadraticDrag
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.scenario.kinematics import kinematics_of
from torquerig.simulation.simulator import simulate

MOTOR = Motor(name="motor", inertia=1.5e-4, torque_limit=50.0)


def gear(name: str, after: str, ratio: float, *, efficiency: float = 1.0) -> Gear:
    return Gear(
        name=name, after=after, ratio=ratio, stiffness=5000, damping=2.0, output_inertia=1e-3, efficiency=efficiency
    )


def body(after: str, name: str = "wear_part") -> Body:
    return Body(name=name, after=after, inertia=2e-3)


def driven(*parts: Part, speed: float, measured: str) -> Rig:
    return Rig((MOTOR, *parts, SpeedController(name="loop", kp=0.05, ki=1.0)), Run(speed=speed), measured=measured)


@pytest.mark.parametrize("ratio", [5.0, 1.0, 3.572, 0.4, 21.0, -5.0])
@pytest.mark.parametrize("efficiency", [1.0, 0.9])
def test_steady_torque_is_motor_torque_times_ratio_times_efficiency(ratio: float, efficiency: float) -> None:
    """Power flows from the motor: output / motor = N eta at standstill of everything but the steady turning."""
    speed = 40.0
    drag = QuadraticDrag(name="drag", coefficient=2.0 / (speed / ratio) ** 2)  # 2 N m at this speed
    rig = driven(
        gear("gearbox", "motor", ratio, efficiency=efficiency), body("gearbox"), drag, speed=speed, measured="gearbox"
    )
    made = simulate(rig, duration=0.5, seed=1, settling=6.0)
    output, motor = made.torque().mean(), made.channels["true_motor_torque_Nm"].values.mean()
    assert abs(output) == pytest.approx(2.0, rel=1e-2)
    assert output / motor == pytest.approx(ratio * efficiency, rel=1e-3)
    speeds = [made.channels[f"true_{name}_speed_rad_s"].values.mean() for name in ("motor", "output")]
    assert speeds[0] / speeds[1] == pytest.approx(ratio, rel=1e-6)


def test_two_stages_in_series_multiply() -> None:
    drag = QuadraticDrag(name="drag", coefficient=2.0 / 4.0**2)
    rig = driven(
        gear("first", "motor", 4.0, efficiency=0.9), gear("second", "first", 2.5, efficiency=0.8), body("second"), drag,
        speed=40.0, measured="second",
    )  # fmt: skip
    made = simulate(rig, duration=0.5, seed=1, settling=6.0)
    assert made.torque().mean() / made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(
        10 * 0.72, rel=1e-3
    )
    assert rig.speed_ratios("motor") == pytest.approx({"motor": 1, "first": 1 / 4, "second": 1 / 10})
    assert kinematics_of(rig).ratio == 10.0


def test_a_branch_carries_its_own_load_and_its_gear_is_not_in_the_measured_ratio() -> None:
    """Two loads on one motor: 0.5 N m measured behind 5:1, and 0.3 N m on the motor's other end behind 2:1."""
    parts = (
        gear("gearbox", "motor", 5.0), body("gearbox"), QuadraticDrag(name="drag", coefficient=0.5 / 8.0**2),
        gear("side", "motor", 2.0), body("side", "fan"),
        QuadraticDrag(name="fan_drag", at="fan", coefficient=0.3 / 20.0**2),
    )  # fmt: skip
    rig = driven(*parts, speed=40.0, measured="gearbox")
    made = simulate(rig, duration=0.5, seed=1, settling=6.0)
    assert made.torque().mean() == pytest.approx(0.5, rel=1e-3)
    assert made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(0.5 / 5 + 0.3 / 2, rel=1e-3)
    assert kinematics_of(rig).ratio == 5.0
    other = replace(rig, measured="side")
    assert simulate(other, duration=0.2, seed=1, settling=6.0).torque().mean() == pytest.approx(0.3, rel=1e-3)
    assert kinematics_of(other).ratio == 2.0


def test_adding_changing_and_leaving_out_make_new_rigs() -> None:
    rig = driven(gear("gearbox", "motor", 5.0), body("gearbox"), speed=2 * pi, measured="gearbox")
    more = rig + Body(name="flywheel", after="gearbox", inertia=0.1)
    assert len(more.parts) == len(rig.parts) + 1
    assert more.without("flywheel") == rig
    assert more.node("flywheel") == "gearbox"
    assert rig.changed(gear("gearbox", "motor", 3.0)).part("gearbox").ratio == 3.0  # type: ignore[attr-defined]
    assert rig.part("gearbox").ratio == 5.0  # type: ignore[attr-defined]


def test_what_cannot_be_a_rig_is_refused() -> None:
    with pytest.raises(InputError, match="two parts named 'motor'; rename one"):
        Rig((MOTOR, MOTOR))
    with pytest.raises(UnknownNameError, match=r"after: 'gearbx' is no part before it; did you mean 'gearbox'\?"):
        driven(gear("gearbox", "motor", 5.0), body("gearbx"), speed=1.0, measured="gearbox")
    with pytest.raises(UnknownNameError, match="no part 'moter'; did you mean 'motor'"):
        driven(speed=1.0, measured="x").part("moter")
    with pytest.raises(InputError, match="ends on a shaft without inertia; give that part an inertia"):
        driven(Coupling(name="shaft", after="motor", stiffness=1, damping=0), speed=1.0, measured="shaft").terms()
    with pytest.raises(InputError, match="nothing drives it; name the part before it with after:"):
        Rig((Coupling(name="shaft", stiffness=1, damping=0),)).terms()
    with pytest.raises(InputError, match="'gearbox' is no motor; name one"):
        Rig((MOTOR, gear("gearbox", "motor", 5), SpeedController(name="loop", motor="gearbox", kp=1, ki=0))).terms()
