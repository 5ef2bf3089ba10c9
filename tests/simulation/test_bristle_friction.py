"""LuGre friction against its own equation solved elsewhere, the Stribeck curve and breakaway."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling
from torquerig.rig.terms import AppliedTorque, BristleFriction, ImposedMotion, Term
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

# Canudas de Wit et al. 1995, table I, with N m for N: s0 1e5, s1 sqrt(1e5), s2 0.4, Fc 1, Fs 1.5, vs 0.001
TABLE_1 = BristleFriction(
    name="bristles", on="shaft", stiffness=1e5, damping=1e5**0.5, viscous=0.4, coulomb_forward=1.0,
    coulomb_backward=0.8, static_forward=1.5, static_backward=1.0, stribeck=0.001,
)  # fmt: skip


@dataclass(frozen=True)
class Swing:
    """``amplitude sin(2 pi f t)``."""

    amplitude: float
    frequency: float

    def at(self, time: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        w = 2 * pi * self.frequency
        return self.amplitude * np.sin(w * time), self.amplitude * w * np.cos(w * time)


@dataclass(frozen=True)
class Ramp:
    """A torque that rises evenly."""

    rate: float
    start: float

    def at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        return self.start + self.rate * np.maximum(time, 0.0)


@dataclass(frozen=True, kw_only=True)
class With(Part):
    """Any terms as a part."""

    given: tuple[Term, ...]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return self.given


def rig(*terms: Term, run: Run | None = None) -> Rig:
    first = Body(name="first", inertia=1.0)
    spring = Coupling(name="shaft", after="first", stiffness=1e3, damping=10.0)
    second = Body(name="second", after="shaft", inertia=1.0)
    return Rig((first, spring, second, With(name="given", given=terms)), run or Run(), measured="shaft")


def truth(made: Recording, name: str) -> NDArray[np.float64]:
    return made.channels[f"true_{name}"].values


@pytest.mark.parametrize("speed", [2e-4, 1e-3, 0.5, 50.0, -1e-3, -0.5])
def test_at_steady_speed_it_is_the_stribeck_curve(speed: float) -> None:
    """At 50 rad/s the bristle would follow in 0.2 us, a hundredth of a step; at 2e-4 rad/s it takes 75 ms."""
    turn = ImposedMotion(name="turn", on="shaft")
    made = simulate(rig(TABLE_1, turn, run=Run(speed=speed)), duration=0.01, seed=0, settling=2.0)
    low, high = (1.0, 1.5) if speed > 0 else (0.8, 1.0)
    expected = np.sign(speed) * (low + (high - low) * exp(-((speed / 0.001) ** 2))) + 0.4 * speed
    assert truth(made, "load_Nm") == pytest.approx(expected, rel=1e-6)


@pytest.mark.long
@pytest.mark.parametrize("amplitude", [5e-6, 4e-5], ids=["presliding", "through sliding"])
def test_hysteresis_is_that_of_the_equation_solved_elsewhere(amplitude: float) -> None:
    """DOP853 on ``z' = w - s0 |w| z / g(w)`` under the same motion, to 1e-5 of the static torque."""
    swing = Swing(amplitude, 5.0)
    made = simulate(rig(TABLE_1, ImposedMotion(name="swing", on="shaft", motion=swing)), duration=0.4, seed=0,
                    settling=0.0)  # fmt: skip

    def slope(t: float, z: NDArray[np.float64]) -> NDArray[np.float64]:
        w = swing.at(np.array([t]))[1][0]
        low, high = (1.0, 1.5) if w > 0 else (0.8, 1.0)
        return w - 1e5 * abs(w) * z / (low + (high - low) * exp(-((w / 0.001) ** 2)))

    time = made.time()
    z = solve_ivp(slope, (0, 0.4), [0.0], "DOP853", t_eval=time, rtol=1e-10, atol=1e-15, max_step=1e-3).y[0]
    speeds = swing.at(time)[1]
    slopes = np.array([slope(t, one) for t, one in zip(time, z, strict=True)])
    expected = 1e5 * z + 1e5**0.5 * slopes + 0.4 * speeds
    assert truth(made, "load_Nm") == pytest.approx(expected, abs=1.5e-5)
    if amplitude < 1e-5:  # bent, not slid: what it loses in a period is far less than what sliding would take
        assert np.abs(expected).max() < 1.0


def test_it_breaks_away_near_the_static_torque_the_nearer_the_slower() -> None:
    """Below Ts it only creeps; the break-away torque falls with the rate of the load (the paper's figure 4)."""
    highest = []
    for rate in (1.0, 0.05):
        push = AppliedTorque(name="push", on="shaft", process=Ramp(rate, start=0.0))
        made = simulate(rig(TABLE_1, push), duration=1.6 / rate, seed=0, settling=0.0, sample_rate=5e3)
        creep = truth(made, "output_speed_rad_s")[made.time() < 1.3 / rate]
        assert creep.max() < 5e-4
        highest.append(truth(made, "load_Nm").max())
        assert truth(made, "output_speed_rad_s")[-1] > 0.02  # broken away
    assert highest[0] < highest[1] < 1.5
    assert highest[1] == pytest.approx(1.5, rel=0.02)


def test_presliding_stiffness_is_in_the_stiffest_matrices_alone() -> None:
    """1e8 N m/rad on 1 kg m^2: 1e4 rad/s, which the step must follow; turning, bristles have no stiffness."""
    stiff = BristleFriction(name="b", on="shaft", stiffness=1e8, damping=0.0, coulomb_forward=1.0,
                            coulomb_backward=1.0, static_forward=1.0, static_backward=1.0)  # fmt: skip
    stuck = matrices(lower(rig(stiff), 0), stiffest=True).undamped_frequencies()
    assert stuck[-1] * 2 * pi == pytest.approx(1e4, rel=1e-4)
    turning, without = (matrices(lower(one, 0)).undamped_frequencies() for one in (rig(stiff), rig()))
    assert turning == pytest.approx(without, abs=1e-6)


def test_bristles_without_torque_are_refused() -> None:
    nothing = BristleFriction(name="b", on="shaft", stiffness=1.0, damping=0.0, coulomb_forward=0.0,
                              coulomb_backward=1.0, static_forward=1.0, static_backward=1.0)  # fmt: skip
    with pytest.raises(InputError, match="b: bristles need a stiffness, Coulomb and static torque above 0"):
        lower(rig(nothing), 0)
