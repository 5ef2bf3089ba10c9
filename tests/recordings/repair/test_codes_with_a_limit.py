"""Coarse codes of a reading that stops at a limit, which is on none of them."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.coarse_codes import coarse_codes
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.run import Run

CONVERTER, RANGE = 1e-4, 5.0  # [V]


def recording(volts):
    channel = Channel(values=volts, quantity="torque", unit="V")
    return Recording(sample_rate=1000.0, channels={"torque_V": channel}, run=Run(), name="run1")


def drawn(step, *, limit=np.inf, sd=3.0):
    volts = step * (33.2 + sd * np.random.default_rng(1).standard_normal(30_000))
    return recording(np.clip(step * np.round(volts / step), -limit, limit))


@pytest.mark.parametrize("off", [0.2, 0.35, 0.7])
@pytest.mark.parametrize("step", [0.0154605, 0.004321])
def test_neither_hides_the_other(step, off):
    limit = (34.0 + off) * step
    recorded = drawn(step, limit=limit)
    codes = coarse_codes([recorded], converter_step=CONVERTER)
    assert codes is not None
    assert codes.step == pytest.approx(step, rel=1e-6)
    cut = flat_tops([recorded], full_range=RANGE, code=codes.step, coarse=True)
    assert cut is not None
    assert cut.limit == pytest.approx(limit)


@pytest.mark.parametrize("sd", [1.0, 3.0, 10.0])
def test_codes_alone_have_no_limit(sd):
    recorded = drawn(0.0154605, sd=sd)
    codes = coarse_codes([recorded], converter_step=CONVERTER)
    assert codes is not None
    assert flat_tops([recorded], full_range=RANGE, code=codes.step, coarse=True) is None
