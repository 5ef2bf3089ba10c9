"""What a model leaves that no effect explains is told, with its place, and gets no name that only looks like it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]
Carriage = Callable[..., Recording]
Diagnosed = Callable[..., MotionOutcome]

BROAD = """
operating_point: {}
measured: motion
rig:
  rotor: {kind: body, inertia: {value: 1.0e-4 kg*m^2, rel_sd: 0.1}, viscous: {value: 2.0e-3 N*m*s/rad, rel_sd: 0.5}}
  motion: {kind: imposed_motion, at: rotor, channel: angle}
"""
RATE = 1000.0


def turned(hum: Callable[[Floats], Floats]) -> Recording:
    """A rotor at 2 rev/s whose speed swings a little at 50 Hz, as a loop does that a hum of 50 Hz disturbs."""
    time = np.arange(8000) / RATE
    angle = 4 * np.pi * time + 0.3 * np.sin(2 * np.pi * 0.4 * time) + 2e-5 * np.cos(2 * np.pi * 50.0 * time)
    speed = np.gradient(angle, 1 / RATE)
    torque = 1e-4 * np.gradient(speed, 1 / RATE) + 2e-3 * speed + hum(time)
    torque = torque + 2e-4 * np.random.default_rng(5).standard_normal(time.size)
    channels = {
        "torque_Nm": Channel(values=torque, quantity="torque", unit="N*m"),
        "angle_rad": Channel(values=angle, quantity="angle", unit="rad"),
    }
    return Recording(sample_rate=RATE, channels=channels, name="turn.csv")


@pytest.mark.full
def test_a_spring_to_the_frame_is_told_by_its_place(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 60.0 * np.maximum(position - 0.04, 0.0)))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    (there,) = [one for one in outcome.diagnosis.mismatch if one.domain == "level"]
    assert (there.axis, there.p_value < 0.01) == ("m", True)
    assert there.at > 0.06  # of a stroke from -0.12 to 0.12 m


@pytest.mark.full
def test_a_load_that_steps_is_told_by_its_moment_and_is_no_drift(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 8.0 * (time > 7.0)))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    (step,) = [one for one in outcome.diagnosis.mismatch if one.domain == "time"]
    assert step.at == pytest.approx(7.0, abs=step.width)


@pytest.mark.full
def test_viscous_friction_that_the_scenario_lacks_is_no_dry_friction(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 60.0 * speed))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    assert "speed" in {one.domain for one in outcome.diagnosis.mismatch}


@pytest.mark.long
def test_friction_that_holds_more_than_it_slides_is_told_with_its_peak(
    carriage: Carriage, diagnosed: Diagnosed
) -> None:
    """5 N that slide, 12 N that hold, fallen at 0.04 m/s of 0.46; both ways alike."""
    law = lambda time, position, speed: np.sign(speed) * (5.0 + 7.0 * np.exp(-((speed / 0.04) ** 2)))  # noqa: E731
    (finding,) = diagnosed(carriage(law)).diagnosis.findings
    told = {name: each.value for name, each in finding.parameters.items()}
    assert (finding.mechanism, finding.variant) == ("stribeck_friction", "stribeck")
    assert told["coulomb_Nm"] == pytest.approx(5.0, rel=0.05)
    assert told["static_Nm"] == pytest.approx(12.0, rel=0.2)
    assert told["stribeck_rad_s"] == pytest.approx(0.04, rel=0.25)


@pytest.mark.full
def test_motion_one_way_tells_no_friction_of_the_other(diagnosed: Diagnosed) -> None:
    outcome = diagnosed(turned(lambda time: 0.03 + 0 * time), BROAD)
    for finding in outcome.diagnosis.findings:
        assert not [name for name in finding.parameters if name.endswith("backward")]


@pytest.mark.long
def test_hum_in_the_channel_is_named_and_is_no_mode(diagnosed: Diagnosed) -> None:
    """A branch could amplify the little that the angle moves at 50 Hz: it explains that line and nothing else."""
    outcome = diagnosed(turned(lambda time: 8e-3 * np.cos(2 * np.pi * 50.0 * time + 1.0)), BROAD)
    (finding,) = outcome.diagnosis.findings
    assert (outcome.diagnosis.verdict, finding.mechanism) == ("missing_physics", "mains_interference")
    assert finding.parameters["frequency_Hz"].value == pytest.approx(50.0, rel=1e-3)
    assert finding.parameters["amplitude_V"].value == pytest.approx(8e-3, rel=0.05)


@pytest.mark.long
def test_a_rotor_whose_numbers_are_wrong_lacks_nothing(diagnosed: Diagnosed) -> None:
    outcome = diagnosed(turned(lambda time: 0 * time), BROAD.replace("1.0e-4 kg", "1.3e-4 kg"))
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("adequate", ())
