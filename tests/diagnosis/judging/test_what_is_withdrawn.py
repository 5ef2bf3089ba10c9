"""What was found is withdrawn where it foretells worse, or leaves a rest at its own places and much elsewhere."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.judging.withdrawn import why_withdrawn
from torquerig.diagnosis.outcome import HeldOut
from torquerig.inference.answer.mismatch import Mismatch

SOMEWHERE = (cast(Mismatch, object()),)
AT_A_MOMENT, A_LINE = (cast(Mismatch, SimpleNamespace(domain=domain)) for domain in ("time", "order"))


def fit(before: float, after: float, explained: float) -> HeldOut:
    return HeldOut(nominal=9.0, before=before, after=after, improvement=(0.0, 0.0, 0.0), explained=explained)


@pytest.mark.parametrize(
    ("held", "left", "why"),
    [
        (fit(5.0, 5.1, 0.9), SOMEWHERE, "predicts the held-out data worse"),
        (fit(1.68, 1.64, 0.9), (), "hardly improves the prediction"),
        (fit(0.6, 0.57, 0.9), (), ""),  # what is chance already cannot fall far
        (fit(0.6, 0.595, 0.9), (), "hardly improves the prediction"),  # but somewhat it does where something is there
        (fit(5.0, 4.0, 0.6), SOMEWHERE, "less than 80% of the held-out residual"),
        (fit(5.0, 4.0, 0.6), (), ""),  # nothing stands out: the rest is chance
        (fit(5.0, 4.0, 0.85), SOMEWHERE, ""),  # right where it acts, and something else beside it
        (fit(22.0, 6.5, 0.79), SOMEWHERE, ""),  # most of all that was missing
    ],
)
def test_a_rest_at_its_own_places_tells_a_stand_in(held: HeldOut, left: Any, why: str) -> None:
    assert why in why_withdrawn(held, left)
    assert bool(why_withdrawn(held, left)) is bool(why)


@pytest.mark.parametrize(
    ("explained", "least", "left", "resembled", "stays"),
    [
        (0.95, 0.05, SOMEWHERE, False, True),
        (0.85, 0.05, SOMEWHERE, False, False),  # a stand-in
        (0.95, -0.02, SOMEWHERE, False, False),  # chance
        (0.95, 0.05, (), False, False),  # nothing stands out that the rest could be
        (0.95, 0.05, SOMEWHERE, True, False),  # noise looks like it
    ],
)
def test_a_line_that_is_foretold_stands_beside_a_larger_thing_that_nobody_explains(
    explained: float, least: float, left: Any, resembled: bool, stays: bool
) -> None:
    held = replace(fit(7.7, 6.6, explained), improvement=(0.14, least, 0.2))
    assert bool(why_withdrawn(held, left, resembled=resembled)) is not stays


@pytest.mark.parametrize(("resembled", "times", "gone"), [(True, 2, True), (True, 1, False), (False, 3, False)])
def test_what_noise_resembles_falls_where_noise_comes_and_goes(resembled: bool, times: int, gone: bool) -> None:
    """Rattling in bursts has a mean spectrum, and a mode fits that."""
    why = why_withdrawn(fit(6.3, 2.6, 0.8), (), resembled=resembled, passing=SOMEWHERE * times)
    assert ("intermittent noise" in why) is gone


@pytest.mark.parametrize(("effects", "left", "gone"), [(3, SOMEWHERE, True), (3, (), False), (2, SOMEWHERE, False)])
def test_three_that_leave_a_rest_are_pieces_of_something_else(effects: int, left: Any, gone: bool) -> None:
    """A coupling whose stiffness goes with its torque makes lines between lines, and each passes for something."""
    why = why_withdrawn(fit(6.3, 1.2, 0.95), left, effects=effects)
    assert ("with all findings a residual remains" in why) is gone


def test_no_zero_drifts_where_the_spectrum_changes_with_time() -> None:
    held = fit(3.0, 1.0, 0.9)
    assert why_withdrawn(held, ()) == ""
    assert "spectrum also changes along the steady recordings" in why_withdrawn(held, (), drifts_in_all=True)


@pytest.mark.parametrize(
    ("before", "left", "stays"), [(0.9, SOMEWHERE, False), (0.9, (), True), (1.6, SOMEWHERE, True)]
)
def test_what_nothing_unseen_asks_for_is_not_named_beside_a_rest(before: float, left: Any, stays: bool) -> None:
    """Of 796 rigs four had such a finding, each of them wrong: a mode for a shaft that hardens, a mesh for another."""
    assert (why_withdrawn(fit(before, 0.7 * before, 0.9), left) == "") is stays
    assert why_withdrawn(fit(before, 0.7 * before, 0.9), left, samples_too=True) == ""


@pytest.mark.parametrize(
    ("again", "left", "gone"), [(True, SOMEWHERE, True), (True, (), False), (False, SOMEWHERE, False)]
)
def test_what_left_a_rest_before_must_leave_none_beside_numbers_that_stand_still(
    again: bool, left: Any, gone: bool
) -> None:
    """A sensor with play makes lines at odd orders, and each of them passes for a mesh."""
    why = why_withdrawn(fit(1.65, 1.28, 0.95), left, again=again)
    assert ("a residual remains" in why) is gone


@pytest.mark.parametrize(("after", "told", "gone"), [(0.995, True, False), (0.995, False, True), (1.005, True, True)])
def test_a_gap_that_tells_the_flights_need_not_foretell_the_rest_better(after: float, told: bool, gone: bool) -> None:
    held = fit(0.5, 0.5 * after, 0.3)
    assert ("hardly improves the prediction" in why_withdrawn(held, (), flights_told=told)) is gone


@pytest.mark.parametrize(
    ("left", "flown", "untrue", "stays"),
    [
        ((AT_A_MOMENT,), True, True, True),
        ((AT_A_MOMENT, A_LINE), True, True, False),
        ((AT_A_MOMENT,), False, True, False),
    ],
    ids=["moments alone", "a line as well", "no flights"],
)
@pytest.mark.parametrize(("before", "after", "explained"), [(4.9, 4.1, 0.59), (2.4, 2.26, 0.86)])
def test_moments_at_which_samples_are_untrue_are_no_rest_of_a_gap_that_tells_the_flights(
    before: float, after: float, explained: float, left: Any, flown: bool, untrue: bool, stays: bool
) -> None:
    """A gain that jumps beside it: what no fit has seen of that run is foretold badly whatever is found."""
    why = why_withdrawn(fit(before, after, explained), left, gap=True, flights_told=flown, samples_too=untrue)
    assert (why == "") is stays


@pytest.mark.parametrize(
    ("passing", "untrue", "gap", "stays"),
    [((AT_A_MOMENT,), False, True, False), ((), False, True, True), ((AT_A_MOMENT,), True, True, True),
     ((AT_A_MOMENT,), False, False, True)],
    ids=["what slips", "at no moment", "samples untrue", "no gap"],
)  # fmt: skip
def test_a_gap_is_not_told_by_what_slips_at_times(passing: Any, untrue: bool, gap: bool, stays: bool) -> None:
    """A coupling that slips lets go of the torque, as parted flanks do; it foretells four fifths of what it misses."""
    why = why_withdrawn(
        fit(18.5, 4.7, 0.99), passing, passing=passing, gap=gap, flights_told=gap, samples_too=untrue
    )  # fmt: skip
    assert (why == "") is stays


@pytest.mark.parametrize(("before", "after", "stays"), [(13.1, 9.4, False), (13.1, 4.0, True), (2.0, 1.6, True)])
def test_what_leaves_a_model_far_off_is_not_named_though_no_place_stands_out(
    before: float, after: float, stays: bool
) -> None:
    """A neighbour's hammer taken for a gap: beside what no twin can hold more is forgiven at each place."""
    assert (why_withdrawn(fit(before, after, 0.9), ()) == "") is stays
    assert why_withdrawn(fit(before, after, 0.9), (), samples_too=True) == ""


