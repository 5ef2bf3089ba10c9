"""Gear ratios of sidecars: the rig's where none is stated, one sentence where they contradict it or each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.scenario.recorded.gear_ratio import at_stated_ratio

RATIO = 5.0  # of the shipped wear rig


def run(ratio):
    channel = Channel(values=np.zeros(10), quantity="torque", unit="N*m")
    return Recording(
        sample_rate=1000.0, channels={"torque_Nm": channel}, run=Run(speed=100.0, gear_ratio=ratio), name="run1.csv"
    )


def test_a_sidecar_without_a_ratio_has_that_of_the_rig(wear_rig):
    (made,) = at_stated_ratio([run(None)], wear_rig.rig)
    assert made.run.gear_ratio == pytest.approx(RATIO)
    rounded = run(1.001 * RATIO)
    assert at_stated_ratio([rounded], wear_rig.rig) == [rounded]


def test_another_ratio_than_that_of_the_rig_is_refused(wear_rig):
    with pytest.raises(RecordingError, match="states a gear ratio of 20, but the scenario's rig has 5; correct the"):
        at_stated_ratio([run(None), run(20.0)], wear_rig.rig)


def test_several_ratios_are_several_rigs(wear_rig):
    both = [run(RATIO), replace(run(20.0), name="run2.csv")]
    with pytest.raises(InputError, match="of different rigs: their sidecars state the gear ratio as 5 and 20"):
        at_stated_ratio(both, wear_rig.rig)
