"""Currents turn with the field: a ripple at an order that is no multiple of the pole pairs pays for it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import cogging, commutation_ripple
from torquerig.inference.places import order


@pytest.mark.parametrize(("line", "dearer"), [(42.0, False), (14.0, False), (60.0, True), (36.0, True)])
def test_a_ripple_turns_with_the_field(line: float, dearer: bool, with_lines_left: Callable[..., Case]) -> None:
    """The rig's motor has 12 slots and 7 pole pairs; its slots make cogging at 36 and 60, no current does."""
    case = with_lines_left(line)
    ripple, *further = [each for each in commutation_ripple.propose(case) if each.place == order(line)]
    assert [len(each.knobs) for each in further] == ([] if dearer else [2]), "and the same with a second harmonic"
    assert (ripple.price > 50) is dearer
    if dearer:
        (slots,) = cogging.propose(case)
        assert ripple.price > 10 * slots.price


@pytest.mark.parametrize(("multiple", "free"), [(1, True), (2, True), (6, True), (18, True), (5, False), (8, False)])
def test_balanced_phases_have_torque_at_the_sixth_and_its_multiples(
    multiple: int, free: bool, with_lines_left: Callable[..., Case]
) -> None:
    """Offsets of current make the first, unequal gains the second; the eighth, 56, no winding makes of itself."""
    case = with_lines_left(multiple * 7.0)
    ripple = next(each for each in commutation_ripple.propose(case) if each.place == order(multiple * 7.0))
    assert (ripple.price == 0.0) is free


def test_lines_of_coarse_codes_hide_no_ripple(with_lines_left: Callable[..., Case]) -> None:
    """They make more lines than are tried; where a field's may stand, the weakest is."""
    case = with_lines_left(64.0, 58.0, 40.2, 63.2, 35.8, 61.0, 42.2, 42.0)
    tried = [each.place for each in commutation_ripple.propose(case)]
    assert order(42.0) in tried
    assert order(61.0) not in tried, "weak, and beside the field"
    assert order(42.2) not in tried


@pytest.mark.parametrize(("own", "asked"), [(14.0, True), (24.0, False)])
def test_a_line_of_the_rigs_own_may_hide_a_ripple(
    own: float, asked: bool, with_lines_left: Callable[..., Case], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unequal gains of a drive stand at 2p, where the rig has a line already: the model misses it under load."""
    monkeypatch.setattr(commutation_ripple, "missed_lines", lambda case: [order(own)])
    tried = [each.place for each in commutation_ripple.propose(with_lines_left())]
    assert (order(own) in tried) is asked
