"""Random telegraph noise: its height to a per cent, its jumps to a sample; never seen in what comes back at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.telegraph_noise import Telegraph, telegraph_noise, without_telegraph
from torquerig.scenario.model import Scenario

RATE = 10_000.0  # [Hz]
FLIPS = [(9_000, 17_000, 17_400, 30_000), (6_000, 31_000, 44_000, 61_000, 61_300), (40_000, 52_000)]
CODE = 10.0 / 2**15  # [V] of the wear rig's converter


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> list[Recording]:
    plan = [(1000.0, "steady", 5.0), (700.0, "steady", 0.0), (1000.0, "ramp", 0.0)]
    return [
        record(wear_rig.rig, 3 + index, duration=8.0, rate=RATE, rpm=rpm, profile=profile, occupancy=occupancy)
        for index, (rpm, profile, occupancy) in enumerate(plan)
    ]


def volts_of(recording: Recording) -> np.ndarray:
    return recording.channels["torque_V"].values.copy()


def levels(samples: int, flips: Sequence[int], *, takes: int = 1) -> np.ndarray:
    flip = np.zeros(samples)
    flip[list(flips)] = 1.0
    level = np.cumsum(flip) % 2
    total = np.concatenate([[0.0], np.cumsum(np.concatenate([np.full(takes - 1, level[0]), level]))])
    return (total[takes:] - total[:-takes]) / takes


def jumping(clean: Sequence[Recording], height: float, *, takes: int = 1) -> list[Recording]:
    return [
        each.with_values("torque_V", volts_of(each) + height * levels(each.samples, flips, takes=takes))
        for each, flips in zip(clean, FLIPS, strict=True)
    ]


def found_in(recordings: Sequence[Recording]) -> tuple[Telegraph | None, ...]:
    return telegraph_noise(recordings, [()] * len(recordings), resolution=CODE)


@pytest.mark.long
@pytest.mark.parametrize("height", [0.15, 1.5, -0.6])
def test_it_is_found_to_the_sample_and_taken_out(height: float, clean: list[Recording]) -> None:
    spoilt = jumping(clean, height)
    found = found_in(spoilt)
    for own, flips in zip(found, FLIPS, strict=True):
        assert own is not None
        assert own.jumps == flips
        assert own.height == pytest.approx(abs(height), rel=0.03)
        assert own.up == (height > 0)
    level = without_telegraph(spoilt, found)
    assert all(not each for each in level.moments)
    assert [abs(volts) for volts in level.to_the_other] == pytest.approx([abs(height)] * len(clean), rel=0.03)
    for after, before in zip(level.recordings, clean, strict=True):
        assert np.abs(volts_of(after) - volts_of(before)).max() < 0.03 * abs(height)


@pytest.mark.parametrize("takes", [3, 7])
def test_jumps_that_a_filter_has_slowed_are_found_too(takes: int, clean: list[Recording]) -> None:
    spoilt = jumping(clean, 0.8, takes=takes)
    found = found_in(spoilt)
    level = without_telegraph(spoilt, found)
    for own, flips, after, before, left_out in zip(found, FLIPS, level.recordings, clean, level.moments, strict=True):
        assert own is not None
        assert own.lag >= takes - 1
        assert own.jumps == pytest.approx(flips, abs=2 * own.lag)
        kept = np.ones(before.samples, dtype=bool)
        for start, stop in left_out:
            kept[start : stop + own.lag] = False
        assert np.abs(volts_of(after) - volts_of(before))[kept].max() < 0.05
        assert kept.mean() > 0.99


def test_clean_runs_have_none(clean: list[Recording]) -> None:
    assert found_in(clean) == (None, None, None)


def test_blows_and_bursts_come_back_at_once(clean: list[Recording]) -> None:
    blow, burst = [], []
    for each, flips in zip(clean, FLIPS, strict=True):
        time = np.arange(each.samples) / RATE
        blows, bursts = volts_of(each), volts_of(each)
        for at in (*flips, *(flip + 3000 for flip in flips)):
            blows[at] += 1.0
            bursts += (
                1.0 * (time >= at / RATE) * np.cos(2e4 * (time - at / RATE)) * np.exp(-900 * np.abs(time - at / RATE))
            )
        blow.append(each.with_values("torque_V", blows))
        burst.append(each.with_values("torque_V", bursts))
    assert found_in(blow) == found_in(burst) == (None, None, None)


def test_the_ends_of_moments_without_signal_are_none(clean: list[Recording]) -> None:
    spoilt = jumping(clean, 0.8)
    ends = [[(at - 1, at + 1) for at in flips] for flips in FLIPS]
    assert telegraph_noise(spoilt, ends, resolution=CODE) == (None, None, None)


def test_a_signal_that_is_lost_to_one_level_has_none(clean: list[Recording]) -> None:
    """Then the level is the same and the way to it is not; whatever sways it, nobody needs to have seen it as lost."""
    spoilt = []
    for each, flips in zip(clean, FLIPS, strict=True):
        volts, time = volts_of(each), np.arange(each.samples) / RATE
        for start in (*flips, *(flip + 3000 for flip in flips)):
            volts[start : start + 270] = -5.0
        spoilt.append(each.with_values("torque_V", volts + 0.1 * np.cos(2 * np.pi * 50.0 * time)))
    assert found_in(spoilt) == (None, None, None)


def test_what_rests_on_coarse_codes_has_none(clean: list[Recording]) -> None:
    code = 0.25
    coarse = [each.with_values("torque_V", code * np.round(volts_of(each) / code)) for each in clean]
    assert telegraph_noise(coarse, [()] * 3, resolution=code) == (None, None, None)


def test_a_load_that_rises_and_falls_twice_is_none(clean: list[Recording]) -> None:
    """Few steps, of other heights: those are told as steps of the mean."""
    time = np.arange(clean[0].samples)
    spoilt = [
        each.with_values("torque_V", volts_of(each) + height * ((time > 20_000) & (time < 50_000)))
        for each, height in zip(clean, (0.5, 0.9, 1.4), strict=True)
    ]
    assert found_in(spoilt) == (None, None, None)


def test_it_is_found_beside_a_bearing_that_rings(clean: list[Recording]) -> None:
    """Blows that ring at 1 kHz have differences as clear as the jumps; none of them stands alone."""
    since = (np.arange(clean[0].samples) / RATE + 0.02) % (1 / 30.0)  # the last blow [s]
    ring = 0.3 * np.exp(-600.0 * since) * np.sin(2 * np.pi * 1000.0 * since)
    ringing = [each.with_values("torque_V", volts_of(each) + ring) for each in clean]
    assert found_in(ringing) == (None,) * len(clean)
    for own, flips in zip(found_in(jumping(ringing, 0.9)), FLIPS, strict=True):
        assert own is not None
        assert own.jumps == flips
        assert own.height == pytest.approx(0.9, rel=0.1)
