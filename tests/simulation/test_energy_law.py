"""Energy over all terms: what the torques do to the masses is what was put in less what is lost and stored.

Every power here is written from the equation in the term's docstring, not taken from the kernel.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, tanh

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import (
    AngleLoad,
    AppliedTorque,
    BladeTorque,
    BristleFriction,
    Drive,
    Friction,
    HarmonicTorque,
    ImposedMotion,
    Inertia,
    Load,
    Spring,
    Term,
    Wave,
)
from torquerig.simulation.inputs import Span, filled
from torquerig.simulation.kernel.forces import forces
from torquerig.simulation.kernel.work import work_for
from torquerig.simulation.lower import lower


@dataclass(frozen=True)
class OverTime:
    """One torque at all times."""

    mean: float = 0.7

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.full(count, self.mean)


@dataclass(frozen=True)
class OverAngle:
    """One torque at all angles."""

    mean: float = 0.7
    points_per_turn: int = 8

    def sample(self, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.full(64, self.mean)


@dataclass(frozen=True)
class Given:
    """One torque at all times."""

    def at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.full(time.size, 0.4)


WAVE = Wave(order=3.0, amplitude=0.01, phase=0.5)
GEAR = Spring(name="gear", a="a", b="b", stiffness=900.0, damping=0.6, gap=0.02, ratio=-3.0, efficiency=0.9,
              error=(WAVE,), damping_follows=True,
              stiffness_waves=(Wave(order=5.0, amplitude=0.3, phase=1.0),))  # fmt: skip
SHAFT = Spring(name="shaft", a="b", b="c", stiffness=400.0, damping=0.2)
FRICTION = Friction(name="friction", on="b", coulomb_forward=0.3, coulomb_backward=0.2, static_forward=0.5,
                    static_backward=0.4, stribeck=2.0, viscous=0.01, quadratic=1e-3)  # fmt: skip
BRISTLES = BristleFriction(name="bristles", on="c", against="b", stiffness=50.0, damping=0.3, coulomb_forward=0.4,
                           coulomb_backward=0.5, static_forward=0.6, static_backward=0.7, viscous=0.02)  # fmt: skip
RIPPLE = HarmonicTorque(
    name="ripple", on="a", angle="c", against="b", waves=(Wave(order=2.0, amplitude=0.2, phase=0.3),)
)
BLADES = BladeTorque(name="blades", on="c", order=4.0, amplitude=0.9, phase=0.1)
DRIVE = Drive(name="drive", on="a", against="c", kp=1.0, ki=0.0, torque_limit=9.0, lag=1e-3,
              ripple=(Wave(order=6.0, amplitude=0.1, phase=0.2),))  # fmt: skip
TERMS: tuple[Term, ...] = (
    *(Inertia(node=node, inertia=0.01) for node in "abc"), GEAR, SHAFT, FRICTION, BRISTLES, RIPPLE, BLADES, DRIVE,
    Load(name="load", on="c", process=OverTime()), AngleLoad(name="bed", on="b", process=OverAngle()),
    AppliedTorque(name="push", on="a", process=Given()), ImposedMotion(name="turn", on="c"),
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Everything(Part):
    """All terms at once."""

    opens_node = True

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return TERMS


def wave(one: Wave, theta: float) -> tuple[float, float]:
    """Return a wave and its derivative by the angle."""
    phase = one.order * theta + (one.phase or 0.0)
    return one.amplitude * np.cos(phase), -one.order * one.amplitude * np.sin(phase)


def curve(term: Friction | BristleFriction, w: float) -> float:
    low, high = (term.coulomb_forward, term.static_forward) if w > 0 else (term.coulomb_backward, term.static_backward)
    return low + (high - low) * exp(-((w / term.stribeck) ** 2))


def stored(theta: NDArray[np.float64]) -> tuple[float, float, float, float]:
    """Return the energy of both springs, and twist beyond the gap, stiffness and e' of the gear."""
    e, lean = wave(WAVE, theta[1])
    twist = -theta[0] / 3 - theta[1] + e
    beyond = np.sign(twist) * max(0.0, abs(twist) - 0.01)
    k = 900.0 * (1 + wave(GEAR.stiffness_waves[0], theta[1])[0])
    return 0.5 * k * beyond**2 + 200.0 * (theta[1] - theta[2]) ** 2, beyond, k, lean


def test_the_rig_has_every_term() -> None:
    kinds = {kind for kind in Term.__subclasses__() if kind.__module__.startswith("torquerig.rig.terms")}
    assert kinds == {type(term) for term in TERMS}


