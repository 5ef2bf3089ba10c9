"""Lines of impacts are told from lines of teeth and blades by how many multiples there are, and how high."""

from __future__ import annotations

import numpy as np

from torquerig.diagnosis.looking.combs import without_comb
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency, order


def peak(at: float) -> Peak:
    return Peak(order(at), 100.0, ("run1",), 2)


def test_the_lines_of_impacts_are_left_to_their_ringing() -> None:
    """A defect of order 2.402 of the output shaft at 5:1, its lines placed to a thousandth of an order."""
    rng = np.random.default_rng(1)
    comb = [peak(k * 2.402 / 5 + 1e-3 * rng.standard_normal()) for k in (5, 14, *range(28, 60), 70, 71)]
    hum = Peak(frequency(50.0), 60.0, ("run1",), 2)
    mesh = peak(16.9)
    assert without_comb([*comb, hum, mesh]) == (hum, mesh)


def test_a_mesh_and_its_harmonics_stay() -> None:
    teeth = [peak(h * 84 / 5) for h in (1, 2, 3, 4)]
    assert without_comb(teeth) == tuple(teeth)


def test_a_mesh_with_the_side_lines_of_its_planets_stays() -> None:
    teeth = [peak((h * 84 + side) / 5) for h in (1, 2, 3) for side in (-3, 0, 3)]
    kept = without_comb(teeth)
    assert {round(each.place.at * 5) for each in kept} >= {84, 168, 252}


def test_lines_of_no_common_order_stay() -> None:
    some = [peak(at) for at in (3.3, 7.71, 11.2, 19.2, 23.9, 31.05, 44.4, 58.7)]
    assert without_comb(some) == tuple(some)


def test_lines_that_crowd_at_two_places_are_no_comb() -> None:
    """All lines but a few within a hundredth of one order: no slope can be fitted through them."""
    crowd = [peak(at) for at in (12.0, 12.03, 12.03, 12.06, 12.061, 12.09, 12.12, 40.0, 40.03, 40.05)]
    assert len(without_comb(crowd)) > 0


def test_a_line_that_towers_over_the_comb_that_meets_it_stays() -> None:
    """Multiple 31 of order 6.774 of the output shaft stands at motor order 42, where six steps ripple."""
    comb = [peak(k * 6.774 / 5) for k in range(20, 40) if k != 31]
    ripple = Peak(order(42.0), 900.0, ("run1",), 2)
    assert without_comb([*comb, ripple]) == (ripple,)
    own = Peak(order(31 * 6.774 / 5), 200.0, ("run1",), 2)
    assert without_comb([*comb, own]) == (), "lines of combs scatter"


def test_the_side_lines_of_a_strong_line_do_not_take_it_along() -> None:
    sides = [peak(at) for at in (35.0, 36.0, 39.0, 40.0, 41.0, 43.0, 44.0, 45.0, 46.0)]
    carrier = Peak(order(42.0), 5000.0, ("run1",), 2)
    assert carrier in without_comb([*sides, carrier])
