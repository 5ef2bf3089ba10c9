"""The load that a recording ran against, drawn again: a shaft that holds its speed passes it to the sensor."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import ParticleLoad
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.drawn_loads import drawn_loads
from torquerig.simulation.simulator import simulate

_RATE, _DURATION, _BLOCK = 5000.0, 20.0, 0.5  # [Hz], [s], [s]


@pytest.fixture(scope="module")
def rig() -> Rig:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    run = Run(speed=1000 * pi / 30, occupancy_percent=5.0, particle_size=0.0005)
    return read_scenario(document, load_catalog(shipped_folder()), seed=1).rig.at(run)


def _blocks(torque: NDArray[np.float64]) -> NDArray[np.float64]:
    means = torque.reshape(-1, int(_BLOCK * _RATE)).mean(axis=1)
    return np.asarray(means - means.mean())


@pytest.mark.long
def test_slow_torque_of_the_sensor_is_the_load_that_was_drawn(rig: Rig) -> None:
    """Of half a second the inertias behind the sensor take little, and its own zero nothing."""
    recording = simulate(rig, duration=_DURATION, seed=7, sample_rate=_RATE)
    ((load, given),) = drawn_loads(rig, recording)
    read, drawn = _blocks(recording.torque()), _blocks(given[-recording.samples :])
    assert load.name == next(part.name for part in rig.parts_of(ParticleLoad))
    assert np.corrcoef(read, drawn)[0, 1] > 0.98
    assert read @ drawn / (drawn @ drawn) == pytest.approx(1.0, abs=0.05)


def test_another_seed_drew_another_load(rig: Rig) -> None:
    first, second = (
        drawn_loads(rig, simulate(rig, duration=2.0, seed=seed, sample_rate=_RATE))[0][1] for seed in (7, 8)
    )
    assert first.shape == second.shape
    assert abs(np.corrcoef(first, second)[0, 1]) < 0.5


def test_settling_comes_first(rig: Rig) -> None:
    recording = simulate(rig, duration=2.0, seed=7, sample_rate=_RATE, settling=0.4)
    assert drawn_loads(rig, recording, settling=0.4)[0][1].size == recording.samples + 0.4 * _RATE