@pytest.mark.long
@pytest.mark.parametrize("seed", range(40))
def test_kinetic_and_elastic_energy_change_by_what_goes_in_and_what_is_lost(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rig = Rig((Everything(name="b"),), Run(speed=1.0), measured="b")
    lowered = lower(rig, 0)
    terms = filled(rig, lowered, Span(settling=0, samples=2, rate=1e4, seed=0))
    work = work_for(terms)
    theta, omega = np.append(rng.uniform(-0.03, 0.03, 3), 0.0), np.append(rng.uniform(-9, 9, 3), 0.0)
    tau, bristle = rng.uniform(-2, 2, 1), rng.uniform(-0.01, 0.01, 1)
    forces.py_func(
        theta, omega, tau, np.array([0.7, 0.4]), terms, work.cosine, work.sine, work.spring_torque, work.contact,
        work.opposing, work.torque, True, work.stiffness, work.damping, work.twisted, work.twisting, bristle,
        work.bend_slope, 1e9,
    )  # fmt: skip
    found = float(work.torque[:3] @ omega[:3])  # d(kinetic)/dt of the free masses

    tiny = 1e-7
    elastic = (stored(theta[:3] + tiny * omega[:3])[0] - stored(theta[:3] - tiny * omega[:3])[0]) / (2 * tiny)
    _, beyond, k, lean = stored(theta[:3])
    rate = -omega[0] / 3 - omega[1] * (1 - lean)
    c = 0.6 * k / 900.0
    pressed, damped = k * abs(beyond), np.sign(beyond) * c * rate
    torque = np.sign(beyond) * max(0.0, pressed + min(damped, pressed))
    if torque == 0 and beyond:  # the damper takes all that the flanks give back
        elastic += 0.5 * 900.0 * wave(GEAR.stiffness_waves[0], theta[1])[1] * -omega[1] * beyond**2
    flow = tanh(50 * -omega[0] / 3) * np.sign(torque)
    gear = torque * (-omega[0] / 3) * (1 / 0.9 - 1 if flow > 0 else 1 - 0.9) * flow
    assert gear >= 0.0  # a gear's loss is a loss, whatever both shafts do
    lost = (torque - k * beyond) * rate + gear + 0.2 * (omega[1] - omega[2]) ** 2
    w = omega[1]
    lost += w * (curve(FRICTION, w) * tanh(w / 0.02) + 0.01 * w + 1e-3 * w * abs(w))
    slip = omega[2] - omega[1]
    bend = slip - 50.0 * abs(slip) * bristle[0] / curve(BRISTLES, slip)
    lost += slip * (50.0 * bristle[0] + 0.3 * bend + 0.02 * slip)  # what the bristles store is counted as lost here
    lost += 0.7 * abs(tanh(omega[2] / 0.02)) * abs(omega[2]) + 0.7 * abs(tanh(omega[1] / 0.02)) * abs(omega[1])
    lost += 0.9 * max(0.0, np.cos(4 * theta[2] + 0.1)) ** 2 * omega[2] * tanh(omega[2] / 0.02)
    put_in = 0.4 * omega[0] + wave(RIPPLE.waves[0], theta[2])[0] * (omega[0] - omega[1])
    put_in += tau[0] * (1 + wave(DRIVE.ripple[0], theta[0])[0]) * (omega[0] - omega[2])
    assert found + elastic == pytest.approx(put_in - lost, abs=1e-6 * (1 + abs(put_in) + abs(lost)))  # the difference


def test_torques_between_shafts_come_in_pairs() -> None:
    """Drive, ripple and bristles act between two shafts: alone, without gear or ground, they leave the sum at zero."""
    given = (RIPPLE, DRIVE, BRISTLES, SHAFT, *(Inertia(node=node, inertia=0.01) for node in "abc"))

    @dataclass(frozen=True, kw_only=True)
    class Pairs(Part):
        opens_node = True

        def terms(self, rig: Rig) -> tuple[Term, ...]:
            return given

    rig = Rig((Pairs(name="b"),), Run(speed=1.0), measured="b")
    terms = filled(rig, lower(rig, 0), Span(settling=0, samples=2, rate=1e4, seed=0))
    work = work_for(terms)
    theta, omega = np.array([0.3, 0.1, -0.2, 0.0]), np.array([3.0, -1.0, 2.0, 0.0])
    forces.py_func(
        theta, omega, np.array([1.3]), np.zeros(0), terms, work.cosine, work.sine, work.spring_torque, work.contact,
        work.opposing, work.torque, True, work.stiffness, work.damping, work.twisted, work.twisting, np.array([0.005]),
        work.bend_slope, 1e9,
    )  # fmt: skip
    assert work.torque[:3].sum() == pytest.approx(0.0, abs=1e-14)
    assert np.abs(work.torque[:3]).min() > 0.1
