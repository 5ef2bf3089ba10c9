"""Delays between effort and motion, and loops that answer deviations of the motion, are no missing mechanisms."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import lfilter

from tests.moved_rigs import CARRIAGE, RATE, recorded, scenario
from torquerig.inference.motion import hypotheses
from torquerig.inference.motion.engine import MotionOutcome
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.held_out import HeldOut
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import ImposedRun, imposed_runs
from torquerig.inference.motion.parameters_found import delays
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]


def runs_of(recording: Recording) -> tuple[ImposedRun, ...]:
    return imposed_runs([recording], scenario(CARRIAGE).rig)


def later(recording: Recording, samples: int) -> Recording:
    """The same with its effort later by whole samples."""
    force = recording.channels["force_N"]
    moved = Channel(values=np.roll(force.values, samples), quantity=force.quantity, unit=force.unit)
    return Recording(
        sample_rate=recording.sample_rate, name=recording.name, channels={**recording.channels, "force_N": moved}
    )


def inertia(
    time: NDArray[np.float64], position: NDArray[np.float64], speed: NDArray[np.float64]
) -> NDArray[np.float64]:
    """1.5 kg more than stated make the stated mass true."""
    return 1.5 * np.gradient(speed, time)


@pytest.mark.parametrize("samples", [-1, 1])
def test_a_delay_of_the_effort_is_estimated_and_no_missing_physics(samples: int) -> None:
    runs = runs_of(later(recorded(inertia), samples))
    plain = fitted(Model(scenario(CARRIAGE).rig, ()), runs)
    assert plain is not None
    (delay,) = hypotheses.delay.propose(plain)
    fit = fitted(plain.model.plus(delay), runs, after=plain, steps=0)
    assert fit is not None
    assert fit.log_odds > plain.log_odds + 8.0
    (fact,) = delays(MotionOutcome(runs, plain, plain, fit, (HeldOut(0.0, [], ()),) * 3, (), ()))
    assert fact["estimated"]["value"] == pytest.approx(samples / RATE, abs=0.15 / RATE)


def test_the_answer_of_a_loop_to_the_motion_is_one_hypothesis() -> None:
    """A proportional loop on a noisy position: its effort follows the motion, and is no function of the speed."""
    rng, time = np.random.default_rng(5), np.arange(6000) / RATE
    swing = 1e-4 * lfilter([0.1], [1.0, -0.9], rng.standard_normal(time.size))
    position = 0.02 * time + swing
    force = -4e4 * swing + 0.3 * rng.standard_normal(time.size)
    channels = {
        "force_N": Channel(values=force, quantity="force", unit="N"),
        "position_m": Channel(values=position, quantity="position", unit="m"),
    }
    runs = runs_of(Recording(sample_rate=RATE, channels=channels, name="loop.csv"))
    plain = fitted(Model(scenario(CARRIAGE).rig, ()), runs)
    assert plain is not None
    gains = {}
    for each in hypotheses.smooth.propose(plain):
        made = fitted(plain.model.plus(each), runs, after=plain, steps=0)
        gains[each.name] = 0.0 if made is None else made.log_odds - plain.log_odds
    best = gains.pop("motion_response")
    assert best > 8.0 + max(gains.values())
