"""Flat tops under a hum: the limit is found where the signal was cut before the hum came, and nowhere else."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.clipping_under_hum import flat_under_hum
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.run import Run

RATE, LENGTH, LIMIT = 5000.0, 12.0, 2.9
TIME = np.arange(int(RATE * LENGTH)) / RATE


def recording(*, cut: bool, hum: float, after: bool = True, frequency: float = 59.985) -> Recording:
    """A load of wide noise around 2 V, cut at the limit before or after a hum with a third harmonic is added."""
    rng = np.random.default_rng(3)
    load = 2.0 + np.convolve(rng.standard_normal(TIME.size), np.hanning(25), "same") * 0.15
    phase = 2 * pi * frequency * TIME + 0.7
    added = hum * (np.cos(phase) + 0.4 * np.cos(3 * phase + 1.0))
    volts = np.minimum(load, LIMIT) + added if after else np.minimum(load + added, LIMIT)
    volts = (volts if cut else load + added) + 2e-4 * rng.standard_normal(TIME.size)
    channel = Channel(values=np.round(volts / 3e-4) * 3e-4, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=100.0), name="run")


@pytest.mark.parametrize("frequency", [49.97, 59.985])
def test_a_limit_before_the_hum_is_found(frequency: float) -> None:
    given = recording(cut=True, hum=0.6, frequency=frequency)
    assert flat_tops([given], full_range=10.0, code=3e-4) is None  # the hum hides it
    found = flat_under_hum([given])
    assert found is not None
    assert found.limit == pytest.approx(LIMIT, abs=1e-3)
    assert found.runs == ("run",)


@pytest.mark.parametrize("cut", [True, False])
def test_a_limit_before_an_alias_is_found(cut: bool) -> None:
    """Its crests make the largest values rare, so that no reading stays at them."""
    given = recording(cut=cut, hum=0.0)
    volts = given.channels["torque_V"].values + 0.06 * np.cos(2 * pi * 1153.71 * TIME)
    given = given.with_values("torque_V", np.round(volts / 3e-4) * 3e-4)
    assert flat_tops([given], full_range=10.0, code=3e-4) is None
    found = flat_under_hum([given])
    assert (found is not None) is cut
    if found is not None:
        assert found.limit == pytest.approx(LIMIT, abs=1e-3)


@pytest.mark.parametrize(
    ("cut", "hum", "after"), [(False, 0.6, True), (True, 0.0, True), (True, 0.6, False)],
    ids=["no limit", "no hum", "limit after the hum"],
)  # fmt: skip
def test_where_there_is_none_none_is_found(cut: bool, hum: float, after: bool) -> None:
    assert flat_under_hum([recording(cut=cut, hum=hum, after=after)]) is None


def test_what_the_converter_stops_is_no_limit_of_an_amplifier() -> None:
    """An alias too small to move the code at which a converter ends lies on everything that it does not stop."""
    given = recording(cut=False, hum=0.0)
    volts = given.channels["torque_V"].values + 0.03 * np.cos(2 * pi * 1153.71 * TIME)
    given = given.with_values("torque_V", np.minimum(volts, LIMIT))
    found = flat_under_hum([given])
    assert found is not None
    assert found.limit == pytest.approx(LIMIT, abs=1e-3)
    assert flat_under_hum([given], full_range=LIMIT) is None
