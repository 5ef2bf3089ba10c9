"""A tone that lasts for half of a single run."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.features.line_search import search_lines


def half(seed, *, amplitude, rate=20000.0):
    run = drawn_run(seed, speed=steady(2000, rate=rate), rate=rate)
    time = np.arange(run.torque.size) / rate
    tone = amplitude * np.cos(2 * np.pi * 10.36 * time) * (time > 6.0)
    return replace(run, torque=run.torque + tone)


def found(run):
    return [line.place for line in search_lines([run], [], [lambda frequency: np.zeros(frequency.size)])]


def test_a_tone_of_half_a_run_is_found_in_blocks_that_have_one_spectrum():
    places = found(half(1, amplitude=0.3))
    assert ("frequency", pytest.approx(10.36, rel=0.01)) in [(place.domain, place.at) for place in places]


def test_what_one_block_shows_is_no_line():
    run = drawn_run(2, speed=steady(2000, rate=20000.0), rate=20000.0)
    time = np.arange(run.torque.size) / 20000.0
    burst = np.cos(2 * np.pi * 10.36 * time) * (time > 10.0)
    assert not found(replace(run, torque=run.torque + burst))
