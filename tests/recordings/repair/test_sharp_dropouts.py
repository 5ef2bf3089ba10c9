"""Coarse codes, flat tops and dropouts: found with the numbers that were put in, and never where none are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.mechanisms import Clipping, Quantization, SignalDropout
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.coarse_codes import coarse_codes
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.repair.moments import bridged
from torquerig.recordings.repair.sharp_dropouts import _gaps, dropouts, gaps, moments_lost
from torquerig.scenario.model import Scenario

FULL = 10.0  # [V] the converter's range
CODE = 2 * FULL / 2**16  # [V] and its step


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=4.0)


def with_volts(recording: Recording, volts: np.ndarray) -> Recording:
    return recording.with_values("torque_V", CODE * np.round(volts / CODE))


@pytest.mark.parametrize("step", [0.0011, 0.0077, 0.05])
def test_coarse_codes_are_found_with_their_step(step: float, clean: Recording) -> None:
    volts = clean.channels["torque_V"].values
    coarse = with_volts(clean, step * np.round(volts / step))
    found = coarse_codes([coarse], converter_step=CODE)
    assert found is not None
    assert found.step == pytest.approx(step, rel=1e-3)  # fine trials are 5e-6 apart; a wrong lattice is 8 % off


def test_the_converters_own_codes_are_not_coarse(clean: Recording) -> None:
    assert coarse_codes([clean], converter_step=CODE) is None


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_flat_tops_are_found_with_their_limit(sign: float, clean: Recording) -> None:
    volts = sign * clean.channels["torque_V"].values
    limit = float(np.quantile(np.abs(volts), 0.995))
    flat = with_volts(clean, np.clip(volts, -limit, limit))
    found = flat_tops([flat], full_range=FULL, code=CODE)
    assert found is not None
    assert found.limit == pytest.approx(limit, abs=CODE)
    assert found.share == pytest.approx(0.005, rel=0.1)
    assert found.runs == (clean.name,)


def test_a_reading_that_fills_the_converter_is_no_fault_of_the_amplifier(clean: Recording) -> None:
    volts = clean.channels["torque_V"].values
    limit = float(np.quantile(volts, 0.995))
    full = with_volts(clean, np.minimum(volts, limit))
    assert flat_tops([full], full_range=limit, code=CODE) is None


def test_the_last_coarse_code_below_the_converters_range_is_its_own_limit(clean: Recording) -> None:
    volts, code = clean.channels["torque_V"].values, 0.005
    limit = float(np.quantile(volts, 0.8))
    coarse = with_volts(clean, code * np.round(np.minimum(volts, limit) / code))
    top = float(coarse.channels["torque_V"].values.max())
    assert flat_tops([coarse], full_range=top + 0.4 * code, code=code) is None
    assert flat_tops([coarse], full_range=1.02 * top, code=code) is not None


def test_dropouts_are_found_with_length_rate_and_level(clean: Recording) -> None:
    volts, rate = clean.channels["torque_V"].values.copy(), clean.sample_rate
    starts, length, level = np.arange(1500, 19_000, 2500), round(0.006 * rate), -0.4
    for start in starts:
        volts[start : start + length] = level
    lost = with_volts(clean, volts)
    found = dropouts([clean, lost])
    assert found is not None
    assert found.count == starts.size
    assert found.duration == pytest.approx(0.006, abs=1 / rate)
    assert found.level == pytest.approx(level, abs=CODE)
    assert found.rate == pytest.approx(starts.size / (2 * clean.duration))
    assert found.runs == (lost.name,)


@pytest.mark.parametrize("lost", [True, False])
def test_dropouts_are_found_where_an_alias_goes_on(lost: bool, clean: Recording) -> None:
    """Its steps hide the jumps to zero and back."""
    volts, rate = clean.channels["torque_V"].values.copy(), clean.sample_rate
    starts, length = np.arange(1500, 19_000, 2500), round(0.015 * rate)
    volts *= 0.3
    for start in starts if lost else ():
        volts[start : start + length] = 0.0
    alias = 0.15 * np.cos(2 * np.pi * 1153.71 * np.arange(volts.size) / rate)
    volts = np.round((volts + alias) / CODE) * CODE
    assert not _gaps(volts, rate)
    assert [(start, stop) for start, stop, _ in gaps(volts, rate)] == [
        (start, start + length) for start in (starts.tolist() if lost else ())
    ]


def test_dropouts_are_found_where_a_hum_goes_on(clean: Recording) -> None:
    """The cable picks it up behind what was lost, so that the level sways with it; the noise before that is gone."""
    volts, time = clean.channels["torque_V"].values.copy(), np.arange(clean.samples) / clean.sample_rate
    starts = list(range(1500, volts.size - 800, 2700))
    for start in starts:
        volts[start : start + 130] = -5.0
    volts += 0.12 * np.cos(2 * np.pi * 50.03 * time)
    found = gaps(volts, clean.sample_rate)
    assert [(start, stop - start) for start, stop, _ in found] == [(start, 130) for start in starts]
    assert [level for _, _, level in found] == pytest.approx([-5.0] * len(starts), abs=0.12)


def test_bridging_takes_the_moments_out_and_leaves_the_rest(clean: Recording) -> None:
    volts = clean.channels["torque_V"].values.copy()
    volts[4000:4030] = -0.4
    lost = with_volts(clean, volts)
    mended = bridged(lost, moments_lost(lost)).channels["torque_V"].values
    assert gaps(mended, clean.sample_rate) == []
    assert mended[4000:4030].min() > 0.3
    kept = np.r_[0:3999, 4031 : volts.size]
    assert np.array_equal(mended[kept], lost.channels["torque_V"].values[kept])


def test_a_constant_signal_has_no_dropouts() -> None:
    assert gaps(np.ones(5000), 1000.0) == []


FAULTS = {
    "quantization": (Quantization(name="coarse", step=0.0123), {"step": 0.0123}),
    "clipping": (Clipping(name="flat", limit=1.3), {"limit": 1.3}),
    "signal_dropout": (SignalDropout(name="lost", duration=4e-3, rate=2.0), {"duration": 4e-3, "level": 0.0}),
}


def test_impacts_that_ring_are_no_dropouts(clean: Recording) -> None:
    """Half periods of a ring between two large steps last a moment and keep a level, but each its own."""
    volts = clean.channels["torque_V"].values.copy()
    time, rng = np.arange(400) / clean.sample_rate, np.random.default_rng(1)
    for start in range(1000, volts.size - 500, 900):
        volts[start : start + 400] += rng.uniform(0.5, 2) * np.sign(np.sin(2 * np.pi * 300 * time)) * np.exp(-60 * time)
    assert dropouts([with_volts(clean, volts)]) is None


def test_a_torque_that_runs_into_the_converters_end_is_no_dropout(clean: Recording) -> None:
    """It climbs there in a millisecond, and stands at one level for some more."""
    volts = clean.channels["torque_V"].values.copy()
    climb = np.concatenate([np.linspace(0, 14, 6), np.full(20, 14.0), np.linspace(14, 0, 6)])
    for start in (2000, 7000, 12_000):
        volts[start : start + climb.size] += climb
    assert dropouts([with_volts(clean, np.minimum(volts, FULL))]) is None


def test_a_signal_that_goes_on_at_another_level_is_not_lost(clean: Recording) -> None:
    """A telegraph: moments with an offset, in which the signal and its noise go on."""
    volts = clean.channels["torque_V"].values.copy()
    for start in range(1500, volts.size - 500, 2500):
        volts[start : start + 40] += 1.5
    assert dropouts([with_volts(clean, volts)]) is None


def test_signals_are_lost_between_coarse_codes_too(clean: Recording) -> None:
    """Where most samples share their code with the one before, the noise between samples is a code."""
    volts = clean.channels["torque_V"].values.copy() + 1.0
    for start in range(1500, volts.size - 500, 2500):
        volts[start : start + 40] = 0.0
    found = dropouts([clean.with_values("torque_V", 0.1 * np.round(volts / 0.1))])
    assert found is not None
    assert found.level == 0.0


def test_a_pile_at_zero_is_no_limit(clean: Recording) -> None:
    """A reading that stays at zero and goes below, or is largest the other way, is not clipped there."""
    volts = -np.abs(clean.channels["torque_V"].values)
    volts[::50] = 0.0
    assert flat_tops([with_volts(clean, volts)], full_range=FULL, code=CODE) is None


def test_of_several_moments_at_one_level_those_without_a_jump_count_too(clean: Recording) -> None:
    """Where the torque happens to pass the level of a lost signal, nothing jumps."""
    volts, rate = clean.channels["torque_V"].values.copy(), clean.sample_rate
    low = int(np.argmin(volts[: int(0.4 * volts.size)]))
    level, length = round(volts[low] / CODE) * CODE, round(0.02 * rate)
    starts = [low, int(0.5 * volts.size), int(0.7 * volts.size), int(0.9 * volts.size)]
    for start in starts[1:]:
        volts[start : start + length] += 1.0
    spoilt = with_volts(clean, volts)
    volts = spoilt.channels["torque_V"].values
    for start in starts:
        volts[start : start + length] = level
    found = gaps(volts, rate)
    assert [start for start, _, _ in found] == pytest.approx(starts, abs=2)


def test_a_moment_that_begins_and_ends_without_a_jump_is_lost_all_the_same(clean: Recording) -> None:
    """Where the torque passes zero no jump shows a lost signal, but its noise stands still."""
    volts, rate = clean.channels["torque_V"].values.copy(), clean.sample_rate
    start, stop = 4000, 4000 + round(0.034 * rate)
    volts -= np.linspace(volts[start], volts[stop], stop - start).mean()
    volts[start - 3 : start] = volts[stop : stop + 3] = [0.001, -0.002, 0.001]
    volts[start:stop] = 0.0
    lost = with_volts(clean, volts)
    ((first, last, level),) = gaps(lost.channels["torque_V"].values, rate)
    assert (first, level) == (pytest.approx(start, abs=1), 0.0)
    assert last == pytest.approx(stop, abs=1)
    volts[start:stop] += 0.002 * np.random.default_rng(1).standard_normal(stop - start)
    assert gaps(with_volts(clean, volts).channels["torque_V"].values, rate) == []


def test_what_is_held_over_and_over_is_not_lost_where_some_plateaus_share_a_level(clean: Recording) -> None:
    """A telemetry that renews its value every 3 ms jumps to each, and one in 22 stands still at the lowest."""
    rate, size, rng = clean.sample_rate, clean.channels["torque_V"].values.size, np.random.default_rng(2)
    long = round(3e-3 * rate)
    plateau = np.arange(size) // long
    held = (0.3 * rng.random(size // long + 1) + np.arange(size // long + 1) % 2)[plateau]
    held += CODE * rng.integers(-3, 4, size)
    held[plateau % 22 == 21] = -0.6
    assert gaps(with_volts(clean, held).channels["torque_V"].values, rate) == []


def test_noise_that_stays_at_zero_is_lost_only_as_quiet_as_noise(clean: Recording) -> None:
    """Between the pulses of a telephone an idle reading passes zero now and then, and its shafts go on."""
    volts, rate = clean.channels["torque_V"].values, clean.sample_rate
    noise = 0.01 * np.random.default_rng(2).standard_normal(volts.size)
    idle = 0.03 * np.sin(2 * np.pi * 97.0 * np.arange(volts.size) / rate) + noise
    for start in range(1000, volts.size - 600, 900):
        idle[start : start + 2] += 0.6
        idle[start + 104 : start + 106] += 0.6
    assert gaps(with_volts(clean, idle).channels["torque_V"].values, rate) == []


@pytest.mark.parametrize("share", [0.45, 0.7])
def test_a_signal_that_stands_at_its_limit_for_half_the_time_is_not_lost(share: float, clean: Recording) -> None:
    """Most samples then share their value with the one before, and the noise is that of those that do not."""
    volts = clean.channels["torque_V"].values
    limit = CODE * round(float(np.quantile(volts, 1 - share)) / CODE)
    clipped = with_volts(clean, np.minimum(volts, limit))
    assert flat_tops([clipped], full_range=FULL, code=CODE) is not None
    assert dropouts([clipped]) is None


def test_on_codes_as_coarse_as_a_sixth_of_the_reading_signals_are_lost_too(clean: Recording) -> None:
    volts = clean.channels["torque_V"].values.copy()
    step = float(np.median(volts)) / 6
    for start in (4000, 9000, 17_000):
        volts[start : start + 40] = 0.0
    found = dropouts([clean.with_values("torque_V", step * np.round(volts / step))])
    assert found is not None
    assert (found.level, found.count) == (0.0, 3)


def test_moments_that_no_jump_leads_into_are_found_by_their_quiet(clean: Recording) -> None:
    """A run that turns back passes zero: a signal that is lost there keeps its level, and its noise is gone."""
    rng, rate, samples = np.random.default_rng(4), clean.sample_rate, clean.samples
    time = np.arange(samples) / rate
    volts = 0.6 * np.sin(2 * np.pi * 0.5 * time) + 0.005 * rng.standard_normal(samples)
    lost = [
        (2_400, 2_600),
        (4_950, 5_100),
        (9_930, 10_080),
        (12_400, 12_600),
    ]  # at the crests, and where it passes zero
    for start, stop in lost:
        volts[start:stop] = 0.0
    tone = 0.04 * np.cos(2 * np.pi * 1153.71 * time)
    found = gaps(np.round((volts + tone) / CODE) * CODE, rate)
    assert [(start, stop) for start, stop, _ in found] == [pytest.approx(each, abs=6) for each in lost]
    assert [level for _, _, level in found] == pytest.approx([0.0] * 4, abs=1e-3)


def test_moments_near_the_level_that_they_fall_to_are_lost_where_others_are(clean: Recording) -> None:
    """An idle rig's torque passes zero, where a lost signal jumps once or not at all; the converter's noise goes on."""
    rng, rate, samples = np.random.default_rng(4), clean.sample_rate, clean.samples
    volts = 0.6 * np.sin(2 * np.pi * 0.5 * np.arange(samples) / rate) + 0.007 * rng.standard_normal(samples)
    lost = [(2_400, 2_422), (4_990, 5_012), (9_870, 9_892), (12_400, 12_422)]
    for start, stop in lost:
        volts[start:stop] = 0.4 * CODE * rng.standard_normal(stop - start)
    found = gaps(np.round(volts / CODE) * CODE, rate)
    assert [(start, stop) for start, stop, _ in found] == [pytest.approx(each, abs=2) for each in lost]
