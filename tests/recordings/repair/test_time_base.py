"""Samples written twice or lost: told, and their seams bridged, so that they fill no band above the shafts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.moments import seams
from torquerig.recordings.repair.time_base import broken_time
from torquerig.scenario.model import Scenario

RATE = 10_000.0  # [Hz]
STARTS = (21_000, 47_000)  # first samples of buffers that are written again
BUFFER = 300  # samples


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=8.0, rate=RATE, rpm=1000.0, occupancy=15.0)


@pytest.fixture(scope="module")
def broken(clean: Recording) -> Recording:
    """All channels fall behind by a buffer, twice, and the last samples were never written."""
    source = np.arange(clean.samples)
    for start in STARTS:
        source[start:] -= BUFFER
    spoilt = clean
    for name, channel in clean.channels.items():
        spoilt = spoilt.with_values(name, channel.values[source])
    return spoilt


def test_each_kind_of_sign_is_told_with_the_recording(clean: Recording, broken: Recording) -> None:
    found = broken_time([broken], renewed=[None])
    assert found.names == (broken.name,)
    assert any("samples repeat earlier ones exactly" in each.sentence for each in found.told)
    assert all(each.sentence.endswith("the seams were bridged") for each in found.told)
    whole = broken_time([clean], renewed=[None])
    assert (whole.names, whole.told, whole.seams) == ((), (), ([],))
    told_of_copies = [each.sentence for each in broken_time([broken], renewed=[None], repeating=[broken.name]).told]
    assert not any("repeat" in sentence for sentence in told_of_copies)


def test_seams_are_where_the_stream_breaks(broken: Recording) -> None:
    (found,) = broken_time([broken], renewed=[None]).seams
    for start in STARTS:
        assert any(first < start < stop for first, stop in found)
    assert all(stop - first == pytest.approx(0.003 * RATE, abs=1) for first, stop in found)
    assert seams([0, broken.samples], broken) == [(0, 15), (broken.samples - 15, broken.samples)]
