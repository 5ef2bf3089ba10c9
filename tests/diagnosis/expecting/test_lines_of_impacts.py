"""What impacts without slip may put at a line: at multiples of their order, and a turn of the shaft beside these."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.expecting.added_signals import added_signals
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import BearingDefect
from torquerig.scenario.model import Scenario

RATE, LENGTH, RATIO, SPEED = 10_000.0, 12.0, 5.0, 100.0
IMPACTS, RING, DAMPING, SIZE = 7.3, 900.0, 0.05, 0.3


def struck(swing: float) -> np.ndarray:
    """Rings by their closed form, one after the other, their strength swinging once a turn of the output shaft."""
    time = np.arange(int(RATE * LENGTH)) / RATE
    torque = np.zeros(time.size)
    moments = np.arange(0.003, LENGTH, 2 * np.pi * RATIO / IMPACTS / SPEED)
    for moment in moments.tolist():
        since = time[(time >= moment) & (time < moment + 0.05)] - moment
        ring = np.exp(-2 * np.pi * DAMPING * RING * since) * np.sin(2 * np.pi * RING * since)
        size = SIZE * (1 + swing * np.cos(SPEED / RATIO * moment))
        torque[(time >= moment) & (time < moment + 0.05)] += size * ring
    return torque


@pytest.mark.parametrize("turns", [-1, 0, 1])
@pytest.mark.parametrize("multiple", [30, 37])
def test_no_line_is_larger_than_the_impacts_may_make_it(
    multiple: int, turns: int, wear_rig: Scenario, by_hand: Callable[..., Observed]
) -> None:
    place = order((multiple * IMPACTS + turns) / RATIO)
    part = BearingDefect(
        name="bearing", at="wear_part", order_output=IMPACTS, ring_frequency=RING, damping=DAMPING, amplitude=SIZE
    )
    angle = SPEED * np.arange(int(RATE * LENGTH)) / RATE
    for swing in (0.0, 1.0):
        run = by_hand(struck(swing), angle, rate=RATE)
        seen = features(run, (place, order(1.0)), held=None)
        rig = (wear_rig.rig + part).at(replace(wear_rig.rig.run, speed=SPEED))
        allowed = np.asarray(added_signals(Twin(rig), seen).impacts)
        size = float(np.abs(seen.amplitude[:, 0]).mean())
        assert allowed[1] == 0.0, "no impact makes a line at the motor's own order"
        at = place.frequency(SPEED)
        carried = max(1.0, (RING / at) ** 2)  # by shafts, which pass what is slow
        if turns == 0:
            assert size * carried == pytest.approx(allowed[0], rel=0.05)
        else:
            assert size < (0.55 if swing == 1.0 else 0.05) * allowed[0]


@pytest.mark.parametrize(("beside", "theirs"), [(1.5, True), (2.9, False)])
def test_impacts_that_slip_stand_so_much_further_beside_their_multiples(
    beside: float, theirs: bool, wear_rig: Scenario, by_hand: Callable[..., Observed]
) -> None:
    """One per cent of the 27th multiple: 1.97 of the output shaft's orders, with impacts far enough apart to tell."""
    impacts = 27.3
    place = order((27 * impacts + 4 * beside) / RATIO)
    part = BearingDefect(
        name="bearing", at="wear_part", order_output=impacts, ring_frequency=RING, damping=DAMPING, amplitude=SIZE
    )
    angle = SPEED * np.arange(int(RATE * LENGTH)) / RATE
    seen = features(by_hand(np.sin(angle), angle, rate=RATE), (place,), held=None)
    rig = (wear_rig.rig + part).at(replace(wear_rig.rig.run, speed=SPEED))
    assert bool(np.asarray(added_signals(Twin(rig), seen).impacts)[0]) is theirs


def test_bands_hold_what_shafts_may_carry_of_the_multiples_in_them(
    wear_rig: Scenario, by_hand: Callable[..., Observed]
) -> None:
    """As much as the line at a place on the multiple would have, spread over the band; the ring's own part apart."""
    part = BearingDefect(
        name="bearing", at="wear_part", order_output=IMPACTS, ring_frequency=RING, damping=DAMPING, amplitude=SIZE
    )
    angle = SPEED * np.arange(int(RATE * LENGTH)) / RATE
    place = order(9 * IMPACTS / RATIO)
    seen = features(by_hand(struck(0.0), angle, rate=RATE), (place,), held=None)
    added = added_signals(Twin((wear_rig.rig + part).at(replace(wear_rig.rig.run, speed=SPEED))), seen)
    carried, low = np.asarray(added.carried), place.frequency(SPEED)
    band = int(np.argmin(np.abs(np.log(seen.band / low))))
    better = (RING / low) ** 4
    line = 0.5 * float(np.asarray(added.impacts)[0]) ** 2 / seen.width[band]
    assert carried[band] == pytest.approx(line * (1 - 1 / better), rel=0.1)
    spacing = place.frequency(SPEED) / 9
    edges = np.array(seen.band_edges) / spacing
    between = (np.floor(edges[1] * 1.01) < edges[0] * 0.99) & (edges[0] > 1)
    assert between.any()
    assert not carried[between].any()
