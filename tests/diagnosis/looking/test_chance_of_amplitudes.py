"""What blows leave of a line's size to chance while the speed changes: as much as half of the places show."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flight_statistics import chance_of_amplitudes

LINES = [[0.01, 0.02j, 0.3], [0.05, np.nan, 0.03j], [np.nan, np.nan, np.nan]]


def seen(amplitude: list[list[complex]], *, steady: bool) -> Features:
    shown = np.array(amplitude, dtype=complex)
    return cast("Features", SimpleNamespace(amplitude=shown, observed=SimpleNamespace(steady=steady)))


def test_half_of_the_places_that_a_stretch_shows_stand_above_it() -> None:
    told = chance_of_amplitudes(seen(LINES, steady=False))
    assert told == pytest.approx(np.array([[0.02**2], [(0.05**2 + 0.03**2) / 2], [0.0]]))


def test_a_run_at_one_speed_and_one_without_places_leave_nothing() -> None:
    assert chance_of_amplitudes(seen(LINES, steady=True)) == 0.0
    assert chance_of_amplitudes(seen([], steady=False)) == 0.0
