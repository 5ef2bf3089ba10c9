"""The spread of what is normal, beside values that are not."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.recordings.repair.robust_spread import spread_about_median, spread_about_zero


def test_few_large_values_do_not_count() -> None:
    values = 0.3 * np.random.default_rng(1).standard_normal(20_000)
    values[::100] = 50.0
    assert spread_about_zero(values) == pytest.approx(0.3, rel=0.03)
    assert spread_about_median(values + 7.0) == pytest.approx(spread_about_median(values))
    assert spread_about_zero(values + 7.0) > 5.0
