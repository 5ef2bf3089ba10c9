"""Impacts whose own lines stand out are impacts all the same: what was found is no family of the model's."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import bearing_defect
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario

RATE, LENGTH, SPEED, IMPACTS, RING = 10_000.0, 10.0, 95.0, 3.58, 1350.0


def struck() -> np.ndarray:
    """Rings of a tenth of a newton metre at every 3.58th of a turn, in noise of a hundredth."""
    time = np.arange(int(RATE * LENGTH)) / RATE
    since = np.mod(time, 2 * np.pi / IMPACTS / SPEED)
    ring = 0.1 * np.exp(-2 * np.pi * 0.05 * RING * since) * np.sin(2 * np.pi * RING * since)
    return ring + 0.01 * np.random.default_rng(3).standard_normal(time.size)


@pytest.mark.parametrize("own", [True, False])
def test_found_lines_are_no_family_of_the_model(
    own: bool, wear_rig: Scenario, by_hand: Callable[..., Observed]
) -> None:
    run = by_hand(struck(), SPEED * np.arange(int(RATE * LENGTH)) / RATE, rate=RATE)
    places = [order(IMPACTS * multiple) for multiple in (1, 2, 12)]
    seen = features(run, places, unknown=[] if own else places)
    case = cast(
        "Case",
        SimpleNamespace(
            nominal=wear_rig.rig,
            runs=(run,),
            seen=(seen,),
            model=SimpleNamespace(rig=wear_rig.rig),
            left=(),
            misfit_of=lambda rig: 0.0,
        ),
    )
    told = [part.order_output for one in bearing_defect.propose(case) for part in one.parts]  # type: ignore[attr-defined]
    if own:
        assert told == []
    else:
        assert told[0] == pytest.approx(5 * IMPACTS, rel=2e-3)
