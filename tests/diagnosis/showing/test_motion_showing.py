"""What a page shows of a rig under measured motion: courses by hand, no diagnosis."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.motion.lines import amplitudes, lines_and_rest, lines_in
from torquerig.diagnosis.motion.moved import Moved, moved
from torquerig.diagnosis.showing.motion_comparison import MotionCompared, most_gained
from torquerig.diagnosis.showing.motion_curves import held_pieces, level_over_speed, telling_window
from torquerig.recordings.recording import Channel, Recording
from torquerig.rig.parts import ImposedMotion

Floats = NDArray[np.float64]

RATE, COUNT, SPEED = 400.0, 8000, 0.05


@pytest.fixture(scope="module")
def run() -> Moved:
    """A carriage that goes forth and back twice at even speed, 0.25 m each."""
    time = np.arange(COUNT) / RATE
    place = SPEED * np.abs((time + 5.0) % 10.0 - 5.0)
    channels = {
        "force_N": Channel(values=np.full(COUNT, 20.0), quantity="force", unit="N"),
        "position_m": Channel(values=place, quantity="position", unit="m"),
    }
    recording = Recording(sample_rate=RATE, channels=channels, name="even.csv")
    return moved(recording, ImposedMotion(name="motion", at="carriage", channel="position"))


def beside(run: Moved, before: Floats, after: Floats | None = None) -> MotionCompared:
    """Return a run whose models leave these residuals."""
    first = run.effort - before
    return MotionCompared(run, first, first if after is None else run.effort - after)


def test_held_out_pieces_are_every_other_tenth_without_the_end(run: Moved) -> None:
    pieces = held_pieces(run)
    assert [piece.start for piece in pieces] == [800, 2400, 4000, 5600, 7200]
    assert [piece.stop for piece in pieces[:-1]] == [1600, 3200, 4800, 6400]
    assert pieces[-1].stop < COUNT
    assert sum(piece.stop - piece.start for piece in pieces) == np.count_nonzero(run.held)


def test_errors_are_of_held_out_samples_only(run: Moved) -> None:
    left = np.where(run.held, 2.0, 500.0)
    one = beside(run, left, np.where(run.held, 1.0, 900.0))
    assert one.left(one.before) == pytest.approx(2.0)
    assert one.error(one.after) == pytest.approx(0.05)
    assert one.gained == pytest.approx(0.05)
    assert not one.alone
    assert most_gained([beside(run, left), one]) is one
    assert beside(run, left).alone


def test_the_window_is_where_the_models_differ_most_and_has_a_dozen_swings(run: Moved) -> None:
    time = run.recording.time()
    loud = np.where((time > 10.0) & (time < 12.0), 3.0, 1.0)
    wave = loud * np.cos(2 * np.pi * 20.0 * time)
    window = telling_window(beside(run, wave, np.zeros(COUNT)))
    assert held_pieces(run)[2].start <= window.start < window.stop <= held_pieces(run)[2].stop
    assert (window.stop - window.start) / RATE == pytest.approx(12 / 20.0, rel=0.05)
    slow = telling_window(beside(run, np.sign(run.speed)))
    assert (slow.stop - slow.start) == 800


def test_the_level_over_speed_is_the_mean_of_what_is_left(run: Moved) -> None:
    forward = run.speed > 0
    level = level_over_speed([beside(run, np.where(forward, 5.0, -3.0), np.zeros(COUNT))])
    assert level.before[-8:] == pytest.approx(5.0)  # bins in the middle hold both ways
    assert level.before[:8] == pytest.approx(-3.0)
    assert level.after == pytest.approx(0.0)
    assert level.tolerance == pytest.approx(0.03 * 20.0, rel=1e-3)
    assert np.all(np.diff(level.speed) >= 0)


def test_lines_are_taken_out_of_the_spectrum_beside_them(run: Moved) -> None:
    """In the stretches a line has copies of 64 % at its sides; without it none is left."""
    noise = 0.1 * np.random.default_rng(5).standard_normal(COUNT)
    left = 2.0 * np.cos(2 * np.pi * 150.0 * run.position) + noise
    lines, rest = lines_and_rest([left], [run], held=True)
    assert {line.domain for line in lines} == {"order"}
    assert lines[0].at == pytest.approx(150.0, abs=0.5 * lines[0].width)
    assert lines[0].amplitude == pytest.approx(2.0, rel=0.05)
    assert all(line.amplitude < 0.05 * lines[0].amplitude for line in lines[1:])  # it is placed to a 40th of its width
    assert lines == lines_in([left], [run], held=True)
    places, sizes = amplitudes(rest, "order")
    assert places[0] < 150.0 < places[-1]
    assert sizes.max() < 0.05
    whole, copies = amplitudes([(left, run, run.held)], "order")
    assert copies[np.argmin(np.abs(whole - 150.0))] == pytest.approx(2.0, rel=0.1)
    assert np.count_nonzero(copies > 0.3) > 2


def test_no_spectrum_where_too_few_places_are_resolved(run: Moved) -> None:
    short = replace(run, held=run.held & (np.arange(COUNT) < 1000))
    _, rest = lines_and_rest([np.ones(COUNT)], [short], held=True)
    assert amplitudes(rest, "order")[0].size == 0
