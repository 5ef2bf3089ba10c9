"""What all lines have in common from block to block: a gain of the reading, and nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.features.common_changes import common_changes
from torquerig.inference.features.run_features import run_features
from torquerig.inference.places import order
from torquerig.inference.prediction.reading_courses import courses
from torquerig.sensor_stages.course import Course

ORDERS = {1.0: 0.1, 3.0: 0.05, 7.0: 0.2, 12.0: 0.1}
STEADY = 0.03  # [1] of a logarithm: what the lines of a steady gain may show by random errors, three of their sd


class Rig:
    """A rig of which only its stages are known."""

    def __init__(self, *stages):
        self._stages = stages

    def stages(self):
        return self._stages


def seen_with(change, *, speed=None, noise=0.01):
    """Return the features of a run at 2 N m with four lines, its torque changed."""
    run = drawn_run(3, speed=steady(900) if speed is None else speed, orders=ORDERS, noise=noise, level=2.0)
    share = np.arange(run.torque.size) / run.torque.size
    return run_features(replace(run, torque=change(run.torque, share)), [order(each) for each in ORDERS])


def test_lines_follow_a_gain_that_settles():
    gain = Course(shape="settling", at=0.2, gain=0.1)
    seen = seen_with(lambda torque, share: torque * (1 + gain.gain * gain.course(share)))
    (found,) = common_changes(seen)
    expected = found.contrasts @ courses(Rig(gain), seen).blocks[0]
    assert np.abs(expected).max() > 0.05
    assert found.value == pytest.approx(expected, abs=STEADY / 3)
    assert found.sd < STEADY


def test_a_zero_that_moves_leaves_the_lines():
    zero = Course(shape="settling", at=0.2, zero=0.2)
    (found,) = common_changes(seen_with(lambda torque, share: torque + zero.zero * zero.course(share)))
    assert np.abs(found.value).max() < STEADY


def test_a_line_that_fades_alone_is_no_common_change():
    phase = 7.0 * 900 * np.pi / 30 * np.arange(24_000) / 2000

    def faded(torque, share):
        return torque + 0.3 * share * np.cos(phase)

    (found,) = common_changes(seen_with(faded))
    assert np.abs(found.value).max() < STEADY


def test_few_lines_and_swept_speeds_show_none():
    assert not common_changes(seen_with(lambda torque, _: torque, speed=ramp(900)))
    assert not common_changes(seen_with(lambda torque, _: torque, noise=5.0))
