"""A line where two larger ones of the rig meet may be made of them by something that bends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnose.beginning import begun
from torquerig.diagnose.case import Case
from torquerig.diagnose.judging.combined_lines import may_be_combined
from torquerig.diagnose.looking.places import Place, order
from torquerig.scenario.reading import Scenario
from torquerig.signals.recording import Recording


@pytest.fixture(scope="module")
def seen(known_rig: Scenario, three_runs: Callable[..., list[Recording]]) -> Case:
    return begun(known_rig, (), three_runs(known_rig.rig, 3), lambda _: None).before


def with_line(case: Case, place: Place, size: float) -> Case:
    """Return the case whose runs show one line more, so many times as large as each run's largest."""
    seen = []
    for features in case.seen:
        largest = np.nanmax(np.abs(features.amplitude), initial=0.0)
        column = np.full((len(features.stretches), 1), size * largest, dtype=complex)
        seen.append(
            replace(
                features, places=(*features.places, place), amplitude=np.hstack([features.amplitude, column]),
                unknown=(place,),
            )
        )  # fmt: skip
    return replace(case, seen=tuple(seen))


@pytest.mark.parametrize(
    ("at", "size", "combined"),
    [
        (13.0, 1e-4, True),  # of 6 and 7
        (13.0, 2.0, False),  # larger than both
        (16.8, 1e-4, False),  # of no two
        (12.4, 1e-4, True),  # of 12 and two fifths
    ],
)
def test_a_small_line_where_two_meet(seen: Case, at: float, size: float, combined: bool) -> None:
    assert may_be_combined(with_line(seen, order(at), size), [order(at)]) is combined


def test_all_that_was_found_must_be_such_lines(seen: Case) -> None:
    both = with_line(with_line(seen, order(13.0), 1e-4), order(16.8), 1e-4)
    assert not may_be_combined(both, [order(13.0), order(16.8)])
    assert not may_be_combined(seen, [])
