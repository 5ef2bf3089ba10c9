"""What is kept of features is worked out once each, and goes with them."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable

import numpy as np

from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.kept import kept
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order

ByHand = Callable[..., Observed]


def test_each_is_asked_once_and_forgotten_with_the_features(by_hand: ByHand) -> None:
    asked: list[int] = []

    @kept
    def level(seen: Features) -> float:
        asked.append(id(seen))
        return float(seen.level.mean())

    angle = 40.0 * np.arange(12_000) / 1000.0
    one, two = (features(by_hand(torque + 0 * angle, angle, rate=1000.0), [order(3.0)]) for torque in (1.0, 2.0))
    assert [round(level(seen), 6) for seen in (one, two, one, two)] == [1.0, 2.0, 1.0, 2.0]
    assert asked == [id(one), id(two)]
    gone = weakref.ref(one)
    del one
    gc.collect()
    assert gone() is None
