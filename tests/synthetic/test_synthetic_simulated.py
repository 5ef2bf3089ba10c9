"""A simulated reading taken apart is the reading again when its parts are added."""

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.mechanisms import MainsInterference
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate
from torquerig.synthetic.mixture import components_of
from torquerig.synthetic.simulated import DIFFERENCE, STAGE, separated_contributions


@pytest.fixture(scope="module")
def rig() -> Rig:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    made = read_scenario(document, load_catalog(shipped_folder()), seed=1).rig
    return made + MainsInterference(name="mains", frequency=50.0, amplitudes=(0.02,))


@pytest.fixture(scope="module")
def apart(rig: Rig) -> Recording:
    return separated_contributions(rig, duration=0.5, seed=1)


def test_the_parts_sum_to_the_reading(rig: Rig, apart: Recording) -> None:
    reading = simulate(rig, duration=0.5, seed=1)
    assert np.array_equal(sum(components_of(apart).values(), np.zeros(apart.samples)), apart.torque())
    # the grid is 2^-40; a sensor's voltage is within one step of it
    assert apart.torque() == pytest.approx(reading.torque(), abs=2e-12)
    assert np.array_equal(apart.channels["encoder_count"].values, reading.channels["encoder_count"].values)


def test_a_stage_of_the_sensor_adds_what_it_is(apart: Recording) -> None:
    tone = components_of(apart)["tone"]
    amplitudes = np.abs(np.fft.rfft(tone)) * 2 / tone.size
    assert amplitudes[25] == pytest.approx(0.02, rel=1e-6)
    assert np.delete(amplitudes, 25).max() < 1e-6
    assert apart.origin["components"]["tone"] == STAGE


def test_mechanisms_are_labelled_as_differences_of_runs(apart: Recording) -> None:
    labels = apart.origin["components"]
    assert list(labels)[:2] == ["bare", "load"]
    assert labels["load"] == labels["shaft"] == labels["motor_cogging"] == DIFFERENCE
    assert set(labels) == set(components_of(apart))
    assert components_of(apart)["load"].mean() == pytest.approx(1.0, abs=0.2)
