"""A line where two larger ones of the rig meet may be made of them by something that bends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.beginning import begun
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.judging.combined_lines import may_be_combined
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import Place, order
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

BENT = [
    Mismatch(
        domain="frequency", axis="Hz", at=183.0, width=20.0, recordings=("run2",), excess_dB=5.9, share_of_misfit=0.2,
        p_value=1e-15,
    )
]  # fmt: skip


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


def line(at: float, mechanism: str = "gear_mesh", price: float = 0.0) -> Candidate:
    return Candidate(mechanism=mechanism, parts=(), knobs=(), place=order(at), price=price)


@pytest.mark.long
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
    assert may_be_combined(with_line(seen, order(at), size), BENT, [line(at)]) is combined


@pytest.mark.long
def test_all_that_was_found_must_be_such_lines(seen: Case) -> None:
    both = with_line(with_line(seen, order(13.0), 1e-4), order(16.8), 1e-4)
    assert not may_be_combined(both, BENT, [line(13.0), line(16.8)])
    assert not may_be_combined(seen, BENT, [])


@pytest.mark.long
def test_where_the_motor_has_lines_they_are_its_own(seen: Case) -> None:
    """Order 42 is twice 21, and the sixth of seven pole pairs."""
    case = with_line(seen, order(42.0), 1e-4)
    assert not may_be_combined(case, BENT, [line(42.0, "commutation_ripple")])
    assert may_be_combined(case, BENT, [line(42.0, "commutation_ripple", price=23.0)])


@pytest.mark.long
def test_what_bends_is_wrong_in_the_spectrum(seen: Case) -> None:
    case = with_line(seen, order(13.0), 1e-4)
    assert not may_be_combined(case, [replace(BENT[0], domain="time")], [line(13.0)])
    assert not may_be_combined(case, [], [line(13.0)])
