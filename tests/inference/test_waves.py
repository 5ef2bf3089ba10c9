"""Waves piece by piece, beside the sine and cosine of each phase."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.features.waves import Waves
from torquerig.inference.places import frequency, order

TIME = np.arange(9000) / 1000
ANGLE = 104.7 * TIME + 3 * np.sin(2 * TIME)


@pytest.mark.parametrize(
    "places",
    [
        [order(0.2), order(4.0), order(84 / 5)],
        [order(1 / 3), order(7.0), order(2.4178), frequency(280.0)],
        [order(0.123456789)],
        [frequency(50.0)],
        [],
    ],
)
def test_every_wave_is_that_of_its_phase(places: list) -> None:
    told = Waves(places, ANGLE, TIME)
    exact = np.exp(1j * np.array([place.phase(ANGLE, TIME) for place in places]).reshape(len(places), TIME.size))
    amplitude = np.exp(1j * np.arange(len(places))) * (1 + np.arange(len(places)))
    assert np.abs(told.summed(amplitude) - (amplitude @ exact).real).max() < 1e-10
    weight = 1 + 0.5 * np.sin(TIME)
    parts = [told.weighted(part, weight[part]) for part in told.pieces()]
    both = np.concatenate([exact.real, -exact.imag])
    assert np.concatenate(parts, axis=1) == pytest.approx(both * weight, abs=1e-11)


def test_pieces_meet_and_cover_every_sample_once() -> None:
    pieces = [*Waves([], ANGLE, TIME).pieces()]
    assert len(pieces) > 2
    assert [at for piece in pieces for at in range(piece.start, piece.stop)] == [*range(TIME.size)]
