"""Waves as powers of one wave, beside the sine and cosine of each phase."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnose.looking.places import frequency, order
from torquerig.diagnose.looking.waves import Waves

TIME = np.arange(5000) / 1000
ANGLE = 104.7 * TIME + 3 * np.sin(2 * TIME)


@pytest.mark.parametrize(
    "places",
    [
        [order(0.2), order(4.0), order(84 / 5)],
        [order(1 / 3), order(7.0), order(2.4178), frequency(280.0)],
        [order(16.8), order(33.6), order(0.2 / 3)],
        [frequency(50.0)],
        [],
    ],
)
def test_every_wave_is_that_of_its_phase(places: list) -> None:
    told = Waves(places, ANGLE, TIME)
    assert told.shape == (len(places), TIME.size)
    for wave, place in zip(told[:, :], places, strict=True):
        # an order is kept to nine digits
        assert np.abs(wave - np.exp(1j * place.phase(ANGLE, TIME))).max() < 2e-9 * place.at * ANGLE.max() + 1e-11


def test_orders_that_share_no_base_are_waves_of_their_own() -> None:
    told = Waves([order(0.123456789), order(5.0)], ANGLE, TIME)[:, :]
    assert np.abs(told[0] - np.exp(0.123456789j * ANGLE)).max() < 1e-12
