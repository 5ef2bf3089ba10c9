"""Faults of a measured effort's samples are named and kept out of the fits; a drive's own limit is no fault."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from tests import moved_rigs
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome, diagnose_motion
from torquerig.diagnosis.motion.effort_samples import code_of, effort_faults
from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording

Floats = NDArray[np.float64]

FINE = 50  # steps of an integration per sample


def carriage(changed: Callable[[Floats], Floats], *, friction: float = 0.0, name: str = "run.csv") -> Recording:
    """The carriage of ``moved_rigs`` on a guide of ``friction``, its force read through ``changed``."""
    made = moved_rigs.recorded(lambda time, position, speed: friction * np.tanh(speed / 1e-3), name=name)
    return made.with_values("force_N", changed(made.channels["force_N"].values))


def diagnosed(*recordings: Recording) -> MotionOutcome:
    return diagnose_motion(moved_rigs.scenario(moved_rigs.CARRIAGE), recordings)


def named(outcome: MotionOutcome) -> list[str]:
    return [finding.mechanism for finding in outcome.diagnosis.findings]


@pytest.mark.long
def test_a_reading_that_stops_is_named_and_the_friction_beside_it_found() -> None:
    outcome = diagnosed(carriage(lambda force: np.clip(force, -25.0, 25.0), friction=12.0))
    assert outcome.diagnosis.verdict == "missing_physics"
    assert named(outcome) == ["clipping", "stribeck_friction"]
    limit, friction = outcome.diagnosis.findings
    assert (limit.parameters["limit_V"].value, limit.parameters["limit_V"].unit) == (pytest.approx(25.0), "N")
    assert friction.parameters["coulomb_Nm"].value == pytest.approx(12.0, rel=0.05)
    assert outcome.completed.part("clipping").limit == pytest.approx(25.0)  # type: ignore[attr-defined]


@pytest.mark.long
def test_a_drive_that_gives_no_more_than_its_limit_clips_nothing() -> None:
    """The motion is what a force that stops at 30 N makes of the mass: the model takes just that."""
    fine = np.arange(FINE * moved_rigs.COUNT) / moved_rigs.RATE / FINE
    given = np.clip(60 * np.sin(2 * np.pi * 0.5 * fine), -30.0, 30.0)
    speed = np.cumsum(given) / moved_rigs.RATE / FINE / moved_rigs.MASS
    position = np.cumsum(speed - speed.mean()) / moved_rigs.RATE / FINE
    noise = 0.3 * np.random.default_rng(3).standard_normal(moved_rigs.COUNT)
    force = np.clip(given[::FINE] + noise * (np.abs(given[::FINE]) < 30.0), -30.0, 30.0)
    made = moved_rigs.recorded(lambda time, *_: 0 * time)
    made = made.with_values("force_N", force).with_values("position_m", position[::FINE])
    faults = effort_faults([made], [made.channels["force_N"]])
    assert faults.limit is not None
    assert faults.limit.limit == pytest.approx(30.0)
    outcome = diagnosed(made)
    assert named(outcome) == []
    assert outcome.diagnosis.verdict == "adequate"


def test_a_reading_that_hardly_leaves_its_limit_is_refused_with_a_sentence() -> None:
    with pytest.raises(RecordingError, match=r"run\.csv: only \d+ samples are neither limit nor dropout"):
        diagnosed(carriage(lambda force: np.clip(force, -0.3, 0.3)))


@pytest.mark.long
def test_moments_without_signal_are_named_and_left_out() -> None:
    lost = [(700, 712), (1500, 1512), (2900, 2912), (4100, 4112)]

    def read(force: Floats) -> Floats:
        force = force.copy()
        for start, stop in lost:
            force[start:stop] = 0.0
        return force

    made = carriage(read, friction=12.0)
    outcome = diagnosed(made)
    assert named(outcome) == ["signal_dropout", "stribeck_friction"]
    told = outcome.diagnosis.findings[0].parameters
    assert told["duration_ms"].value == pytest.approx(30.0, rel=0.1)  # 12 samples at 400 Hz
    assert told["rate_per_minute"].value == pytest.approx(20.0, rel=0.01)  # 4 in 12 s
    run = outcome.runs[0]
    assert not (run.seen | run.held)[700:712].any()
    assert any("excluded from fits" in remark for remark in outcome.diagnosis.remarks)


@pytest.mark.long
def test_codes_that_make_most_of_the_noise_are_named_and_fine_ones_are_not() -> None:
    outcome = diagnosed(carriage(lambda force: 5.0 * np.round(force / 5.0)))
    assert named(outcome) == ["quantization"]
    assert outcome.diagnosis.findings[0].parameters["step_V"].value == pytest.approx(5.0)
    assert named(diagnosed(carriage(lambda force: 0.5 * np.round(force / 0.5)))) == []


@pytest.mark.full
def test_hum_has_a_phase_of_its_own_in_every_run() -> None:
    time = np.arange(moved_rigs.COUNT) / moved_rigs.RATE * 0.1  # as if at 4 kHz: 50 Hz lies in the compared band
    runs = []
    for number, phase in enumerate((0.3, 2.1, 4.4), start=1):
        wave = 3.0 * np.cos(2 * np.pi * 50.02 * time + phase)
        made = carriage(lambda force, wave=wave: force + wave, name=f"run{number}.csv")  # type: ignore[misc]
        slower = made.channels["position_m"].values * 0.01  # a tenth of the time: accelerations as before
        runs.append(replace(made.with_values("position_m", slower), sample_rate=10 * moved_rigs.RATE))
    outcome = diagnosed(*runs)
    (finding,) = outcome.diagnosis.findings
    assert (outcome.diagnosis.verdict, finding.mechanism) == ("missing_physics", "mains_interference")
    assert finding.parameters["frequency_Hz"].value == pytest.approx(50.02, abs=0.02)
    assert finding.parameters["amplitude_V"].value == pytest.approx(3.0, rel=0.05)


def test_values_on_whole_codes_tell_their_distance() -> None:
    force = 40 * np.sin(np.linspace(0, 20, 4000))
    assert code_of(0.3 * np.round(force / 0.3)) == pytest.approx(0.3)
    assert code_of(force) is None
    assert code_of(np.zeros(100)) is None
