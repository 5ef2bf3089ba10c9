"""The mean load of an idle rig is known no better than the sensor's zero."""

from __future__ import annotations

import pytest

from torquerig.diagnose.fitting.knobs import LOAD_LEVEL_SPREAD, ZERO_ERROR, nuisance_knobs
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize(
    ("occupancy", "mean", "spread"), [(0.0, 0.05, ZERO_ERROR / 0.05), (5.0, 1.0, LOAD_LEVEL_SPREAD)]
)
def test_a_small_mean_load_is_known_to_the_zero_of_the_sensor(
    occupancy: float, mean: float, spread: float, wear_rig: Scenario
) -> None:
    knobs = nuisance_knobs(wear_rig.rig, {}, occupancies=[occupancy])
    (level,) = [knob for knob in knobs if knob.field == "mean_by_occupancy_percent"]
    assert level.value(wear_rig.rig) == pytest.approx(mean)
    assert level.spread == pytest.approx(spread)
