"""The integrator against closed forms, published numbers and the linear twin."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.mechanisms import Backlash, GearMesh, TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.rig.terms import AppliedTorque, Term
from torquerig.simulation.linear import matrices, spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate


@dataclass(frozen=True)
class Constant:
    """One torque for all time."""

    mean: float

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.full(count, self.mean)


@dataclass(frozen=True, kw_only=True)
class Push(Part):
    """A torque from outside on the shaft of ``at``."""

    at: str
    torque: float

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=Constant(self.torque)),)


def two_masses(*, gap: float = 0.0) -> Rig:
    first = Body(name="first", inertia=0.005)
    if gap:
        spring: Part = Gear(name="shaft", after="first", ratio=1, stiffness=700, damping=0.01, backlash=gap)
    else:
        spring = Coupling(name="shaft", after="first", stiffness=700, damping=0.01)
    second = Body(name="second", after="shaft", inertia=0.005)
    return Rig((first, spring, second, Push(name="push", at="first", torque=1.0)), measured="shaft")


def test_two_masses_reach_the_matrix_exponential_of_the_simulator_survey_6_3() -> None:
    """1 N m on J1, from rest, at 1 s: w1 100.025004197, w2 99.974995803, shaft torque 0.486019685."""
    made = simulate(two_masses(), duration=1.00004, seed=0, settling=0.0, substeps=4)
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(0.486019685, abs=2e-7)
    assert made.channels["true_output_speed_rad_s"].values[-1] == pytest.approx(99.974995803, abs=2e-8)


@pytest.mark.parametrize("substeps", [1, 4])
def test_backlash_contacts_of_the_simulator_survey_6_3_are_located(substeps: int) -> None:
    """Full gap 0.004 rad: torque 0.6791051 after 47 contacts; plain RK4 at 40 us gives 0.6801290."""
    made = simulate(two_masses(gap=0.004), duration=1.00004, seed=0, settling=0.0, substeps=substeps)
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(0.6791051, abs=1e-6)
    assert made.channels["true_motor_speed_rad_s"].values[-1] == pytest.approx(100.0591814, abs=1e-6)


def test_runge_kutta_converges_with_the_fourth_power() -> None:
    exact = 0.486019685
    errors = []
    for rate in (1000.0, 2000.0):
        made = simulate(two_masses(), duration=1 + 1 / rate, seed=0, settling=0.0, sample_rate=rate, substeps=1)
        errors.append(abs(made.channels["true_sensor_torque_Nm"].values[-1] - exact))
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.5)


@pytest.mark.parametrize(
    ("inertias", "stiffnesses", "expected"),
    [
        ((211.4, 8.3), (9.775e6,), (0, 176.1)),
        ((3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05), (12e3, 12e3, 14e3, 10e3), (0, 81.21, 141.21, 378.95, 536.36)),
        ((1e7, 5770, 97030), (3.67e8, 5.496e9), (0, 9.28513, 164.58447)),
        ((0.005, 0.005), (700,), (0, 84.217)),
    ],
    ids=["two-mass", "Friswell 9.7.1", "wind turbine 10.1109/TIE.2010.2087301", "motulator 2-mass"],
)
def test_published_eigenfrequencies(
    inertias: tuple[float, ...], stiffnesses: tuple[float, ...], expected: tuple[float, ...]
) -> None:
    parts: list[Part] = [Body(name="j0", inertia=inertias[0])]
    for row, (stiffness, inertia) in enumerate(zip(stiffnesses, inertias[1:], strict=True), start=1):
        parts += [
            Coupling(name=f"k{row}", after=parts[-1].name, stiffness=stiffness, damping=0.0),
            Body(name=f"j{row}", after=f"k{row}", inertia=inertia),
        ]
    found = matrices(lower(Rig(tuple(parts), measured="k1"), 0)).undamped_frequencies()
    assert found == pytest.approx(expected, rel=2e-4)  # four printed digits


def test_friswell_geared_branch() -> None:
    """Friswell's geared branch (case E): motor 400e-6, gears 25e-6, discs 700e-6; 0, 425.4, 634.1, 3247.2 Hz."""
    rig = Rig(
        (
            Body(name="motor", inertia=400e-6),
            Coupling(name="motor_shaft", after="motor", stiffness=1e4, damping=0.0),
            # both gears, 1:1 and in one rigid mesh: one node
            Body(name="gears", after="motor_shaft", inertia=50e-6),
            Coupling(name="right", after="motor_shaft", stiffness=5e3, damping=0.0),
            Body(name="disc_right", after="right", inertia=700e-6),
            Coupling(name="left", after="motor_shaft", stiffness=5e3, damping=0.0),
            Body(name="disc_left", after="left", inertia=700e-6),
        ),
        measured="motor_shaft",
    )
    found = matrices(lower(rig, 0)).undamped_frequencies()
    assert found[0] == 0.0
    assert found[1:] == pytest.approx((425.4, 634.1, 3247.2), rel=2e-4)


def driven(*effects: Part, ratio: float = 5.0, speed_rpm: float = 600.0) -> Rig:
    """A motor that a very weak loop holds at speed: nearly open loop for ripple."""
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=ratio, stiffness=11300, damping=2.0, output_inertia=7e-4),
            Coupling(name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5),
            Coupling(name="coupling", after="sensor", stiffness=6500, damping=0.4),
            Body(name="wear_part", after="coupling", inertia=2e-3),
            SpeedController(name="controller", kp=1e-6, ki=0.0),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


