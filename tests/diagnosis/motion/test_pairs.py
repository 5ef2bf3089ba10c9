"""A motor that turns there and back once: cogging and friction that are missing together, and what alone is no pair."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.lines import Line, waves
from torquerig.diagnosis.motion.moved import moved_runs
from torquerig.diagnosis.motion.sign_smoothed import knobs_of_the_sign
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]
Diagnosed = Callable[..., MotionOutcome]

RATE = 250.0
MOTOR = """
operating_point: {}
measured: motion
rig:
  motor:
    kind: motor
    inertia: {value: 2.2e-4 kg*m^2, rel_sd: 0.1}
    torque_limit: 2 N*m
    pole_pairs: 4
    slots: 12
  motion: {kind: imposed_motion, at: motor, channel: motor_angle}
"""
BEARINGS = """
  bearings: {kind: stribeck_friction, at: motor, coulomb: {value: 6 mN*m, rel_sd: 0.3}, static: 6 mN*m,
             stribeck_speed: 1.0e-3 rad/s, smoothing: 0.02 rad/s}
"""


def turned(resists: Callable[[Floats, Floats], Floats]) -> Recording:
    """One slow turn and a third there and back, of 2e-4 kg m2, and 0.6 mN m of noise."""
    time = np.arange(5000) / RATE
    omega = 2 * np.pi / 20.0
    angle, speed = 4.0 * (1 - np.cos(omega * time)), 4.0 * omega * np.sin(omega * time)
    torque = 2e-4 * 4.0 * omega**2 * np.cos(omega * time) + resists(angle, speed)
    torque = torque + 6e-4 * np.random.default_rng(2).standard_normal(time.size)
    channels = {
        "current_A": Channel(values=torque / 0.06, quantity="motor_torque", unit="A", si_per_unit=0.06),
        "angle_rad": Channel(values=angle, quantity="motor_angle", unit="rad"),
    }
    return Recording(sample_rate=RATE, channels=channels, name="turn.csv")


def dry(angle: Floats, speed: Floats) -> Floats:
    return 0.006 * np.tanh(speed / 0.01)


def both(angle: Floats, speed: Floats) -> Floats:
    return dry(angle, speed) + 0.012 * np.cos(24 * angle + 0.5)


def weight(angle: Floats, speed: Floats) -> Floats:
    return dry(angle, speed) + 0.012 * np.cos(angle + 0.5)


@pytest.mark.long
def test_cogging_and_friction_that_are_missing_together_are_both_named(diagnosed: Diagnosed) -> None:
    outcome = diagnosed(turned(both), MOTOR)
    found = {one.mechanism: one.parameters for one in outcome.diagnosis.findings}
    assert outcome.diagnosis.verdict == "missing_physics"
    assert set(found) == {"cogging", "stribeck_friction"}
    assert found["cogging"]["order_motor"].value == 24
    assert found["cogging"]["amplitude_Nm"].value == pytest.approx(0.012, rel=0.02)
    assert found["stribeck_friction"]["coulomb_Nm"].value == pytest.approx(0.006, rel=0.05)
    (cogging, _) = outcome.steps
    assert cogging.kept is cogging.tried[0]
    assert "With stribeck friction in the model, it explains" in outcome.diagnosis.findings[0].explanation
    assert outcome.diagnosis.fit.after < 0.1 * outcome.diagnosis.fit.before


@pytest.mark.long
def test_a_weight_beside_friction_makes_no_pair(diagnosed: Diagnosed) -> None:
    """Of order 1, which neither slots nor poles allow: friction may be named, cogging never, and a rest stays."""
    outcome = diagnosed(turned(weight), MOTOR)
    assert outcome.diagnosis.verdict == "unexplained"
    assert {one.mechanism for one in outcome.diagnosis.findings} <= {"stribeck_friction"}


def test_over_what_speed_a_stated_friction_changes_sign_is_no_missing_physics(diagnosed: Diagnosed) -> None:
    """Twenty times slower than stated, and the run creeps through standstill twice."""
    text = MOTOR.replace("  motion:", BEARINGS.lstrip("\n").replace("0.02 rad/s", "0.2 rad/s") + "  motion:")
    outcome = diagnosed(turned(dry), text)
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("adequate", ())
    assert outcome.after.rig.part("bearings").smoothing < 0.04  # type: ignore[attr-defined]
    assert [knob.name for knob in knobs_of_the_sign(outcome.nominal, ())] == ["bearings.smoothing"]


@pytest.mark.full
def test_a_wave_is_told_by_samples_that_go_round_it_and_by_no_others(diagnosed: Diagnosed) -> None:
    """Backwards over a fiftieth of a cycle, a wave of any size would fit with its mean to match."""
    outcome = diagnosed(turned(both), MOTOR)
    (run,) = moved_runs([turned(both)], outcome.nominal, held_out=())
    line = Line(domain="order", at=8.0, width=0.1, amplitude=0.01, excess_db=20.0, p_value=0.0)
    little = np.flatnonzero(run.speed < 0)[:60]
    mask = (run.speed > 0) | np.isin(np.arange(run.speed.size), little)
    residual = np.where(run.speed > 0, 0.01 * np.cos(8 * run.position), 0.003)
    made = waves(replace(run, seen=mask), line, residual, mask)
    assert made[run.speed > 0] == pytest.approx(residual[run.speed > 0], abs=1e-9)
    assert np.all(made[run.speed < 0] == 0)
