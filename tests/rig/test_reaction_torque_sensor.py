"""The reaction torque at the foot of a motor: what the shaft takes and ``J dw/dt``, friction of the motor not in it."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.mechanisms import Imbalance, LugreFriction, QuadraticDrag, StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.drive_train import drive_train
from torquerig.rig.parts import (
    Body,
    Coupling,
    Motor,
    Probe,
    ReactionTorqueSensor,
    SpeedController,
    TorqueController,
)
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import twin_of

ROTOR, HOUSING, RATE = 2e-4, 3e-3, 20_000.0  # [kg m^2], [kg m^2], [Hz]
READ = "true_sensor_torque_Nm"


def bench(*more: Part, stiffness: float = 3e4, measured: str = "foot", **run: Any) -> Rig:
    motor = Motor(name="motor", inertia=ROTOR, viscous=2e-4, coulomb=0.05, torque_limit=5.0)
    foot = ReactionTorqueSensor(
        name="foot", stiffness=stiffness, damping=0.05, housing_inertia=HOUSING, bandwidth=2000.0
    )
    bar = Coupling(name="bar", after="motor", stiffness=600.0, damping=0.02, inertia=1e-4)
    wheel = Body(name="wheel", after="bar", inertia=2e-3, viscous=0.01)
    loop = SpeedController(name="loop", kp=0.05, ki=0.5)
    return Rig((motor, foot, bar, wheel, loop, *more), Run(speed=40.0, **run), measured=measured)


def cogging(amplitude: float, order: float = 12.0) -> TorqueRipple:
    return TorqueRipple(name="cogging", at="motor", group="cogging", amplitudes={order: amplitude})


def test_at_a_steady_speed_it_reads_the_torque_in_the_shaft_and_not_the_motor_s_friction() -> None:
    """0.01 N m s/rad x 40 rad/s on the wheel; the drive gives 0.05 + 2e-4 x 40 more for its own friction."""
    made = simulate(bench(Probe(name="shaft", quantity="torque", at="bar")), duration=0.2, seed=1, settling=4.0)
    assert made.channels[READ].values.mean() == pytest.approx(0.4, rel=2e-3)
    assert made.channels["shaft_Nm"].values.mean() == pytest.approx(0.4, rel=2e-3)
    assert made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(0.458, rel=2e-3)


@pytest.mark.parametrize("friction", [StribeckFriction, LugreFriction])
def test_it_reads_shaft_torque_rotor_and_housing_at_every_instant(friction: type[Part]) -> None:
    """``T = T_shaft + J dw/dt + J_h d(w_h)/dt`` with ripple, cogging and friction on, through a reversal."""
    within = {"coulomb": 0.1, "static": 0.15, "stribeck_speed": 2.0}
    if friction is LugreFriction:
        within |= {"stiffness": 200.0, "damping": 0.05}
    rig = bench(
        cogging(0.05), friction(name="brushes", at="motor", **within),
        *(Probe(name=f"{at}_acceleration", quantity="acceleration", at=at) for at in ("motor", "foot")),
        Probe(name="shaft", quantity="torque", at="bar"), profile="reversal",
    )  # fmt: skip
    made = simulate(rig, duration=1.0, seed=1, settling=0.5, sample_rate=RATE).channels
    rotor, housing = (made[f"{at}_acceleration_rad_s2"].values for at in ("motor", "foot"))
    expected = made["shaft_Nm"].values + ROTOR * rotor + HOUSING * housing
    kept = slice(50, -50)  # the ends of a spline's derivative
    read = made[READ].values[kept]
    assert np.sqrt(np.mean((read - expected[kept]) ** 2)) < 2e-3 * read.std()


def test_outside_torques_at_the_motor_are_read_as_those_of_a_load() -> None:
    """A drag of air of 1e-4 x 40^2 and an imbalance act on the rotor from outside: the drive holds them by its foot."""
    outside = (
        QuadraticDrag(name="fan", at="motor", coefficient=1e-4),
        Imbalance(name="heavy", at="motor", mass=1.0, eccentricity=1e-4),
    )
    made = simulate(bench(*outside), duration=2 * pi / 40, seed=1, settling=4.0)
    assert made.channels[READ].values.mean() == pytest.approx(0.4 + 0.16, rel=2e-3)


@pytest.mark.parametrize("stiffness", [2e3, 1e5])
def test_cogging_reaches_it_through_the_housing_s_own_mode(stiffness: float) -> None:
    """``T / A = (k + i w c) / (k - J_h w^2 + i w c)`` at 12 x 40 rad/s; the mode is at 130 and 920 Hz."""
    amplitude, w = 0.01, 12 * 40.0
    rig = bench(cogging(amplitude), stiffness=stiffness)
    made = simulate(rig, duration=1.0, seed=1, settling=3.0, sample_rate=RATE)
    turned = 12 * made.channels["true_motor_angle_rad"].values
    columns = np.column_stack([np.cos(turned), np.sin(turned), np.ones(turned.size)])
    cosine, sine, _ = np.linalg.lstsq(columns, made.channels[READ].values, rcond=None)[0]
    through = (stiffness + 0.05j * w) / (stiffness - HOUSING * w**2 + 0.05j * w)
    assert np.hypot(cosine, sine) == pytest.approx(amplitude * abs(through), rel=5e-3)


def test_the_linear_model_has_the_same_line_and_the_mode() -> None:
    """At its mode it lifts a line by ``sqrt(k J_h) / (c + kp)``: the loop's encoder, in the housing, damps it.

    The lag of the current (500 Hz) leaves 2 per cent.
    """
    twin = twin_of(bench(cogging(0.01), stiffness=2e3))
    natural = (2e3 / HOUSING) ** 0.5
    mode = min(twin.modes(), key=lambda one: abs(one.damped - natural / (2 * pi)))
    assert mode.undamped == pytest.approx(natural / (2 * pi), rel=1e-3)
    lines = [line for line in twin.order_lines() if line.cause == "cogging"]
    (crossing,) = [one for one in twin.crossings(lines, top_speed=100.0) if abs(one.frequency - mode.damped) < 1e-6]
    assert crossing.gain == pytest.approx((2e3 * HOUSING) ** 0.5 / (0.05 + 0.05), rel=3e-2)


def test_a_stiff_sensor_leaves_the_shafts_as_they_are_without_it() -> None:
    with_foot = bench(cogging(0.05), measured="bar", stiffness=1e6)
    one = simulate(with_foot, duration=0.2, seed=1, settling=1.0).channels[READ].values
    other = simulate(with_foot.without("foot"), duration=0.2, seed=1, settling=1.0).channels[READ].values
    assert np.abs(one - other).max() < 2e-3 * other.std()


def test_the_needed_torque_of_the_drive_does_not_depend_on_the_sensor() -> None:
    rig = bench()
    assert drive_train(rig, "motor").steady_torque(40.0) == drive_train(rig.without("foot"), "motor").steady_torque(40)
    assert kinematics_of(rig).ratio == 1.0


SCENARIO = """
measured: {measured}
rig:
  motor: {{kind: motor, inertia: 2 kg*cm^2, coulomb: 0.05 N*m, torque_limit: 5 N*m}}
  foot: {{kind: reaction_torque_sensor, stiffness: 30 kN*m/rad, damping: 0.05 N*m*s/rad,
         housing_inertia: 30 kg*cm^2, sensitivity: 2 V/(N*m), bandwidth: 1 kHz{more}}}
  shaft_sensor: {{kind: torque_sensor, stiffness: 600 N*m/rad, damping: 0.02 N*m*s/rad, inertia: 1 kg*cm^2,
                 bandwidth: 1 kHz}}
  wheel: {{kind: body, inertia: 20 kg*cm^2, viscous: 0.01 N*m*s/rad}}
  loop: {{kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}}
