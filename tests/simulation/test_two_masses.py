"""Two masses on a spring: the handbook's transfer to the sensor, the survey's case 6.3, and motulator beside it.

Handbook: signatures section 0, ``T_s = G(s) (J2/(J1+J2) N T_motor + J1/(J1+J2) T_load)``,
``G = (w0^2 + 2 zeta w0 s) / (s^2 + 2 zeta w0 s + w0^2)``, output-referred, J1 = N^2 J_motor.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.motulator_peer import two_masses
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear
from torquerig.rig.terms import AppliedTorque, Term
from torquerig.simulation.linear_path import simulate_linear
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import twin_of


@dataclass(frozen=True)
class Sine:
    """``mean + amplitude sin(2 pi f t)``."""

    mean: float = 0.0
    amplitude: float = 0.0
    frequency: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return self.mean + self.amplitude * np.sin(2 * pi * self.frequency * np.arange(count) / rate)


@dataclass(frozen=True, kw_only=True)
class Push(Part):
    """A torque from outside."""

    at: str
    process: Sine

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=self.process),)


def geared(*, motor: float, ratio: float = 5.0, load: float = 2e-3, k: float = 950.0, c: float = 0.12) -> Rig:
    return Rig(
        (
            Body(name="motor", inertia=motor),
            Gear(name="sensor", after="motor", ratio=ratio, stiffness=k, damping=c),
            Body(name="load", after="sensor", inertia=load),
        ),
        measured="sensor",
    )


def handbook(rig: Rig, frequency: NDArray[np.float64]) -> dict[str, NDArray[np.complex128]]:
    """Return the handbook's transfers to the sensor by the node that the torque acts on."""
    motor, sensor, load = rig.parts
    assert isinstance(motor, Body)
    assert isinstance(sensor, Gear)
    assert isinstance(load, Body)
    J1, J2 = sensor.ratio**2 * motor.inertia, load.inertia
    w0 = sqrt(sensor.stiffness * (J1 + J2) / (J1 * J2))
    zeta = sensor.damping * w0 / (2 * sensor.stiffness)
    s = 2j * pi * frequency
    G = (w0**2 + 2 * zeta * w0 * s) / (s**2 + 2 * zeta * w0 * s + w0**2)
    # a load torque brakes: torque on the node with the other sign
    return {"motor": G * J2 / (J1 + J2) * sensor.ratio, "sensor": -G * J1 / (J1 + J2)}


@pytest.mark.parametrize("ratio", [5.0, -2.5])
@pytest.mark.parametrize("motor", [0.5e-4, 2e-4])
def test_motor_ripple_and_load_reach_the_sensor_by_g_of_s(motor: float, ratio: float) -> None:
    rig = geared(motor=motor, ratio=ratio)
    frequency = np.geomspace(0.5, 5000, 200)
    twin = twin_of(rig)
    for node, expected in handbook(rig, frequency).items():
        found = twin.open_loop.transfer(f"torque on {node}", "torque in sensor", frequency)
        assert np.abs(found / expected - 1).max() < 1e-9, node


@pytest.mark.parametrize(("motor", "passes", "follows"), [(0.5e-4, 0.62, 0.38), (2e-4, 0.29, 0.71)])
def test_reflected_masses_of_the_handbook(motor: float, passes: float, follows: float) -> None:
    """N = 5, J2 = 2e-3, far below w0: motor ripple passes 62 or 29 %, the load 38 or 71 %."""
    twin, low = twin_of(geared(motor=motor)), np.array([0.5])
    assert abs(twin.open_loop.transfer("torque on motor", "torque in sensor", low)[0]) / 5 == pytest.approx(
        passes, abs=5e-3
    )
    assert abs(twin.open_loop.transfer("torque on sensor", "torque in sensor", low)[0]) == pytest.approx(
        follows, abs=5e-3
    )


