"""Smallest visible sizes under measured motion, against the gain of data of that size, and pairs that are alike."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.moved_rigs import CARRIAGE, RATE, recorded, scenario
from torquerig.inference.motion.beforehand import inseparable, limits, signatures
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypotheses import plain
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import imposed_runs
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]


def nominal(recording: Recording) -> Fit:
    rig = scenario(CARRIAGE).rig
    fit = fitted(Model(rig, ()), imposed_runs([recording], rig))
    assert fit is not None
    return fit


def true_mass(time: Floats, position: Floats, speed: Floats) -> Floats:
    """1.5 kg more than the 10 kg of the recording are the stated 11.5 kg."""
    return np.asarray(1.5 * np.gradient(speed, time))


def test_a_drift_of_the_smallest_size_gains_what_an_addition_needs() -> None:
    sizes = {row["mechanism"]: row for row in limits(signatures(nominal(recorded(true_mass))), "N")}
    span = sizes["sensor_drift"]["value"]
    assert sizes["stribeck_friction"]["unit"] == "N"

    def drifts(time: Floats, position: Floats, speed: Floats) -> Floats:
        return np.asarray(true_mass(time, position, speed) + span * time / time[-1])

    fit = nominal(recorded(drifts))
    drift = next(each for each in plain.propose(fit) if each.name == "sensor_drift")
    made = fitted(fit.model.plus(drift), fit.runs, after=fit, steps=0)
    assert made is not None
    deviations = float(np.sqrt(2 * (8.0 + 1.0 + 3.0)) + 1.645)
    row = made.names.index("sensor_drift[0]")
    found = float(made.positions[row] / np.sqrt(made.covariance[row, row]))
    assert found == pytest.approx(deviations, abs=2.5)  # two standard deviations, and the prior


def test_one_way_at_one_speed_leaves_drag_and_friction_alike() -> None:
    rng, time = np.random.default_rng(2), np.arange(4800) / RATE
    position = 0.02 * time + 1e-4 * np.sin(2 * np.pi * 1.3 * time)
    channels = {
        "force_N": Channel(values=rng.standard_normal(time.size), quantity="force", unit="N"),
        "position_m": Channel(values=position, quantity="position", unit="m"),
    }
    found = signatures(nominal(Recording(sample_rate=RATE, channels=channels, name="way.csv")))
    pairs = [{one.mechanism, other.mechanism} for one, other in inseparable(found)]
    assert {"quadratic_drag", "stribeck_friction"} in pairs
    both = signatures(nominal(recorded(true_mass)))
    assert {"quadratic_drag", "stribeck_friction"} not in [{a.mechanism, b.mechanism} for a, b in inseparable(both)]
