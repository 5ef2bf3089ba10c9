import numpy as np
import pytest

from torquerig.filters.selected_bins import bins_at, bins_within, signal_of

# dealt to 64 rows, to 16, and not at all: too short, or odd
SIZES = (3 * 2**15, 70_000, 2**16 + 1, 100)


@pytest.mark.parametrize("size", SIZES)
def test_bins_are_those_of_the_whole_transform(size):
    values = 3.0 + np.random.default_rng(size).normal(size=size)
    wanted = np.unique(np.linspace(0, size // 2, 90).astype(np.int64))
    whole = np.fft.rfft(values)
    # rounding of sums over all samples
    assert bins_at(values, wanted) == pytest.approx(whole[wanted], abs=1e-15 * size * 3)


@pytest.mark.long
@pytest.mark.parametrize("size", SIZES)
def test_a_signal_of_some_bins_is_that_of_a_spectrum_with_nothing_else(size):
    rng = np.random.default_rng(size)
    wanted = np.unique(np.linspace(0, size // 2, 40).astype(np.int64))
    bins = rng.normal(size=wanted.size) + 1j * rng.normal(size=wanted.size)
    spectrum = np.zeros(size // 2 + 1, dtype=np.complex128)
    spectrum[wanted] = bins
    assert signal_of(bins, wanted, size) == pytest.approx(np.fft.irfft(spectrum, n=size), abs=1e-14)


def test_bins_within_bands_count_each_once_and_never_the_mean():
    assert bins_within(1000, 1000.0, [(-1.0, 2.0), (1.5, 4.0), (499.5, 600.0)]).tolist() == [1, 2, 3, 4, 500]
