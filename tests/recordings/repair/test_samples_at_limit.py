"""A hit that reaches the converter's limit leaves no corner, and nothing else is touched."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.samples_at_limit import rebuilt

RATE, FULL = 25_000.0, 10.0
TIME = np.arange(12_500) / RATE
HIT = 4.0 + 7.5 * np.exp(-(((TIME - 0.25) / 0.004) ** 2))  # [V] a smooth hit that would reach 11.5


def recorded(volts: np.ndarray) -> Recording:
    return Recording(
        name="run",
        sample_rate=RATE,
        channels={"torque_V": Channel(values=volts, unit="V", quantity="torque", si_per_unit=1.0)},
    )


def volts_of(recording: Recording) -> np.ndarray:
    return recording.channels["torque_V"].values


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_top_of_a_hit_is_put_back(sign: float) -> None:
    mended = volts_of(rebuilt(recorded(np.clip(sign * HIT, -FULL, FULL)), limit=FULL))
    cut = np.abs(HIT) > FULL
    assert np.array_equal(mended[~cut][:6000], (sign * HIT)[~cut][:6000])
    # the cubic knows two slopes; of 1.5 V that were cut off it brings back all but a tenth
    assert np.abs(mended - sign * HIT).max() < 0.15


def test_a_corner_no_longer_rings_through_the_bands() -> None:
    def above_300_hz(volts: np.ndarray) -> float:
        density = np.abs(np.fft.rfft(np.diff(volts, 2))) ** 2
        return float(density[np.fft.rfftfreq(volts.size - 2, 1 / RATE) > 300.0].sum())

    cut = np.clip(HIT, -FULL, FULL)
    assert above_300_hz(volts_of(rebuilt(recorded(cut), limit=FULL))) < 0.5 * above_300_hz(cut)


def test_what_stands_at_the_limit_for_long_is_left_as_it_is() -> None:
    stuck = np.clip(3.0 * HIT, -FULL, FULL)
    assert np.array_equal(volts_of(rebuilt(recorded(stuck), limit=FULL)), stuck)


def test_a_recording_below_the_limit_is_the_same_object() -> None:
    whole = recorded(0.5 * HIT)
    assert rebuilt(whole, limit=FULL) is whole
