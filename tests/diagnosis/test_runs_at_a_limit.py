"""Which runs fits may use where some stand at a limit, and what is looked at of those that were put right."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.opening import _for_fits
from torquerig.diagnosis.sample_findings import SampleFindings
from torquerig.inference.places import order

TURNED = np.arange(30_000) / 5000.0 * 100.0  # [rad] 6 s at 100 rad/s
TORQUE = 1.0 + 0.1 * np.cos(3 * TURNED) + 0.01 * np.random.default_rng(1).standard_normal(TURNED.size)

ByHand = Callable[..., Observed]


def findings(*, clipped: Sequence[str], rebuilt: Sequence[str]) -> SampleFindings:
    return SampleFindings((), (), tuple(clipped), tuple(rebuilt), (), ())


@pytest.mark.parametrize(
    ("clipped", "rebuilt", "used"),
    [
        ("", "", "abc"),
        ("c", "c", "ab"),  # two whole ones suffice
        ("bc", "c", "ac"),  # one does not, and c was put right
        ("bc", "", "a"),
        ("abc", "b", "b"),
        ("abc", "", "abc"),  # better than none
    ],
)
def test_runs_that_were_put_right_serve_where_whole_ones_are_too_few(
    clipped: str, rebuilt: str, used: str, by_hand: ByHand
) -> None:
    runs = tuple(replace(by_hand(TORQUE, TURNED, name=name), rebuilt=name in rebuilt) for name in "abc")
    served = _for_fits(runs, findings(clipped=clipped, rebuilt=rebuilt))
    assert "".join(run.name for run in served) == used


def test_a_run_that_turns_is_no_second_steady_one(by_hand: ByHand) -> None:
    steady, ramp = by_hand(TORQUE, TURNED, name="a"), by_hand(TORQUE, TURNED, name="b", profile="ramp")
    cut = replace(by_hand(TORQUE, TURNED, name="c"), rebuilt=True)
    served = _for_fits((steady, ramp, cut), findings(clipped="c", rebuilt="c"))
    assert [run.name for run in served] == ["a", "b", "c"]


def test_of_a_run_that_was_put_right_the_lines_and_levels_are_seen_and_no_spectrum(by_hand: ByHand) -> None:
    whole = by_hand(TORQUE, TURNED)
    seen, put_right = (features(run, [order(3.0)]) for run in (whole, replace(whole, rebuilt=True)))
    assert np.isfinite(seen.power).any()
    assert np.isnan(put_right.power).all()
    assert put_right.power.shape == seen.power.shape
    assert np.array_equal(put_right.amplitude, seen.amplitude)
    assert np.array_equal(put_right.level, seen.level)
