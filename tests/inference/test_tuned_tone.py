"""The frequency of a tone, finer than single blocks give it."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.features.line_search import search_lines


@pytest.mark.parametrize("at", [2.336, 41.555])
def test_a_tone_of_short_runs_is_found_within_a_percent(at):
    runs = [drawn_run(seed, speed=steady(rpm, duration=6.0), tones={at: 0.1})
            for seed, rpm in enumerate((900, 1100, 1400))]  # fmt: skip
    found = search_lines(runs, [], [lambda frequency: np.zeros(frequency.size)] * 3)[0].place
    assert (found.domain, found.at) == ("frequency", pytest.approx(at, abs=0.012))  # a fortieth of a bin of a block
