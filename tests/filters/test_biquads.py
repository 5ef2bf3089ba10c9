"""The compiled cascade against scipy to the last bit, its quiet edges, and the same in pieces."""

from math import pi

import numpy as np
import pytest
from scipy.signal import butter, iirnotch, sosfilt, sosfiltfilt

from torquerig.errors import RecordingError
from torquerig.filters.biquad_stream import causal_pieces, zero_phase_pieces
from torquerig.filters.biquads import cascaded, time_constants, zero_phase, zero_phase_notched
from torquerig.filters.edge_states import steady_states

RATE = 2500.0
CENTRES = (10 / 3, 20 / 3, 10.0, 40 / 3, 16.7, 33.4, 50.1, 66.8, 100.3, 116.7)
NOTCHES = np.array([np.concatenate(iirnotch(at, 30, RATE)) for at in CENTRES])
LOW_PASS = butter(5, 100, fs=RATE, output="sos")


def noise(samples, seed=0):
    return np.random.default_rng(seed).normal(size=samples)


@pytest.mark.long
@pytest.mark.parametrize("samples", [0, 1, 31, 32, 33, 1000, 10007])
@pytest.mark.parametrize("sections", [NOTCHES, NOTCHES[:1], np.vstack([NOTCHES, LOW_PASS, NOTCHES, NOTCHES])])
def test_the_cascade_is_scipys_to_the_last_bit(samples, sections):
    values = noise(samples)
    expected, states = sosfilt(sections, values, zi=np.full((len(sections), 2), 0.1)) if samples else (values, None)
    answer, after = cascaded(values, sections, states=np.full((len(sections), 2), 0.1))
    assert np.array_equal(answer, expected)
    assert states is None or np.array_equal(after, states)


@pytest.mark.parametrize("sections", [NOTCHES, LOW_PASS, np.vstack([NOTCHES, LOW_PASS, NOTCHES, NOTCHES])])
def test_both_ways_is_sosfiltfilt_to_the_last_bit(sections):
    values = 3.0 + noise(5003)
    assert np.array_equal(zero_phase(values, sections), sosfiltfilt(sections, values))


@pytest.mark.long
def test_away_from_the_edges_quiet_ends_change_no_bit():
    values = 3.0 + noise(300_000)
    changed = np.flatnonzero(zero_phase_notched(values, NOTCHES) != sosfiltfilt(NOTCHES, values))
    died = int(30 * time_constants(NOTCHES).max())
    assert changed.size > 0
    assert not ((changed > died) & (changed < values.size - died)).any()


# lines 0.2 % off the notches, and more, are passed in part and never stop ringing in the middle either
@pytest.mark.parametrize("beside", [1.0, 1.001, 1.002, 1.005])
@pytest.mark.parametrize("mean", [0.0, 4.0])
def test_the_first_second_is_as_right_as_the_middle(mean, beside):
    # handbook B1: a 3.3 Hz notch at Q 30 (time constant 3 s) leaves 0.32 N m there, 3.4 times the middle
    at, rng = np.arange(100_000) / RATE, np.random.default_rng(7)
    load = mean + 0.1 * rng.normal(size=at.size)
    lines = sum(0.5 * np.cos(2 * pi * beside * centre * at + rng.uniform(0, 2 * pi)) for centre in CENTRES)
    second, middle = int(RATE), slice(40_000, 60_000)
    wrong = zero_phase_notched(load + lines, NOTCHES) - load
    scipys = sosfiltfilt(NOTCHES, load + lines) - load
    assert np.std(wrong[:second]) < 1.5 * np.std(wrong[middle])
    assert np.std(wrong[-second:]) < 1.5 * np.std(wrong[middle])
    if beside == 1.0:
        assert np.std(scipys[:second]) > 5 * np.std(wrong[:second])


def test_a_load_that_climbs_is_not_taken_for_a_line():
    at = np.arange(100_000) / RATE
    climbing = 1.0 + 0.2 * at
    wrong = zero_phase_notched(climbing, NOTCHES) - climbing
    assert np.abs(wrong).max() < 0.02


def test_a_constant_stays_and_a_short_edge_does_no_harm():
    assert zero_phase_notched(np.full(5000, 2.5), NOTCHES) == pytest.approx(2.5, abs=1e-9)
    values = 1.0 + 0.1 * noise(70)  # a fiftieth of a second: no notch has three periods
    assert np.array_equal(zero_phase_notched(values, NOTCHES[:9]), sosfiltfilt(NOTCHES[:9], values))


def test_causal_pieces_are_the_whole_to_the_last_bit():
    values = noise(10_000)
    pieces = np.split(values, [0, 1, 5, 700, 701, 4096])
    assert np.array_equal(np.concatenate(list(causal_pieces(pieces, NOTCHES))), sosfilt(NOTCHES, values))


@pytest.mark.long
def test_zero_phase_pieces_are_the_whole_but_for_the_stated_share():
    at = np.arange(600_000) / RATE
    values = 1.0 + 0.1 * noise(at.size) + sum(0.5 * np.cos(2 * pi * centre * at) for centre in CENTRES)
    pieces = list(zero_phase_pieces(np.array_split(values, 97), NOTCHES))
    assert len(pieces) > 3
    whole = zero_phase_notched(values, NOTCHES)
    # e^-14 is 8e-7; the states at the inner ends are wrong by less than one line's half
    assert np.concatenate(pieces) == pytest.approx(whole, abs=4e-7)
    shorter = np.concatenate(list(zero_phase_pieces(np.array_split(values, 97), NOTCHES, spans=7.0)))
    assert np.abs(shorter - whole).max() > 4e-7


def test_steady_states_are_those_that_a_long_past_leaves():
    at = np.arange(-400_000, 0)
    angles, amplitudes = np.array([0.0, 1e-3, 0.3]), np.array([2.0, 0.5 - 0.2j, 0.1j])
    past = (amplitudes[:, None] * np.exp(1j * np.outer(angles, at))).sum(axis=0).real
    _, states = cascaded(past, NOTCHES)
    # what began 400 000 samples ago has died to e^-14 and less
    assert steady_states(amplitudes, angles, NOTCHES) == pytest.approx(states, abs=1e-5)


def test_too_few_samples_are_refused():
    with pytest.raises(RecordingError, match="too few for 10 biquads"):
        zero_phase(np.zeros(63), NOTCHES)


def test_no_sections_change_nothing():
    values = noise(10)
    assert np.array_equal(zero_phase(values, NOTCHES[:0]), values)
    assert np.array_equal(cascaded(values, NOTCHES[:0])[0], values)