operating_point: {{motor_speed: 40 rad/s}}
"""


def scenario(measured: str, more: str = "") -> Rig:
    document = parse_document(SCENARIO.format(measured=measured, more=more), Path("bench.yaml"))
    return read_scenario(document, load_catalog(shipped_folder()), seed=1).rig


def test_a_scenario_measures_at_the_foot_and_in_the_shaft() -> None:
    rig = scenario("[foot, shaft_sensor]", ", mounting: reversed")
    assert rig.places == ("foot", "shaft_sensor")
    assert rig.part("shaft_sensor").after == "motor"  # the foot is not in the shaft
    made = simulate(rig, duration=0.1, seed=1, settling=3.0).channels
    assert made["foot_V"].values.mean() == pytest.approx(-2 * 0.4, rel=1e-2)
    assert made["foot_V"].in_si().mean() == pytest.approx(made["shaft_sensor_V"].in_si().mean(), rel=1e-2)
    assert made["foot_V"].role == "compared"


def test_a_foot_of_no_motor_or_of_one_that_is_held_already_is_refused() -> None:
    with pytest.raises(InputError, match="foot: motor: 'wheel' is no motor; name one"):
        scenario("foot", ", motor: wheel").terms()
    second = ReactionTorqueSensor(name="more", stiffness=1.0, damping=0.0, housing_inertia=1.0, bandwidth=1e3)
    with pytest.raises(InputError, match="more: foot holds the housing of 'motor' already; leave one out"):
        bench(second).terms()


def test_a_motor_in_torque_mode_reacts_too() -> None:
    rig = bench().without("loop") + TorqueController(name="push", motor="motor", torque=0.458)
    made = simulate(rig, duration=0.2, seed=1, settling=0.5)
    assert made.channels[READ].values.mean() == pytest.approx(0.4, rel=2e-2)