@pytest.mark.parametrize("frequency", [40.0, 137.0, 400.0])
@pytest.mark.parametrize("node", ["motor", "sensor"])
def test_integrated_lines_have_the_size_of_g_of_s(node: str, frequency: float) -> None:
    """Below, near and above w0 / 2 pi = 147 Hz; damped so that the start has died away in the last 0.2 s."""
    rig = geared(motor=2e-4, c=0.4)
    expected = handbook(rig, np.array([frequency]))[node][0] * 0.01
    push = Push(name="push", at={"motor": "motor", "sensor": "load"}[node], process=Sine(0.0, 0.01, frequency))
    made = simulate(rig + push, duration=0.8, seed=0, settling=0.0)
    kept = made.time() > 0.6
    angle = 2 * pi * frequency * made.time()[kept]
    columns = np.column_stack([np.ones(angle.size), np.sin(angle), np.cos(angle)])
    _, sine, cosine = np.linalg.lstsq(columns, made.channels["true_sensor_torque_Nm"].values[kept], rcond=None)[0]
    # the torque runs straight between samples: (pi f / rate)^2 / 3 of it is missing, 1e-3 at 400 Hz
    assert abs(complex(sine, cosine) - expected) < 2e-3 * abs(expected)


def case_6_3(*, gap: float = 0.0) -> Rig:
    """1 N m on J1, J1 = J2 = 0.005, c 700, d 0.01, from rest."""
    rig = geared(motor=0.005, ratio=1.0, load=0.005, k=700, c=0.01)
    sensor = rig.part("sensor")
    assert isinstance(sensor, Gear)
    return rig.changed(replace(sensor, backlash=gap)) + Push(name="push", at="motor", process=Sine(1.0))


def ends(made: Recording) -> tuple[float, float, float]:
    names = ("true_motor_speed_rad_s", "true_output_speed_rad_s", "true_sensor_torque_Nm")
    w1, w2, torque = (float(made.channels[name].values[-1]) for name in names)
    return w1, w2, torque


def test_spring_and_damper_of_case_6_3_by_both_paths() -> None:
    """w1 100.025004197, w2 99.974995803, torque 0.486019685: integrated to 2e-8, exact to the digits."""
    for made, within in (
        (simulate(case_6_3(), duration=1.00004, seed=0, settling=0.0, substeps=4), 2e-8),
        (simulate_linear(case_6_3(), duration=1.00004, seed=0, settling=0.0), 1e-9),
    ):
        assert ends(made) == pytest.approx((100.025004197, 99.974995803, 0.486019685), abs=within)


def test_backlash_of_case_6_3_ends_and_contacts() -> None:
    """b = 0.004: w1 100.0591814, w2 99.9408186, torque 0.6791051 within 1e-5 at the chosen step, 47 contacts."""
    made = simulate(case_6_3(gap=0.004), duration=1.00004, seed=0, settling=0.0)
    assert ends(made) == pytest.approx((100.0591814, 99.9408186, 0.6791051), abs=1e-6)
    touching = simulate(
        case_6_3(gap=0.004), duration=1.000005, seed=0, settling=0.0, sample_rate=200_000.0
    ).channels["true_sensor_torque_Nm"].values != 0.0  # fmt: skip
    assert np.count_nonzero(touching[1:] & ~touching[:-1]) == 47


def test_two_mass_system_beside_motulator() -> None:
    """Its TwoMassMechanicalSystem, 1 N m on the motor from rest: same roots, and the same end after 0.2 s."""
    from scipy.integrate import solve_ivp

    slope = two_masses(motor=0.005, load=0.005, stiffness=700, damping=0.01)
    still = slope(0.0, np.zeros(3))
    matrix = np.column_stack([slope(0.0, column) - still for column in np.eye(3)])
    theirs = np.sort(np.linalg.eigvals(matrix).imag)[-1] / (2 * pi)
    (mode,) = twin_of(case_6_3()).modes()
    assert mode.damped == pytest.approx(theirs, rel=1e-9)
    found = solve_ivp(slope, (0.0, 0.2), np.zeros(3), rtol=1e-10, atol=1e-12).y[:, -1]
    made = simulate(case_6_3(), duration=0.2 + 4e-5, seed=0, settling=0.0)
    w1, w2, torque = ends(made)
    assert (w1, w2) == pytest.approx((found[0], found[1]), rel=1e-7)
    assert torque == pytest.approx(700 * found[2] + 0.01 * (found[0] - found[1]), rel=1e-5)
