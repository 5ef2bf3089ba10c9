"""Rounded dropouts of several recordings are found together, and a diagnosis takes them for a loss of signal."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from torquerig.diagnosis.sample_findings import sample_findings
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.common_dropouts import common_dropouts
from torquerig.scenario.model import Scenario

LENGTH, LOW_PASS = 0.006, 200.0  # [s], [Hz]
AT = ((0.7, 2.3, 4.9), (1.1, 3.2, 5.5))  # [s] in either run: too few in one alone


def lost(recording: Recording, starts: tuple[float, ...]) -> Recording:
    """Return the recording at 0 V from each moment on for a while, behind a low-pass, with noise of the converter."""
    rate, volts = recording.sample_rate, recording.torque_values().copy()
    for start in starts:
        volts[round(start * rate) : round((start + LENGTH) * rate)] = 0.0
    behind = sosfilt(butter(2, LOW_PASS, fs=rate, output="sos"), volts - volts[0]) + volts[0]
    noise = 0.005 * np.random.default_rng(1).standard_normal(volts.size)
    return recording.with_values(recording.torque_name(), behind + noise)


@pytest.mark.long
def test_two_runs_tell_what_one_does_not(wear_rig: Scenario, record: Callable[..., Recording]) -> None:
    whole = [record(wear_rig.rig, seed, duration=6.0, occupancy=5.0) for seed in (3, 4)]
    spoilt = [
        replace(lost(each, starts), name=f"run{index}.parquet")
        for index, (each, starts) in enumerate(zip(whole, AT, strict=True))
    ]
    assert common_dropouts(spoilt[:1]) == (None,)
    for own, starts in zip(common_dropouts(spoilt), AT, strict=True):
        assert own is not None
        assert own.starts == pytest.approx(starts, abs=1e-3)
        assert own.level == pytest.approx(0.0, abs=0.15)
    (candidate,) = sample_findings(spoilt, wear_rig.rig).candidates
    assert candidate.mechanism == "signal_dropout"
    assert candidate.parts[0].duration == pytest.approx(LENGTH, rel=0.1)
    assert sample_findings(whole, wear_rig.rig).candidates == ()
