"""Which ratio and which speed a sheet may mean."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.set_points import off_set_points
from torquerig.diagnosis.sheet_ratio import off_ratios
from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.recorded.gear_ratio import at_ratio_of

ANGLE = 40.0 * np.arange(20000) / 5000.0
NOISE = 1e-3 * np.random.default_rng(1).standard_normal(ANGLE.size)


@pytest.mark.parametrize("stated", [1.0, 3.0])
def test_a_sheet_may_mean_the_gears_behind_the_sensor(
    stated: float, bench: Callable[..., Rig], by_hand: Callable[..., Observed]
) -> None:
    """The sensor turns with the motor, the drum a third as fast: both are this rig's."""
    sheets, runs, rig = stating(stated, by_hand), [by_hand(NOISE, ANGLE)], bench("before", wheel=60)
    assert [*off_ratios(sheets, runs, rig)] == []
    assert [sheet.run.gear_ratio for sheet in at_ratio_of(sheets, rig)] == [1.0], "lines are counted up to the sensor"


def test_a_sheet_of_no_gear_of_the_rig_is_held_to_lines(
    bench: Callable[..., Rig], by_hand: Callable[..., Observed]
) -> None:
    """Noise has none, so that they tell neither."""
    with pytest.raises(
        RecordingError, match="a gear ratio of 4, the scenario's rig has 1, and the lines of the torque do not decide"
    ):
        list(off_ratios(stating(4.0, by_hand), [by_hand(NOISE, ANGLE)], bench("before", wheel=60)))


def stating(ratio: float, by_hand: Callable[..., Observed]) -> list[Recording]:
    made = by_hand(NOISE, ANGLE).recording
    return [replace(made, run=replace(made.run, gear_ratio=ratio))]


@pytest.mark.parametrize(("stated", "off"), [(-1000.0, 0), (1000.0, 0), (-1100.0, 1), (1100.0, 1)])
def test_a_set_point_of_a_shaft_that_turns_backward_is_compared_by_its_size(stated: float, off: int) -> None:
    run = SimpleNamespace(
        name="run1", steady=True, angle_measured=True, origin="from the encoder", mean_speed=-1000.0 * np.pi / 30
    )
    recording = SimpleNamespace(run=SimpleNamespace(speed=stated * np.pi / 30))
    found = list(off_set_points([recording], [run], error_max=0.01))  # type: ignore[list-item]
    assert len(found) == off
    for sentence, mismatch in found:
        assert "states 1100 rpm, but the encoder shows 1000 rpm" in sentence
        assert mismatch.width == pytest.approx(100.0)
