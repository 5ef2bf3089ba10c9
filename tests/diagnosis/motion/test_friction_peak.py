"""A friction that is stated without a peak, on recordings that have one: what slides is added to, and told whole."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnosis.motion import friction
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.friction_peak import dry_beside
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]
Diagnosed = Callable[..., MotionOutcome]

RATE, SLIDES, HOLDS, FALLS = 250.0, 0.006, 0.010, 0.3
JOINT = """
operating_point: {{}}
measured: motion
rig:
  joint: {{kind: body, inertia: {{value: 2.2e-4 kg*m^2, rel_sd: 0.1}}, viscous: 1.0e-9 N*m*s/rad}}
  bearings: {{kind: stribeck_friction, at: joint, coulomb: {{value: 5 mN*m, rel_sd: 0.5}}, static: {static} mN*m,
             stribeck_speed: {falls} rad/s, smoothing: 0.02 rad/s}}
  motion: {{kind: imposed_motion, at: joint, channel: angle}}
"""
FLAT, PEAKED = JOINT.format(static=5, falls=0.001), JOINT.format(static=10, falls=0.3)


@pytest.fixture(scope="module")
def swung() -> Recording:
    """Two swings that do not meet, of 2e-4 kg m2, and 0.2 mN m of noise."""
    time = np.arange(6000) / RATE
    swings = ((1.5, 0.5, 0.0), (0.6, 1.7, 1.0))
    angle = sum(a * np.sin(w * time + p) for a, w, p in swings)
    speed = np.asarray(sum(a * w * np.cos(w * time + p) for a, w, p in swings))
    gained = sum(-a * w**2 * np.sin(w * time + p) for a, w, p in swings)
    dry = np.tanh(speed / 0.01) * (SLIDES + (HOLDS - SLIDES) * np.exp(-((speed / FALLS) ** 2)))
    torque = 2e-4 * gained + dry + 2e-4 * np.random.default_rng(2).standard_normal(time.size)
    channels = {
        "torque_Nm": Channel(values=torque, quantity="torque", unit="N*m"),
        "angle_rad": Channel(values=np.asarray(angle), quantity="angle", unit="rad"),
    }
    return Recording(sample_rate=RATE, channels=channels, name="swing.csv")


@pytest.mark.long
def test_a_peak_on_stated_friction_is_named_with_the_whole_friction(swung: Recording, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(swung, FLAT)
    (finding,) = outcome.diagnosis.findings
    assert outcome.diagnosis.verdict == "missing_physics"
    assert (finding.mechanism, finding.variant) == ("stribeck_friction", "stribeck")
    assert finding.parameters["coulomb_Nm"].value == pytest.approx(SLIDES, rel=0.03)
    assert finding.parameters["static_Nm"].value == pytest.approx(HOLDS, rel=0.03)
    assert finding.parameters["stribeck_rad_s"].value == pytest.approx(FALLS, rel=0.05)
    assert dry_beside(outcome.after.rig, outcome.after.rig.part("friction_peak"))[0] == pytest.approx(SLIDES, rel=0.03)


def test_a_stated_peak_needs_none(swung: Recording, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(swung, PEAKED)
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("adequate", ())


def test_a_peak_narrower_than_the_sign_is_none() -> None:
    part = mechanisms.StribeckFriction(name="f", at="x", coulomb=1.0, static=2.0, stribeck_speed=0.01, smoothing=0.02)
    assert not friction.possible(part, friction.PEAKED)
    assert friction.possible(replace(part, stribeck_speed=0.03), friction.PEAKED)
    assert friction.possible(part, "")
