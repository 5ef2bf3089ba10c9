"""Places at which a model still differs: the largest residuals of a kind that are not neighbours."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.adequacy import Excess, judged_run
from torquerig.inference.answer.located import _peaks
from torquerig.inference.features.run_features import run_features
from torquerig.inference.likelihood import BAND, LEVEL, Residuals


@pytest.mark.parametrize("kind", [LEVEL, BAND])
def test_neighbours_and_small_residuals_are_no_places(kind):
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    shown = np.arange(seen.level.size) if kind == LEVEL else np.flatnonzero(np.isfinite(seen.band_power[0]))[:16]
    value = np.zeros(shown.size)
    value[1], value[2], value[11], value[15] = 10.0, 9.0, -8.0, 4.0
    segment = np.full(shown.size, -1 if kind == LEVEL else 0)
    each = Residuals(value, np.ones(shown.size), np.full(shown.size, kind, dtype=np.int8), shown, segment)
    first = Excess("largest", 1e-9, 0, kind, 1, 1.0)
    assert [one.row for one in _peaks([judged_run(seen, each)], first)] == [1, 11]
