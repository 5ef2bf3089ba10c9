"""Blocks of a run cover it, hold one speed, and leave every third one out."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tests.inference.drawn_runs import ramp, steady
from torquerig.inference.blocks import MOST, MOST_SWEPT, SPEED_RANGE, blocks_of


@pytest.mark.parametrize("speed", [steady(1000), ramp(1500), -ramp(1500), 100 * np.sin(np.linspace(0, 12, 24_000))])
def test_blocks_cover_all_samples_once(speed):
    blocks = blocks_of(speed)
    assert blocks[0].start == 0
    assert blocks[-1].stop == speed.size
    assert all(one.stop == other.start for one, other in pairwise(blocks))
    assert [block.held_out for block in blocks] == [index % 3 == 1 for index in range(len(blocks))]


def test_a_run_at_one_speed_has_few_blocks_of_about_one_length():
    blocks = blocks_of(steady(1000))
    assert len(blocks) == MOST
    shortest = 24_000 // MOST_SWEPT  # ends are looked for at every eighth of it
    assert all(abs(block.stop - block.start - 24_000 / MOST) < shortest / 2 for block in blocks)


def test_the_speed_of_a_block_hardly_changes():
    speed = ramp(1500)
    for block in blocks_of(speed):
        own = speed[block.samples]
        short = own.size <= 1.3 * 24_000 / MOST_SWEPT  # a block is looked at in eighths of the shortest one
        assert short or own.max() / own.min() - 1 < 1.3 * SPEED_RANGE
