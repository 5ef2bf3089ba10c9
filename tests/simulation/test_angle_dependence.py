"""What depends on the angle: rate-invariant load, varying stiffness (Mathieu), and the encoder of a speed loop."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body
from torquerig.rig.terms import AngleLoad, AppliedTorque, Drive, ImposedMotion, Inertia, Sensing, Spring, Term, Wave
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

J, K = 0.01, 400.0
TABLE = np.random.default_rng(3).uniform(0.5, 1.5, 3 * 64)  # three turns of 64 points


@dataclass(frozen=True)
class Grid:
    """A given torque over three turns."""

    mean: float = 1.0
    points_per_turn: int = 64

    def sample(self, rng: np.random.Generator) -> NDArray[np.float64]:
        return TABLE


@dataclass(frozen=True)
class Constant:
    """One torque for all time."""

    torque: float

    def at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.full(time.size, self.torque)


@dataclass(frozen=True, kw_only=True)
class Shaft(Part):
    """A spring with its output inertia, and further terms."""

    opens_node = True
    spring: Spring
    given: tuple[Term, ...] = ()

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (self.spring, Inertia(node="shaft", inertia=J), *self.given)


def rig(*terms: Term, run: Run | None = None, **changed: object) -> Rig:
    spring = replace(Spring(name="shaft", a="first", b="shaft", stiffness=K, damping=0.0), **changed)  # type: ignore[arg-type]
    body = Body(name="first", inertia=J)
    return Rig((body, Shaft(name="shaft", after="first", spring=spring, given=terms)), run or Run(), measured="shaft")


def truth(made: Recording, name: str) -> NDArray[np.float64]:
    return made.channels[f"true_{name}"].values


@pytest.mark.full
@pytest.mark.parametrize("speed", [3.0, 12.0, -5.0])
def test_the_load_is_one_trace_over_the_angle_whatever_the_speed(speed: float) -> None:
    turned = 7 * 2 * pi  # more than twice through the grid
    rig_ = rig(AngleLoad(name="bed", on="shaft", process=Grid()), ImposedMotion(name="turn", on="shaft"),
               run=Run(speed=speed))  # fmt: skip
    made = simulate(rig_, duration=turned / abs(speed), seed=0, settling=0.0, substeps=1)
    angle = truth(made, "motor_angle_rad")
    grid = np.append(TABLE, TABLE[0])
    expected = np.interp(angle % (6 * pi), np.arange(grid.size) * 2 * pi / 64, grid)
    assert truth(made, "load_Nm") == pytest.approx(np.sign(speed) * expected, abs=1e-9)
    energy = np.trapezoid(truth(made, "load_Nm")[abs(angle) < 6 * pi], angle[abs(angle) < 6 * pi])
    assert energy == pytest.approx(6 * pi * TABLE.mean(), rel=1e-3)  # the last piece of the last cell


def test_a_parametric_resonance_grows_as_mathieu_says() -> None:
    """J x'' + c x' + k (1 + eps cos(m theta)) x = T with theta turning at 2 w0 / m, beside DOP853.

    Growth eps w0 / 4 - c / 2J on the principal resonance: Nayfeh & Mook 1979, Nonlinear Oscillations, section 5.3.
    """
    w0, eps, m, c = sqrt(K / J), 0.2, 20, 0.01
    speed = 2 * w0 / m
    wave = Wave(order=float(m), amplitude=eps, phase=0.3)
    push = AppliedTorque(name="push", on="first", process=Constant(0.5))
    made = simulate(rig(push, ImposedMotion(name="turn", on="shaft"), run=Run(speed=speed), damping=c,
                        stiffness_waves=(wave,)), duration=0.6, seed=0, settling=0.0, substeps=2)  # fmt: skip
    time = made.time()

    def stiffness(t: NDArray[np.float64] | float) -> NDArray[np.float64]:
        return np.asarray(K * (1 + eps * np.cos(m * speed * t + 0.3)))

    def slope(t: float, x: NDArray[np.float64]) -> list[float]:
        return [x[1], (0.5 - c * x[1] - float(stiffness(t)) * x[0]) / J]

    # the first node also starts at speed: no twist, no rate of twist
    x = solve_ivp(slope, (0, 0.6), [0.0, 0.0], "DOP853", t_eval=time, rtol=1e-11, atol=1e-14).y
    expected = stiffness(time) * x[0] + c * x[1]
    found = truth(made, "sensor_torque_Nm")
    assert found == pytest.approx(expected, abs=1e-5 * np.abs(expected).max())
    early, late = (np.abs(found[(time > t) & (time < t + 0.1)]).max() for t in (0.3, 0.5))
    assert np.log(late / early) / 0.2 == pytest.approx(eps * w0 / 4 - c / (2 * J), rel=0.05)


def test_turning_stiffness_and_error_do_no_work_of_their_own() -> None:
    """Two free masses on a spring with gear, gap, error and stiffness waves, no damper: the energy stays."""
    made = simulate(
        rig(AppliedTorque(name="no", on="first", process=Constant(0.0)), run=Run(speed=40.0), ratio=-2.0, gap=1e-3,
            error=(Wave(order=9.0, amplitude=0.004, phase=0.0),), stiffness_waves=(Wave(order=11.0, amplitude=0.3),)),
        duration=1.0, seed=4, settling=0.0, substeps=8)  # fmt: skip
    lowered = lower(rig(stiffness_waves=(Wave(order=11.0, amplitude=0.3),)), 4)
    phase = np.arctan2(lowered.arrays.varied.s[0], lowered.arrays.varied.c[0])
    first, second = truth(made, "motor_speed_rad_s"), truth(made, "output_speed_rad_s")
    angle = np.concatenate([[0.0], np.cumsum(0.5 * (second[1:] + second[:-1]))]) / made.sample_rate
    stiffness = K * (1 + 0.3 * np.cos(11 * angle + phase))
    elastic = truth(made, "sensor_torque_Nm") ** 2 / (2 * stiffness)
    energy = 0.5 * J * (first**2 + second**2) + elastic
    assert elastic.max() > 0.01 * energy[0]  # so that the spring is in it
    assert energy == pytest.approx(energy[0], rel=2e-6)  # the angle is summed by trapezoids here


def test_a_stiffness_that_would_vanish_is_refused() -> None:
    with pytest.raises(InputError, match=r"shaft: its stiffness varies by 1\.1 of its mean"):
        lower(rig(stiffness_waves=(Wave(order=3.0, amplitude=0.6), Wave(order=6.0, amplitude=0.5))), 0)


def driven(sensing: Sensing, *, kp: float = 0.02, speed: float = 20.0) -> tuple[Recording, NDArray[np.float64]]:
    """Return a run and the speed that its loop saw, from the torque: it nears each command by exp(-T/lag)."""
    drive = Drive(name="drive", on="first", kp=kp, ki=0.0, torque_limit=1e3, lag=4e-5, sensing=sensing)
    made = simulate(rig(drive, run=Run(speed=speed)), duration=0.5, seed=2, settling=0.0, substeps=16)
    torque, left = truth(made, "motor_torque_Nm"), np.exp(-1.0)  # a period is one lag
    return made, speed - (torque[1:] - left * torque[:-1]) / (1 - left) / kp


def test_an_ideal_sensing_is_the_true_speed() -> None:
    made, seen = driven(Sensing(error=(Wave(order=3.0, amplitude=0.0),)))
    assert seen == pytest.approx(truth(made, "motor_speed_rad_s")[:-1], abs=1e-5)


@pytest.mark.parametrize(
    "sensing",
    [
        Sensing(counts=4096),
        Sensing(error=(Wave(order=2.0, amplitude=1e-3, phase=0.4),)),
        Sensing(filter_time=1e-3),
        Sensing(counts=1024, error=(Wave(order=1.0, amplitude=0.02, phase=0.0),), filter_time=5e-4),
    ],
    ids=["counts", "error", "filter", "all"],
)
def test_the_loop_sees_differences_of_the_read_angle(sensing: Sensing) -> None:
    made, seen = driven(sensing)
    angle = truth(made, "motor_angle_rad")
    reading = angle + sum(w.amplitude * np.cos(w.order * angle + (w.phase or 0.0)) for w in sensing.error)
    if sensing.counts:
        reading = np.floor(reading / (2 * pi / sensing.counts)) * (2 * pi / sensing.counts)
    raw = np.diff(reading) * made.sample_rate
    share = 1 - np.exp(-1 / (made.sample_rate * sensing.filter_time)) if sensing.filter_time else 1.0
    expected = [20.0]
    for one in raw:
        expected.append(expected[-1] + share * (one - expected[-1]))
    assert seen == pytest.approx(np.array(expected[:-1]), abs=1e-4)


def test_angle_error_becomes_the_torque_of_the_handbook_2_5() -> None:
    """A line K_p a_k k w at order k, which grows with speed and gain; heavy masses leave the speed as it is."""
    for kp, speed in ((0.02, 20.0), (0.04, 20.0), (0.02, 40.0)):
        made, _ = driven(Sensing(error=(Wave(order=2.0, amplitude=1e-3, phase=0.0),)), kp=kp, speed=speed)
        angle = 2 * truth(made, "motor_angle_rad")
        columns = np.column_stack([np.ones(angle.size), np.cos(angle), np.sin(angle)])
        line = np.linalg.lstsq(columns, truth(made, "motor_torque_Nm"), rcond=None)[0]
        # the masses of 0.02 kg m^2 answer at kp / J = 2 1/s, against 40 rad/s and more
        assert np.hypot(line[1], line[2]) == pytest.approx(kp * 1e-3 * 2 * speed, rel=0.03)
