"""A sentence says no width that recordings do not tell."""

from __future__ import annotations

import pytest

from torquerig.diagnosis.outcome import Stated
from torquerig.diagnosis.sentences import explanation


@pytest.mark.parametrize(
    ("low", "high", "said"),
    [
        (4.0, 36.0, "backlash of about 8.0 arcmin in the gearbox."),
        (1.5, 45.0, "its width is open, because the teeth chatter"),
    ],
)
def test_a_width_is_said_where_it_is_told(low: float, high: float, said: str) -> None:
    gap = {"gap_arcmin": Stated(value=8.0, low=low, high=high, unit="arcmin")}
    assert said in explanation("backlash", gap, share=0.97, rivals=(), gain=100.0)
