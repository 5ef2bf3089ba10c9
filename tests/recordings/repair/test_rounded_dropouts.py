"""Dropouts behind a low-pass are found with their count and length, and none in recordings without them."""

from __future__ import annotations

import numpy as np
import pytest

from tests.recordings.repair.drawn_losses import CLEAN, Drawn, clean, lossy
from tests.recordings.repair.drawn_rig import RATE
from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.dropout_search import DropoutSearch
from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.recording_faults import recording_faults
from torquerig.recordings.run import Run

SHORT = 30.0  # [s] of the recordings that are drawn in every run of the tests
RESOLVED = 1.0  # length times cut-off from which on the length must be right


def found_in(drawn: Drawn) -> RoundedDropouts | None:
    search = DropoutSearch(RATE)
    for block in np.array_split(drawn.values, 7):
        search.add(block)
    return search.found()


def is_right(drawn: Drawn, found: RoundedDropouts | None) -> bool:
    """The count within a fifth or one, and the length within a fifth, or in the interval where it is not resolved."""
    if found is None or abs(len(found.starts) - drawn.count) > max(0.2 * drawn.count, 1):
        return False
    if drawn.length * drawn.low_pass >= RESOLVED:
        return abs(found.median_length - drawn.length) <= 0.2 * drawn.length
    return found.length[0] <= drawn.length <= found.length[1]


@pytest.mark.parametrize("number", [1, 3, 4])
def test_drawn_losses_are_found(number: int) -> None:
    drawn = lossy(number, duration=SHORT)
    assert drawn.count > 0
    assert is_right(drawn, found_in(drawn))


@pytest.mark.parametrize("number", [2, 8, 12], ids=lambda number: CLEAN[number % len(CLEAN)][0])
def test_what_could_mislead_is_no_loss(number: int) -> None:
    assert found_in(clean(number, duration=SHORT)) is None


@pytest.mark.long
def test_unit_and_sign_change_nothing() -> None:
    drawn = lossy(3, duration=SHORT)
    found = found_in(drawn)
    assert found is not None
    for factor in (-1.0, 1e3, -2e-4):
        other = found_in(Drawn(values=factor * drawn.values, unit=drawn.unit, kind=drawn.kind))
        assert other is not None
        assert other.starts == pytest.approx(found.starts, abs=1e-9)
        assert other.lengths == pytest.approx(found.lengths, abs=1e-9)
        assert other.level == pytest.approx(factor * found.level, rel=1e-6, abs=1e-9 * abs(factor))


@pytest.mark.long
def test_info_says_it_in_a_sentence() -> None:
    drawn = lossy(3, duration=SHORT)
    channel = Channel(values=drawn.values, quantity="torque", unit=drawn.unit, si_per_unit=drawn.nm_per_unit)
    info = recording_info(Recording(name="lost", sample_rate=RATE, channels={"torque": channel}, run=Run()))
    (sentence,) = info.suspicions()
    assert f"comes back {len(info['torque'].rounded_dropouts.starts)} times" in sentence


@pytest.mark.full
def test_of_a_hundred_at_least_ninety_five_are_found() -> None:
    right = [is_right(drawn, found_in(drawn)) for drawn in map(lossy, range(1000, 1100))]
    assert sum(right) >= 95


@pytest.mark.full
def test_of_a_hundred_clean_ones_none_is_lost() -> None:
    assert [number for number in range(1000, 1100) if found_in(clean(number)) is not None] == []


@pytest.mark.long
def test_all_commands_name_the_losses() -> None:
    (fault,) = recording_faults(recorded(lossy(3, duration=SHORT)))
    assert fault.mechanism == "signal_dropout"
    assert "falls to" in fault.seen
    assert recording_faults(recorded(clean(13, duration=SHORT))) == ()


def recorded(drawn: Drawn) -> Recording:
    channel = Channel(values=drawn.values, quantity="torque", unit=drawn.unit, si_per_unit=drawn.nm_per_unit)
    return Recording(name="drawn", sample_rate=RATE, channels={"torque": channel}, run=Run(speed=100.0))
