"""What stays wrong as a whole, at no place of its own, is told in words, and the model is not called adequate."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from tests import moved_rigs
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.recordings.recording import Recording

Floats = NDArray[np.float64]
Carriage = Callable[..., Recording]
Diagnosed = Callable[..., MotionOutcome]

GUIDED = moved_rigs.CARRIAGE + (
    "  guide: {kind: stribeck_friction, at: carriage, coulomb: {value: 12 N, rel_sd: 0.3}, static: 12 N, "
    "stribeck_speed: 1 m/s, smoothing: 1 mm/s}\n"
)


def said(outcome: MotionOutcome) -> str:
    assert (outcome.diagnosis.verdict, outcome.diagnosis.findings) == ("unexplained", ())
    (told,) = [each for each in outcome.diagnosis.remarks if "of the squared residual: " in each]
    return told


@pytest.mark.full
def test_an_effort_that_comes_late_is_told_with_its_delay(carriage: Carriage, diagnosed: Diagnosed) -> None:
    made = carriage(lambda time, position, speed: 0 * time)
    late = made.with_values("force_N", np.roll(made.channels["force_N"].values, 8))  # 20 ms at 400 Hz
    told = said(diagnosed(late))
    assert "ms too late" in told
    assert float(told.split("force is ")[1].split(" ms")[0]) == pytest.approx(20.0, rel=0.15)


@pytest.mark.long
def test_friction_that_falls_as_a_guide_warms_up_is_told_by_its_course(
    carriage: Carriage, diagnosed: Diagnosed
) -> None:
    warming = carriage(lambda time, position, speed: (8 + 12 * np.exp(-time / 5)) * np.tanh(speed / 1e-3))
    told = said(diagnosed(warming, GUIDED))
    assert "dry friction that varies over the runs" in told


@pytest.mark.long
def test_a_spring_to_the_frame_is_no_friction_that_never_slides(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 300.0 * position))
    assert outcome.diagnosis.findings == ()


@pytest.mark.long
def test_a_zero_that_settles_is_a_drift(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 10.0 * (1 - np.exp(-time / 3.0))))
    (finding,) = outcome.diagnosis.findings
    assert (finding.mechanism, finding.variant) == ("sensor_drift", "exponential")
    assert finding.parameters["span_V"].value == pytest.approx(10.0, rel=0.1)
    assert finding.parameters["time_constant_s"].value == pytest.approx(3.0, rel=0.15)


def test_noise_alone_goes_with_nothing(carriage: Carriage, diagnosed: Diagnosed) -> None:
    outcome = diagnosed(carriage(lambda time, position, speed: 0 * time))
    assert outcome.diagnosis.verdict == "adequate"
    assert not [each for each in outcome.diagnosis.remarks if "of the squared residual: " in each]
