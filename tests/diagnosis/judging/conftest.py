"""Runs of the wear rig as they are judged by what no fit has seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.lines_left import known_places
from torquerig.diagnosis.looking.observed import observed
from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.recordings.recording import Recording
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario


@pytest.fixture(scope="module")
def held(wear_rig: Scenario, record: Callable[..., Recording]) -> tuple[Features, ...]:
    rig = wear_rig.rig
    recordings = [replace(record(rig, seed, duration=12.0), name=f"run{seed}.parquet") for seed in (5, 6, 7)]
    angles = shaft_angles(recordings, rig)
    ratio = kinematics_of(rig).ratio
    runs = [observed(each, angle, ratio=ratio) for each, angle in zip(recordings, angles, strict=True)]
    return tuple(features(run, known_places(runs, rig), held=True) for run in runs)
