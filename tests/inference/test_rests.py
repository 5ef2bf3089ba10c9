"""Rests of a torque near zero, and the width of a gap by them."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.blocks import Block
from torquerig.inference.features.rests import near_zero, rests
from torquerig.inference.gap_width import estimated_width
from torquerig.inference.prediction.gap_change import SimulatedRests

RATE, WINDOW = 1000.0, 0.002
WIDTHS = np.array([1.0, 2.0, 4.0, 8.0, 16.0])


def resting(length, period, *, seconds=10.0):
    """Return a torque of 1 N m that rests for ``length`` [s] once in ``period`` [s]."""
    phase = np.arange(int(seconds * RATE)) / RATE % period
    return np.where(phase < length, 0.0, 1.0)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("length", "period"), [(0.05, 0.5), (0.02, 0.1)])
def test_rests_are_counted_and_measured_in_both_directions(sign, length, period):
    torque = sign * resting(length, period)
    near = near_zero(torque, rate=RATE, window=WINDOW)
    often, long, *far = rests(torque, [Block(0, torque.size, False)], rate=RATE, window=WINDOW, near=near)
    assert near == pytest.approx(0.25, abs=0.01)
    assert np.exp(often) == pytest.approx(1 / period, rel=0.1)
    assert np.exp(long) == pytest.approx(length, rel=0.1)
    assert np.abs(far) == pytest.approx(0.0, abs=1e-6)


def test_impacts_on_the_other_flank_are_on_the_far_side():
    torque = resting(0.05, 0.5)
    torque[::20] -= 3.0
    far = rests(torque, [Block(0, torque.size, False)], rate=RATE, window=WINDOW, near=0.25)[2:]
    assert (far < -1.0).all()


def simulated(truth, *, seed, law=np.log, scatter=0.05):
    """Return rests that follow the width, of three replicates at all widths and measured at the true one."""
    rng = np.random.default_rng(seed)
    means = np.array([law(width) for width in (0.25, *WIDTHS)])[None, :, None] * np.array([1.0, -0.5])
    return SimulatedRests(
        law(truth) * np.array([1.0, -0.5]) + scatter * rng.standard_normal(2),
        means + scatter * rng.standard_normal((3, WIDTHS.size + 1, 2)),
    )


@pytest.mark.parametrize("truth", [1.5, 3.0, 10.0])
def test_the_width_is_that_at_which_simulated_rests_are_as_measured(truth):
    found = estimated_width([simulated(truth, seed=one) for one in range(2)], WIDTHS, median=6.0, spread=1.2)
    assert found.low < truth < found.high
    assert found.value == pytest.approx(truth, rel=0.2)
    assert found.gain > 3.0


def test_rests_that_do_not_depend_on_the_width_leave_the_prior():
    found = estimated_width([simulated(3.0, seed=1, law=lambda _: 0.0)], WIDTHS, median=4.0, spread=0.4)
    assert found.value == pytest.approx(4.0, rel=0.1)
    assert np.log(found.high / found.low) == pytest.approx(2 * 1.96 * 0.4, rel=0.1)
    assert abs(found.gain) < 0.5


def test_rests_of_a_rig_without_a_gap_speak_against_one():
    found = estimated_width([simulated(0.25, seed=1)], WIDTHS, median=6.0, spread=1.2)
    assert found.gain < -3.0


def test_rests_that_one_width_explains_well_determine_it_better():
    exact = [simulated(3.0, seed=one, scatter=0.003) for one in range(4)]
    rough = [SimulatedRests(each.measured + np.array([0.3, 0.3]), each.simulated) for each in exact]
    narrow, wide = (estimated_width(each, WIDTHS, median=6.0, spread=1.2) for each in (exact, rough))
    assert narrow.low < 3.0 < narrow.high
    assert narrow.high / narrow.low < 1.1
    assert wide.high / wide.low > 1.5
