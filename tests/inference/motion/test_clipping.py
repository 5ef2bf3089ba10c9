"""A limit of the reading is compared by what the motion needs beyond it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.moved_rigs import CARRIAGE, COUNT, MASS, RATE, recorded, scenario
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypotheses import clipping
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import imposed_runs
from torquerig.recordings.recording import Recording

Floats = NDArray[np.float64]

FINE = 50  # steps of an integration per sample
TRUE = CARRIAGE.replace("11.5 kg", f"{MASS:g} kg")


def with_limit(recording: Recording) -> tuple[Fit, Fit]:
    rig = scenario(TRUE).rig
    plain = fitted(Model(rig, ()), imposed_runs([recording], rig))
    assert plain is not None
    (limit,) = clipping.propose(plain)
    made = fitted(plain.model.plus(limit), plain.runs, after=plain, bar=plain)
    assert made is not None
    return plain, made


def test_a_reading_that_stops_below_what_the_motion_needs_is_named() -> None:
    made = recorded(lambda time, position, speed: 0 * time)
    plain, clipped = with_limit(made.with_values("force_N", np.clip(made.channels["force_N"].values, -18.0, 18.0)))
    assert clipped.log_odds > plain.log_odds + 8.0
    assert clipped.rig.part("clipping").limit == pytest.approx(18.0, rel=3e-3)  # type: ignore[attr-defined]


def test_a_drive_that_gives_no_more_than_its_limit_clips_nothing() -> None:
    """The motion is what a force that stops at 30 N makes of the mass: the model needs just that."""
    fine = np.arange(FINE * COUNT) / RATE / FINE
    given = np.clip(60 * np.sin(2 * np.pi * 0.5 * fine), -30.0, 30.0)
    speed = np.cumsum(given) / RATE / FINE / MASS
    position = np.cumsum(speed - speed.mean()) / RATE / FINE
    noise = 0.3 * np.random.default_rng(3).standard_normal(COUNT)
    force = np.clip(given[::FINE] + noise * (np.abs(given[::FINE]) < 30.0), -30.0, 30.0)
    made = recorded(lambda time, *_: 0 * time).with_values("force_N", force).with_values("position_m", position[::FINE])
    plain, clipped = with_limit(made)
    assert clipped.log_odds < plain.log_odds + 8.0
