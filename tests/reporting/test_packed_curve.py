"""Curves of a page: packed without a loss that shows, and without any for the codes of a converter."""

import gzip
from base64 import b64decode

import numpy as np
import pytest

from torquerig.reporting.moving.packed_curve import STEPS, converter_step, packed_curve


def unpacked(curve):
    """What ``unpackCurve`` of pyramid.js does."""
    planes = np.frombuffer(gzip.decompress(b64decode(curve["packed"])), np.uint8)
    count = curve["samples"]
    signless = planes[:count].astype(np.int64) | planes[count:].astype(np.int64) << 8
    codes = np.cumsum((signless >> 1) ^ -(signless & 1)) & 0xFFFF
    return curve["low"] + codes * curve["size"]


def test_each_value_is_off_by_half_a_step_at_most():
    rng = np.random.default_rng(3)
    values = np.concatenate([rng.standard_normal(5000), [40.0, -40.0, 40.0]])  # steps over the whole span wrap around
    curve = packed_curve(values, start=0.0, step=1e-3)
    assert np.abs(unpacked(curve) - values).max() <= 0.5001 * np.ptp(values) / STEPS
    assert len(curve["packed"]) < 3 * values.size


def test_the_codes_of_a_converter_come_back_exactly_and_take_less_space():
    step = 20 / 2**16
    noise = 0.005 * np.random.default_rng(4).standard_normal(20_000) + np.sin(np.arange(20_000) / 99)
    codes = step * np.round(noise / step)
    curve = packed_curve(codes, start=0.0, step=1e-3)
    assert curve["size"] == pytest.approx(step)
    assert unpacked(curve) == pytest.approx(codes, abs=1e-12)
    assert len(curve["packed"]) < 0.75 * len(packed_curve(noise, start=0.0, step=1e-3)["packed"])
    assert converter_step(noise) == 0.0


def test_a_coarser_step_is_kept_and_flat_or_empty_curves_are_packed():
    values = np.random.default_rng(5).standard_normal(3000)
    assert packed_curve(values, start=0.0, step=1.0, coarsest=0.01)["size"] == 0.01
    for flat in (np.full(7, 2.5), np.empty(0)):
        assert unpacked(packed_curve(flat, start=0.0, step=1.0)) == pytest.approx(flat)


def test_the_same_curve_gives_the_same_text():
    values = np.random.default_rng(6).standard_normal(100)
    assert packed_curve(values, start=0.0, step=1.0) == packed_curve(values.copy(), start=0.0, step=1.0)
