"""What is found in two stretches joins to what is found in both at once, wherever the cut is."""

from functools import reduce

import numpy as np
import pytest

from torquerig.recordings.inspection.extremes import extreme_of, joined_extremes
from torquerig.recordings.inspection.histogram import histogram_of, joined_histograms
from torquerig.recordings.inspection.levels import joined_levels, levels_of
from torquerig.recordings.inspection.mean_power import joined_powers, mean_power_of
from torquerig.recordings.inspection.min_max_envelope import envelope_of, joined_envelopes
from torquerig.recordings.inspection.runs import Run, joined_repeats, joined_runs, not_numbers, repeats_of


def signal() -> np.ndarray:
    values = np.round(3 * np.random.default_rng(2).standard_normal(4000)) / 3 + 1e6
    values[100:140] = values[100]
    values[990:1020] = 1e6
    return values


CUTS = [[1000, 2000, 3000], [1000, 1010, 1015, 3999], [1]]


def pieces(values: np.ndarray, cuts: list[int]) -> list[tuple[int, np.ndarray]]:
    return list(zip([0, *cuts], np.split(values, cuts), strict=True))


@pytest.mark.parametrize("cuts", CUTS)
def test_levels(cuts: list[int]) -> None:
    joint = reduce(joined_levels, (levels_of(part) for _, part in pieces(signal(), cuts)))
    # a plain sum of squares would lose all twelve digits to the mean of a million
    assert joint.std == pytest.approx(np.std(signal() - 1e6), rel=1e-9)
    assert joint.mean == pytest.approx(signal().mean(), rel=1e-15)
    assert (joint.minimum, joint.maximum, joint.count) == (signal().min(), signal().max(), 4000)


def test_levels_leave_out_what_is_no_number() -> None:
    values = np.array([1.0, np.nan, 3.0, np.inf])
    assert (levels_of(values).count, levels_of(values).mean) == (2, 2.0)
    assert levels_of(np.full(3, np.nan)).count == 0
    assert joined_levels(levels_of(np.full(3, np.nan)), levels_of(values)) == levels_of(values)


@pytest.mark.parametrize("cuts", CUTS)
def test_repeats(cuts: list[int]) -> None:
    whole = repeats_of(signal())
    joint = reduce(joined_repeats, (repeats_of(part, first) for first, part in pieces(signal(), cuts)))
    assert joint == whole
    assert joint.stuck()[0].first in (99, 100)


def test_a_run_over_many_pieces_is_one() -> None:
    joint = reduce(joined_repeats, (repeats_of(np.full(10, 2.0), first) for first in range(0, 50, 10)))
    assert joint == repeats_of(np.full(50, 2.0))
    assert (joint.longest.length, joint.longest.first) == (50, 0)


@pytest.mark.parametrize("cuts", [[3], [4], [5], [1, 4, 6]])
def test_samples_that_are_no_numbers(cuts: list[int]) -> None:
    values = np.array([0.0, 1, 2, np.nan, np.inf, np.nan, 1, 2, np.nan])
    joint = reduce(joined_runs, (not_numbers(part, first) for first, part in pieces(values, cuts)))
    assert [(run.first, run.last) for run in joint] == [(3, 5), (8, 8)]


@pytest.mark.parametrize("cuts", CUTS)
def test_extremes(cuts: list[int]) -> None:
    values = np.minimum(signal(), 1e6 + 5)
    whole = extreme_of(values)
    joint = reduce(joined_extremes, (extreme_of(part) for _, part in pieces(values, cuts)))
    assert (joint.value, joint.count, joint.next_value, joint.next_count) == (
        whole.value, whole.count, whole.next_value, whole.next_count,
    )  # fmt: skip


@pytest.mark.parametrize("cuts", CUTS)
def test_histograms_count_every_sample_in_its_bin(cuts: list[int]) -> None:
    values = np.concatenate([signal()[:2000], 100 * signal()[2000:]])
    joint = reduce(joined_histograms, (histogram_of(part) for _, part in pieces(values, cuts)))
    assert joint is not None
    assert joint.counts.size <= 400
    assert np.array_equal(joint.counts, np.histogram(values, joint.edges())[0])
    assert joint.counts.sum() == values.size


def test_courses_keep_the_extremes() -> None:
    values = np.random.default_rng(1).standard_normal(2**16)
    values[7] = np.nan
    first, *others = np.split(values, 8)
    joint = envelope_of(first, width=4)
    for part in others:
        joint = joined_envelopes(joint, envelope_of(part, width=joint.width))
    assert 2000 < joint.low.size <= 4000
    by_hand = values.reshape(-1, joint.width)
    assert np.array_equal(joint.high, np.nanmax(by_hand, axis=1))
    assert np.array_equal(joint.low, np.nanmin(by_hand, axis=1))


def test_the_mean_power_of_a_sine_is_its_amplitude() -> None:
    wave = 3 * np.cos(2 * np.pi * 50 * np.arange(4000) / 1000)
    joint = joined_powers(mean_power_of(wave[:2500], segment=1000), mean_power_of(wave[2500:], segment=1000))
    frequencies, amplitudes = joint.spectrum(1000.0)
    assert joint.count == 3
    assert amplitudes[frequencies == 50] == pytest.approx(3.0)


def test_a_run_knows_its_last_sample() -> None:
    assert Run(first=5, length=3).last == 7
