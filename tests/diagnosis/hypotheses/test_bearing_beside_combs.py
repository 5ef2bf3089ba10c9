"""The lines of a comb beat with each other in every band: no impacts are asked for while its own are left."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, cast

import numpy as np
import pytest

from torquerig.diagnosis.hypotheses.bearing_defect import _of_a_comb
from torquerig.diagnosis.looking.impacts import Impact
from torquerig.inference.places import frequency

if TYPE_CHECKING:
    from torquerig.diagnosis.case import Case

TURNS = 50 / 3  # a second
BEATS = 16.8  # a turn: 280 Hz


@pytest.mark.parametrize(
    ("lines", "order", "band", "comb"),
    [
        ({280.0: 9.0, 560.0: 5.0, 840.0: 4.0}, BEATS, 950.0, True),
        ({280.0: 9.0, 560.0: 5.0, 840.0: 4.0}, BEATS / 3, 950.0, True),
        ({280.0: 9.0}, BEATS, 950.0, False),  # one line alone is no comb
        ({280.0: 9.0, 560.0: 5.0}, 1.7, 950.0, False),  # nothing of what beats
        ({280.0: 9.0, 560.0: 5.0}, BEATS, 475.0, False),  # near the mode, whose impacts raise it
        ({280.0: 5.0, 560.0: 5.5, 840.0: 9.0}, BEATS, 950.0, False),  # highest within the band
        ({}, BEATS, 950.0, False),
    ],
)
def test_a_comb_far_below_the_band_is_asked_first(
    lines: dict[float, float], order: float, band: float, comb: bool
) -> None:
    left = tuple(SimpleNamespace(place=frequency(at), excess=excess) for at, excess in lines.items())
    run = SimpleNamespace(steady=True, mean_speed=2 * np.pi * TURNS)
    case = cast("Case", SimpleNamespace(left=left, runs=(run,)))
    assert _of_a_comb(case, Impact(order, band, 30.0)) == comb
