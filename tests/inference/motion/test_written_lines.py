"""A line without a name is written as a part that makes the effort of its columns."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.moved_rigs import CARRIAGE, recorded, scenario
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.hypotheses.waves import lines
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import imposed_runs
from torquerig.inference.motion.needed_effort import needed_effort

Floats = NDArray[np.float64]


def ripple(time: Floats, position: Floats, speed: Floats) -> Floats:
    return np.asarray(2.0 * np.cos(2 * np.pi * 30.0 * position + 0.4))


def test_a_line_over_the_place_is_in_the_written_model() -> None:
    rig = scenario(CARRIAGE).rig
    runs = imposed_runs([recorded(ripple)], rig)
    plain = fitted(Model(rig, ()), runs)
    assert plain is not None
    line, *others = lines(plain, "line_family", 1.0, [30.0], "cycles/m", places=100.0)
    assert [each.written is None for each in (line, *others)] == [False, True, True, True]
    assert line.written is not None
    assert line.columns is not None
    sizes = np.array([1.5, -0.7])
    (part,) = line.written(sizes)
    with_it, without = needed_effort(rig + part, runs[0]), needed_effort(rig, runs[0])
    assert with_it is not None
    assert without is not None
    inner = slice(100, -100)
    assert (with_it - without)[inner] == pytest.approx((line.columns(runs[0]) @ sizes)[inner], abs=0.02)
