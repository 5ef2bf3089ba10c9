"""What a simulated change leaves to chance: a share of itself, and more where few events make it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.expecting.correction import Correction, between, corrected
from torquerig.diagnosis.expecting.expectation import Expectation

BEFORE = Expectation(
    power=np.array([1e-6, 1e-6]), amplitude=np.array([[0.3]]), variance=np.array([[1e-6]]), level=np.array([1.0]),
    level_variance=np.array([1e-4]), load_share=np.ones(2), power_tolerance=np.array([0.3, 0.0]),
    amplitude_tolerance=0.02,
)  # fmt: skip
AFTER = replace(BEFORE, power=np.array([1e-6, 1e-5]), amplitude=np.array([[0.5]]), level=np.array([1.2]))


@pytest.fixture
def correction() -> Correction:
    return between([AFTER], [BEFORE])[0]


def test_it_leads_from_one_expectation_to_the_other(correction: Correction) -> None:
    answer = corrected(BEFORE, correction)
    for name in ("power", "amplitude", "level"):
        assert getattr(answer, name) == pytest.approx(getattr(AFTER, name))


def test_a_quarter_of_a_change_is_chance_beside_what_was_doubtful_before(correction: Correction) -> None:
    answer = corrected(BEFORE, correction)
    assert answer.power_tolerance == pytest.approx([0.3, 0.25 * np.log(10.0)])
    assert answer.amplitude_tolerance == pytest.approx(np.hypot(0.02, 0.25 * 0.4))


def test_few_events_leave_all_bands_to_chance(correction: Correction) -> None:
    answer = corrected(BEFORE, replace(correction, scatter=0.8))
    assert answer.power_tolerance == pytest.approx([np.hypot(0.3, 0.8), np.hypot(0.25 * np.log(10.0), 0.8)])


def test_what_events_leave_beside_widens_every_amplitude_of_a_stretch(correction: Correction) -> None:
    answer = corrected(BEFORE, replace(correction, beside=np.array([[4e-6]])))
    assert answer.variance == pytest.approx(np.array([[5e-6]]))


def test_half_of_a_change_at_a_reversal_is_chance_where_it_changes() -> None:
    turning = replace(BEFORE, turning=np.array([-1.0, 0.4]), turning_tolerance=np.array([0.05, 0.05]))
    change = between([replace(turning, turning=np.array([-0.2, 0.4]))], [turning])[0]
    answer = corrected(turning, change)
    assert answer.turning == pytest.approx([-0.2, 0.4])
    assert answer.turning_tolerance == pytest.approx([np.hypot(0.05, 0.5 * 0.8), 0.05])
