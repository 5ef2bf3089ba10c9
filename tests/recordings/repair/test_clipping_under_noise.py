"""Flat tops that noise rides on: found where the signal was cut before the noise came, and nowhere else."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.clipping_under_noise import flat_under_noise
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.run import Run

RATE, LENGTH, LIMIT, NOISE, STEP = 5000.0, 12.0, 2.9, 0.005, 3e-4
TIME = np.arange(int(RATE * LENGTH)) / RATE


def recording(signal: np.ndarray, noise: float = NOISE) -> Recording:
    volts = signal + noise * np.random.default_rng(5).standard_normal(TIME.size)
    channel = Channel(values=np.round(volts / STEP) * STEP, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=100.0), name="run")


def load() -> np.ndarray:
    """Wide noise around 2 V, slower than the amplifier's own."""
    smooth = np.convolve(np.random.default_rng(3).standard_normal(TIME.size), np.hanning(60), "same")
    return np.asarray(2.0 + 0.12 * smooth)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_limit_before_the_noise_is_found(sign: float) -> None:
    given = recording(sign * np.minimum(load(), LIMIT))
    assert flat_tops([given], full_range=10.0, code=STEP) is None, "the noise hides it"
    found = flat_under_noise([given], full_range=10.0)
    assert found is not None
    assert found.limit == pytest.approx(LIMIT, abs=1e-3)
    assert found.runs == ("run",)
    assert flat_under_noise([given], full_range=LIMIT) is None, "the converter's own end is no amplifier's"


@pytest.mark.parametrize(
    "signal",
    [load(), 2.0 + np.sin(2 * pi * 13.7 * TIME), 2.0 + np.minimum(np.sin(2 * pi * 0.1 * TIME), 0.2),
     np.minimum(load(), LIMIT) - 4.0],
    ids=["no limit", "a sine", "one crest that lies flat", "a limit on the side of zero"],
)  # fmt: skip
def test_where_there_is_none_none_is_found(signal: np.ndarray) -> None:
    assert flat_under_noise([recording(signal)]) is None


def test_noise_that_is_most_of_the_signal_has_no_tops() -> None:
    assert flat_under_noise([recording(np.full(TIME.size, 2.0), noise=0.1)]) is None


@pytest.mark.filterwarnings("error")
def test_straight_lines_between_held_samples_have_no_noise_to_look_under() -> None:
    """What their second differences leave is the arithmetic's."""
    knots = np.arange(0, TIME.size, 40)
    between = np.interp(np.arange(TIME.size), knots, load()[knots])
    given = recording(between, noise=0.0).with_values("torque_V", between)
    assert flat_under_noise([given], full_range=10.0) is None