@pytest.mark.parametrize(
    ("after", "orders", "turning_lines", "stays"),
    [(1.19, (2.0, 19.0), True, False), (1.19, (2.0,), True, True), (1.19, (2.3, 19.4), True, True),
     (1.10, (2.0, 19.0), True, True), (1.19, (2.0, 19.0), False, True)],
)  # fmt: skip
def test_one_of_several_whole_orders_is_no_effect_of_its_own(
    after: float, orders: tuple[float, ...], turning_lines: bool, stays: bool
) -> None:
    """An encoder off its centre shakes the loop at every order; one of them stood on a whole number of teeth."""
    left = tuple(
        Mismatch(domain="order", axis="motor_shaft", at=at, width=0.02, recordings=("run3",), excess_dB=20.0,
                 share_of_misfit=0.3, p_value=1e-9)
        for at in orders
    )  # fmt: skip
    assert (why_withdrawn(fit(1.25, after, 0.9), left, turning_lines=turning_lines) == "") is stays


@pytest.mark.parametrize(
    ("own", "combined", "left", "why"),
    [
        (True, False, SOMEWHERE, "the line that it causes"),
        (False, True, SOMEWHERE, "sum or difference"),
        (False, True, (), ""),  # nothing bends that anybody sees
        (False, False, SOMEWHERE, ""),
    ],
)
def test_a_line_goes_that_its_cause_does_not_explain(own: bool, combined: bool, left: Any, why: str) -> None:
    told = why_withdrawn(fit(5.0, 1.1, 0.95), left, own_line=own, combined=combined)
    assert why in told
    assert bool(told) is bool(why)


