"""Covariance of mean torques by lines that are slower than their parts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp
from torquerig.inference.features.run_features import run_features
from torquerig.inference.prediction import slow_lines
from torquerig.inference.prediction.slow_lines import UnshownLines, covariance_of_lines


@pytest.fixture(params=[True, False], ids=["encoder", "no angle"])
def seen(request):
    return run_features(replace(drawn_run(1, speed=ramp(300)), has_encoder=request.param), [])


def drawn_lines(seen, *orders):
    square = np.random.default_rng(2).uniform(0.5, 2.0, (len(orders), len(seen.segments)))
    return UnshownLines(np.array(orders), square, follows=True)


def test_the_covariance_is_that_of_means_of_waves_of_one_phase(seen):
    lines = drawn_lines(seen, 0.3, 0.7, 0.3)
    phase, uncertain = slow_lines._phases(seen, follows=True)
    expected = np.zeros(uncertain.shape)
    for order, square in zip(lines.at, lines.square, strict=True):
        turned = order * np.ptp(phase, axis=1) < 2 * np.pi * slow_lines._MOST_PERIODS
        mean = np.exp(1j * order * phase).mean(axis=1) * turned * np.sqrt(square[seen.level_segment])
        expected += np.outer(mean, mean.conj()).real * np.exp(-0.5 * (order * uncertain) ** 2)
    assert uncertain.any() != seen.run.has_encoder
    assert covariance_of_lines(seen, lines) == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_the_means_of_a_line_are_made_once_whatever_other_lines_there_are(seen, monkeypatch):
    made, mean_of = [], slow_lines._mean_of
    monkeypatch.setattr(slow_lines, "_mean_of", lambda order, phase: made.append(order) or mean_of(order, phase))
    for orders in ((0.3,), (0.3, 0.7), (0.7, 0.3, 900.0)):
        covariance_of_lines(seen, drawn_lines(seen, *orders))
    assert made == [0.3, 0.7]
