"""Which grid hums, where its other lines must stand, and what its frequency is."""

from __future__ import annotations

import pytest

from torquerig.diagnosis.looking.hum import fundamental, harmonics_of, hum_places
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency, order


def line(at: float, excess: float = 100.0) -> Peak:
    return Peak(frequency(at), excess, ("run.parquet",), 2)


def test_the_line_that_tells_best_tells_the_frequency() -> None:
    found = harmonics_of(50.0, [line(49.9, 20.0), line(149.85, 900.0)])
    assert set(found) == {1, 3}
    assert fundamental(found) == pytest.approx(49.95)


def test_a_high_harmonic_divides_its_error() -> None:
    found = harmonics_of(50.0, [line(49.99, 150.0), line(249.935, 90.0)])
    assert fundamental(found) == pytest.approx(49.987)


def test_what_is_off_the_grid_or_turns_is_no_hum() -> None:
    assert harmonics_of(50.0, [line(51.0), line(75.0), Peak(order(50.0), 100.0, ("run.parquet",), 2)]) == {}


def test_the_grid_with_more_lines_is_looked_for() -> None:
    at = [place.at for place in hum_places([line(60.0), line(180.0), line(300.0)])]
    assert at == pytest.approx([120.0]), "300 Hz is a line of 50 Hz as well, but 60 Hz has three"


def test_of_two_grids_with_one_common_line_both_are_looked_for() -> None:
    at = sorted(place.at for place in hum_places([line(300.0)]))
    assert at == pytest.approx([50.0, 60.0, 100.0, 120.0, 150.0, 180.0])


def test_without_fixed_lines_there_is_no_hum() -> None:
    assert hum_places([]) == []
