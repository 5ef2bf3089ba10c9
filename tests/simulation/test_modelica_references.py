"""Modelica Standard Library, Mechanics.Rotational.Examples, against its published reference results.

Source: modelica/MAP-LIB_ReferenceResults (Dymola 2020x); tolerance 5e-4 of the range, since the published files carry
Dymola's own.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear
from torquerig.rig.terms import AppliedTorque, Term
from torquerig.simulation import kernel
from torquerig.simulation.arrays import Outputs
from torquerig.simulation.inputs import Span, filled
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate


@dataclass(frozen=True)
class Sine:
    """``100 sin(2 pi 5 t)`` N m: 10 N m at the motor, behind a rigid gear of ratio 10."""

    mean: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return 100 * np.sin(2 * pi * 5 * np.arange(count) / rate)


@dataclass(frozen=True, kw_only=True)
class Drive(Part):
    """The torque source of the example."""

    at: str

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=Sine()),)


def test_first() -> None:
    """Jm 0.1 behind ratio 10 and J2 2 on one shaft (12 kg m^2), damper 10 on it, spring 1e4, J3 2; at 1 s."""
    rig = Rig(
        (
            Body(name="inertia2", inertia=2 + 0.1 * 10**2, viscous=10.0),
            Coupling(name="spring", after="inertia2", stiffness=1e4, damping=0.0),
            Body(name="inertia3", after="spring", inertia=2.0),
            Drive(name="torque", at="inertia2"),
        ),
        measured="spring",
    )
    made = simulate(rig, duration=1.00004, seed=0, settling=0.0)
    speed = made.channels["true_output_speed_rad_s"].values
    assert speed[-1] == pytest.approx(-0.138332379083, abs=5e-4 * np.ptp(speed))
    angle = np.trapezoid(speed, dx=1 / made.sample_rate)
    assert angle == pytest.approx(0.162860011994, abs=5e-4 * 0.33)


def released(*, gap: float) -> tuple[float, float]:
    """Return twist and speed of J = 5 after 1 s on c = 20e3, d = 50 to a practically fixed mass, from pi/2 and rest."""
    rig = Rig(
        (
            Body(name="wall", inertia=1e12),
            Gear(name="spring", after="wall", ratio=1, stiffness=20e3, damping=50.0, backlash=gap),
            Body(name="inertia", after="spring", inertia=5.0),
        ),
        measured="spring",
    )
    lowered = lower(rig, 0)
    theta, omega = np.array([0.0, pi / 2, 0.0]), np.zeros(3)
    terms = filled(rig, lowered, Span(settling=0, samples=25000, rate=25000.0, seed=0))
    none = Outputs(np.zeros(0, dtype=np.uint64), np.zeros(0, dtype=np.uint64))
    assert kernel.integrate(theta, omega, terms, none, 25000.0, 0, 1, np.empty((0, 25000))) == (-1, -1)
    return theta[1], omega[1]


def test_backlash_spring_damper() -> None:
    """phi_rel 0.0105180348164, w_rel -0.143703313917 after 1 s."""
    twist, speed = released(gap=0.0)
    assert twist == pytest.approx(0.0105180348164, abs=5e-4 * pi / 2)
    assert speed == pytest.approx(-0.143703313917, abs=5e-4 * 99)


def test_backlash_elasto_backlash() -> None:
    """b = pi/4: phi_rel -0.155570367237, w_rel -7.02293040313 after 1 s."""
    twist, speed = released(gap=pi / 4)
    assert twist == pytest.approx(-0.155570367237, abs=5e-4 * pi / 2)
    assert speed == pytest.approx(-7.02293040313, abs=5e-4 * 99)
