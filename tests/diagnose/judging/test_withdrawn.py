"""What was found is believed where it predicts better what no fit has seen, and else withdrawn, with the reason."""

from __future__ import annotations

import pytest

from torquerig.diagnose.diagnosis import HeldOut, Mismatch
from torquerig.diagnose.judging.withdrawn import LEAVES_A_REST, why_withdrawn

A_LINE = Mismatch(
    domain="frequency", axis="Hz", at=50.0, width=1.0, recordings=("run1",), excess_dB=20.0, share_of_misfit=0.5,
    p_value=1e-9,
)  # fmt: skip


def fit(before: float, after: float, *, explained: float = 0.9) -> HeldOut:
    return HeldOut(
        nominal=before, before=before, after=after, improvement=(0.0, 0.0, 0.0), by_twin=False, explained=explained
    )


@pytest.mark.parametrize(("before", "after"), [(9.0, 0.8), (0.5, 0.4), (1.2, 1.19), (9.0, 7.0)])
def test_what_predicts_better_stays_where_nothing_is_left(before: float, after: float) -> None:
    assert why_withdrawn(fit(before, after), ()) == ""


def test_what_predicts_worse_is_withdrawn() -> None:
    assert "worse" in why_withdrawn(fit(0.8, 0.82), ())
    assert why_withdrawn(fit(0.8, 0.805), ()) == ""  # within chance


def test_what_hardly_predicts_better_is_withdrawn_where_something_is_clearly_missing() -> None:
    assert "hardly" in why_withdrawn(fit(9.0, 8.0), ())
    assert why_withdrawn(fit(1.2, 1.19), ()) == ""


def test_a_large_rest_tells_against_what_explains_little() -> None:
    assert why_withdrawn(fit(9.0, 6.0, explained=0.5), (A_LINE,)) == LEAVES_A_REST
    assert why_withdrawn(fit(9.0, 6.0, explained=0.5), ()) == ""
    assert why_withdrawn(fit(9.0, 6.0, explained=0.9), (A_LINE,)) == ""
    assert why_withdrawn(fit(9.0, 2.0, explained=0.5), (A_LINE,)) == ""  # a third of what was missing is left at most