def test_a_line_may_stay_wrong_where_the_time_base_jumps() -> None:
    """Its phase jumps with the time; the samples were told of, and it is no sign of another cause."""
    assert why_withdrawn(fit(5.0, 1.1, 0.95), SOMEWHERE, own_line=True)
    assert not why_withdrawn(fit(5.0, 1.1, 0.95), SOMEWHERE, own_line=True, samples_too=True)


@pytest.mark.parametrize(
    ("least", "combined", "gone"), [(-0.06, True, True), (0.02, True, False), (-0.06, False, False)]
)
def test_a_combination_of_the_rigs_own_lines_is_foretold_or_goes(least: float, combined: bool, gone: bool) -> None:
    """A shaft that hardens makes order 13 of 6 and 7, in one run; a mesh of 65 teeth explains it as well."""
    held = replace(fit(0.97, 0.88, 0.9), improvement=(0.09, least, 0.27))
    assert bool(why_withdrawn(held, (), combined=combined)) is gone


@pytest.mark.parametrize(
    ("after", "everywhere", "left", "gone"),
    [
        (2.2, True, (), True),  # friction that dies away as the bearings warm up, named as one that does not
        (2.2, False, (), False),
        (1.4, True, (), False),
        (2.2, True, SOMEWHERE, False),
    ],
)
def test_what_leaves_a_model_far_off_all_over_has_missed_something(
    after: float, everywhere: bool, left: Any, gone: bool
) -> None:
    assert bool(why_withdrawn(fit(4.9, after, 0.95), left, everywhere=everywhere)) is gone


@pytest.mark.parametrize(("gap", "stays"), [(False, True), (True, False)])
def test_what_ends_in_blows_is_no_gap_where_most_of_what_is_wrong_stays(gap: bool, stays: bool) -> None:
    """A shaft that slips in its clamp strikes as flanks do, and the spectrum of its ringing is another."""
    held = replace(fit(10.6, 9.1, 0.95), improvement=(0.14, 0.02, 0.27))
    assert bool(why_withdrawn(held, SOMEWHERE, gap=gap)) is not stays


@pytest.mark.parametrize(
    ("after", "explained", "stays"), [(800.0, 0.77, False), (800.0, 0.9, True), (60.0, 0.77, True)]
)
def test_a_model_that_is_wrong_beyond_measure_names_nothing_by_half(
    after: float, explained: float, stays: bool
) -> None:
    assert bool(why_withdrawn(fit(4500.0, after, explained), SOMEWHERE)) is not stays