def line(made: Recording, motor_order: float) -> float:
    """Amplitude of the sensor's line at a motor order, by least squares on the true angle."""
    angle = motor_order * made.channels["true_motor_angle_rad"].values
    columns = np.column_stack([np.ones(angle.size), np.cos(angle), np.sin(angle)])
    found = np.linalg.lstsq(columns, made.channels["true_sensor_torque_Nm"].values, rcond=None)[0]
    return float(np.hypot(found[1], found[2]))


@pytest.mark.parametrize("speed_rpm", [600.0, 900.0])
def test_motor_ripple_reaches_the_sensor_as_the_linear_twin_says(speed_rpm: float) -> None:
    """Open loop, order 14 of the motor, 0.01 N m: |line| is amplitude times the transfer at 14 f_m."""
    rig = driven(
        TorqueRipple(name="ripple", at="motor", group="electrical", amplitudes={14: 0.01}), speed_rpm=speed_rpm
    )
    made = simulate(rig, duration=1.0, seed=3)
    frequency = 14 * made.channels["true_motor_speed_rad_s"].values.mean() / (2 * pi)
    found = line(made, 14)
    expected = abs(spring_response(lower(rig, 3), "sensor", np.array([frequency]))["motor"][0]) * 0.01
    assert found == pytest.approx(expected, rel=2e-3)


def test_motor_ripple_below_the_mode_follows_the_handbook_section_0() -> None:
    """T_s = G(s) J2/(J1+J2) N T_motor: two masses, series stiffness, at a third of the mode."""
    rig = driven(TorqueRipple(name="ripple", at="motor", group="mechanical", amplitudes={4: 0.01}), speed_rpm=600.0)
    found = line(simulate(rig, duration=1.0, seed=3), 4)
    J1, J2 = 25 * 1.5e-4 + 7e-4, 2e-3 + 4e-5
    k = 1 / (1 / 1100 + 1 / 6500)  # the gear spring lies inside J1, the coupling's in series with the sensor
    w0 = sqrt(k * (J1 + J2) / (J1 * J2))
    expected = 5 * 0.01 * J2 / (J1 + J2) / abs(1 - (2 * pi * 40 / w0) ** 2)
    assert found == pytest.approx(expected, rel=0.03)  # three masses against two


@pytest.mark.parametrize("speed_rpm", [1000.0, 600.0])
def test_planetary_mesh_with_ring_84_stands_at_84_output_turns(speed_rpm: float) -> None:
    """Sun 21, ring 84: 280.000 Hz at 1000 rpm of the sun (report audit C), 168 Hz at 600 rpm (ZLS160)."""
    rig = driven(GearMesh(name="mesh", order_output=84, transmission_error=(5e-5,)), speed_rpm=speed_rpm)
    made = simulate(rig, duration=3.0, seed=1)
    values = made.channels["true_sensor_torque_Nm"].values
    levels = np.abs(np.fft.rfft((values - values.mean()) * np.hanning(values.size)))
    assert np.argmax(levels) / 3.0 == pytest.approx({1000.0: 280.0, 600.0: 168.0}[speed_rpm], abs=0.4)


def test_mesh_torque_agrees_with_the_linear_twin() -> None:
    """A kinematic error e in the gear's spring is the torque pair (k + c s) e on its two sides."""
    rig = driven(GearMesh(name="mesh", order_output=84, transmission_error=(5e-5,)), speed_rpm=600.0)
    found = line(simulate(rig, duration=1.0, seed=1), 16.8)
    response = spring_response(lower(rig, 1), "sensor", np.array([168.0]))
    pair = response["gearbox"][0] - response["motor"][0] / 5
    assert found == pytest.approx(abs(pair * (11300 + 2.0 * 2j * pi * 168.0)) * 5e-5, rel=5e-3)


def test_momentum_is_conserved_without_friction() -> None:
    """Sum of J w over all nodes, each turned to the first shaft, changes by the impulse of the push alone."""
    made = simulate(two_masses(gap=0.004), duration=0.5, seed=0, settling=0.0)
    first = made.channels["true_motor_speed_rad_s"].values
    second = made.channels["true_output_speed_rad_s"].values
    assert 0.005 * (first + second) == pytest.approx(made.time() * 1.0, abs=1e-9)


def test_effects_of_zero_amplitude_change_nothing() -> None:
    sounding = TorqueRipple(name="lines", at="motor", group="mechanical", amplitudes={1: 0.01, 4: 0.003})
    plain = simulate(driven(sounding), duration=0.2, seed=5)
    nothing = simulate(
        driven(
            sounding,
            TorqueRipple(name="odd", at="motor", group="mechanical", amplitudes={1.3: 0.0}),
            TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 0.0}),
            GearMesh(name="mesh", order_output=84, transmission_error=(0.0,)),
            Backlash(name="gap", gap=0.0),
        ),
        duration=0.2,
        seed=5,
    )
    for name, channel in plain.channels.items():
        assert np.array_equal(channel.values, nothing.channels[name].values), name


def test_same_seed_same_numbers_other_seed_others() -> None:
    rig = driven(TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 0.01}))
    first, second, third = (simulate(rig, duration=0.1, seed=seed).torque() for seed in (1, 1, 2))
    assert np.array_equal(first, second)
    assert not np.array_equal(first, third)
