"""A limit within coarse codes: few of them hold the tail, which thins out and then piles up on the last."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.scenario.model import Scenario

FULL = 10.0  # [V] the converter's range
CODES = 40  # over the reading of a heavy load


@pytest.fixture(scope="module")
def loaded(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=6.0, occupancy=15.0)


@pytest.mark.parametrize(("share", "found"), [(0.10, True), (0.0, False)])
def test_a_limit_gathers_what_would_lie_beyond_it(share: float, found: bool, loaded: Recording) -> None:
    """The last code holds a third more than that before it, and not twice the five before it."""
    volts = loaded.torque_values()
    code, limit = float(np.ptp(volts)) / CODES, float(np.quantile(volts, 1 - share))
    coarse = loaded.with_values(loaded.torque_name(), code * np.round(np.minimum(volts, limit) / code))
    told = flat_tops([coarse], full_range=FULL, code=code, coarse=True)
    assert (told is not None) == found
    if told is not None:
        assert told.limit == pytest.approx(limit, abs=0.5 * code)
        assert flat_tops([coarse], full_range=FULL, code=code) is None, "of fine codes more is asked"


@pytest.mark.parametrize("size", [6.0, 6.4, 6.8, 7.2])
def test_the_end_of_a_tone_is_no_limit(size: float, loaded: Recording) -> None:
    """It holds more than the code before it as well, which holds hardly less than the next."""
    rng, time = np.random.default_rng(1), np.arange(loaded.samples) / loaded.sample_rate
    tone = size * np.sin(2 * np.pi * 31.7 * time) + 0.1 * rng.standard_normal(time.size)
    coarse = loaded.with_values(loaded.torque_name(), np.round(tone))
    assert flat_tops([coarse], full_range=FULL, code=1.0, coarse=True) is None
