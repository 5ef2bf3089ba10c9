"""Nodes whose motion is given, and drives in torque mode, against closed forms."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling
from torquerig.rig.terms import Drive, ImposedMotion, Signal, Term
from torquerig.simulation.simulator import choice_for, simulate

J, K, C = 0.005, 700.0, 0.05
BASE, F = 3.0, 40.0  # [rad], [Hz] of the imposed swing


@dataclass(frozen=True)
class Swing:
    """``BASE + 0.01 sin(2 pi F t)``."""

    def at(self, time: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        return BASE + 0.01 * np.sin(2 * pi * F * time), 0.01 * 2 * pi * F * np.cos(2 * pi * F * time)


@dataclass(frozen=True)
class Step:
    """A torque from time 0 on."""

    torque: float

    def at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.where(time >= 0, self.torque, 0.0)


@dataclass(frozen=True, kw_only=True)
class With(Part):
    """Any terms as a part."""

    given: tuple[Term, ...]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return self.given


def shaft(*terms: Term, run: Run | None = None) -> Rig:
    first = Body(name="first", inertia=J)
    spring = Coupling(name="shaft", after="first", stiffness=K, damping=C)
    second = Body(name="second", after="shaft", inertia=J)
    return Rig((first, spring, second, With(name="given", given=terms)), run or Run(), measured="shaft")


def test_an_imposed_end_is_clamped_in_the_modes_that_fix_the_step() -> None:
    """sqrt(K / J) = 374.2 1/s with the first end clamped, not sqrt(2 K / J) = 529.2 1/s."""
    rig = shaft(ImposedMotion(name="given", on="first", motion=Swing()))
    choice = choice_for(rig, duration=0.1, seed=0, settling=0.0, sample_rate=200.0)
    assert choice.fixed_by.rate == pytest.approx((K / J) ** 0.5, rel=1e-4)


def truth(made: Recording, name: str) -> NDArray[np.float64]:
    return made.channels[name].values


def test_a_shaft_on_an_imposed_swing_follows_the_frequency_response() -> None:
    """theta2 = (k + c s) / (J s^2 + c s + k) theta1: amplitude and phase at 40 Hz, after the transient."""
    made = simulate(shaft(ImposedMotion(name="swing", on="first", motion=Swing())), duration=0.5, seed=0, settling=6.0)
    s = 2j * pi * F
    time = made.time()
    wave = np.column_stack([np.sin(2 * pi * F * time), np.cos(2 * pi * F * time)])
    speed = np.linalg.lstsq(wave, truth(made, "true_output_speed_rad_s"), rcond=None)[0]
    expected = 0.01 * s * (K + C * s) / (J * s**2 + C * s + K)
    assert speed[0] + 1j * speed[1] == pytest.approx(expected, rel=1e-5)
    assert truth(made, "true_motor_angle_rad") == pytest.approx(BASE + 0.01 * np.sin(2 * pi * F * time), abs=1e-12)


def test_what_the_imposing_takes_is_the_torque_of_both_inertias() -> None:
    """All momentum comes from outside: torque of the imposing = d/dt J (w1 + w2), its mean here by the end values."""
    made = simulate(shaft(ImposedMotion(name="swing", on="first", motion=Swing())), duration=0.2, seed=0, settling=0.0)
    momentum = J * (truth(made, "true_motor_speed_rad_s") + truth(made, "true_output_speed_rad_s"))
    taken = truth(made, "true_swing_torque_Nm")
    impulse = np.concatenate([[0.0], np.cumsum(0.5 * (taken[1:] + taken[:-1]))]) / made.sample_rate
    assert impulse == pytest.approx(momentum - momentum[0], abs=1e-6)  # trapezoids: T h^2 F 2 pi


def test_a_profile_imposes_the_set_point_on_a_rig_without_drive() -> None:
    rig = shaft(ImposedMotion(name="turn", on="first", factor=-2.0), run=Run(speed=10.0, profile="ramp"))
    made = simulate(rig, duration=0.5, seed=0, settling=0.1)
    ramp = np.minimum(1.0, 0.1 + np.arange(made.samples) / made.samples)
    assert truth(made, "true_motor_speed_rad_s") == pytest.approx(-20 * ramp, rel=1e-12)


def test_torque_mode_turns_both_masses_by_its_torque_after_the_current_lag() -> None:
    """w1 + w2 = T/J (t - lag (1 - exp(-t/lag))); held at the set-point of 5 rad/s while it settles."""
    drive = Drive(name="drive", on="first", kp=0.0, ki=0.0, torque_limit=2.0, lag=3e-3, demand=Step(1.5))
    made = simulate(shaft(drive, run=Run(speed=5.0)), duration=0.3, seed=0, settling=0.2)
    time = made.time()
    both = truth(made, "true_motor_speed_rad_s") + truth(made, "true_output_speed_rad_s")
    assert both == pytest.approx(10.0 + 1.5 / J * (time - 3e-3 * (1 - np.exp(-time / 3e-3))), rel=1e-9)


def test_a_torque_demand_is_limited_and_may_follow_the_profile() -> None:
    drive = Drive(name="drive", on="first", kp=0.0, ki=0.0, torque_limit=0.5, lag=1e-4, torque=1.0)
    made = simulate(shaft(drive, run=Run(profile="ramp")), duration=0.2, seed=0, settling=0.0)
    asked = np.minimum(1.0, 0.1 + np.arange(made.samples) / made.samples)
    assert truth(made, "true_motor_torque_Nm")[100:] == pytest.approx(np.minimum(0.5, asked)[100:], abs=1e-3)


def test_a_demand_is_fed_forward_beside_the_speed_loop() -> None:
    """What is fed forward is there after the lag; the loop adds kp times the error that is left."""
    feeding = Drive(name="drive", on="first", kp=0.01, ki=0.0, torque_limit=9.0, lag=1e-4, demand=Step(0.2))
    assert isinstance(feeding.demand, Signal)
    made = simulate(shaft(feeding, run=Run(speed=5.0)), duration=0.4, seed=0, settling=0.0)
    torque, speed = truth(made, "true_motor_torque_Nm"), truth(made, "true_motor_speed_rad_s")
    assert torque[500:] == pytest.approx(0.2 + 0.01 * (5.0 - speed[500:]), abs=2e-4)  # a lag of 0.1 ms behind


def test_two_motions_on_one_node_are_refused() -> None:
    twice = (ImposedMotion(name="one", on="first"), ImposedMotion(name="two", on="first"))
    with pytest.raises(InputError, match="two: the motion of 'first' is imposed by 'one' already"):
        simulate(shaft(*twice), duration=0.1, seed=0)
