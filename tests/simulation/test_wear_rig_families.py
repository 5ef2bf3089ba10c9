"""The five line families of the reference report in the simulated 1:5 BLDC run, and none behind its filter."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.filters.chains.chain_file import read_chains
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

MESH = "rig.mesh={kind: gear_mesh, order_output: 84, transmission_error: [5.0e-5 rad]}"
DURATION = 12.0  # [s] whole periods of all five at 1000 rpm; the load's noise falls with its root

# reference report, Table I at 1000 rpm: the fundamental of each family [Hz]
FAMILIES = {"shaft": 200 / 60, "motor": 1000 / 60, "cogging": 100.0, "electrical": 7000 / 60}


@cache
def spectra(*settings: str) -> dict[str, NDArray[np.float64]]:
    """Amplitude [N m] by frequency of the reading, before and after the reference report's chain."""
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), settings)
    scenario = read_scenario(document, load_catalog(shipped_folder()), seed=1)
    wander = scenario.operating_point.slow_speed_wander
    reading = simulate(scenario.rig, duration=DURATION, seed=1, wander=wander)
    chains = read_chains(shipped_scenarios() / "filters.yaml", kinematics=kinematics_of(scenario.rig))
    chain = chains["report_filter_code"]
    made = {"before": reading.torque(), "after": chain.apply(reading).torque()}
    return {name: 2 / values.size * np.abs(np.fft.rfft(values - values.mean())) for name, values in made.items()}


def line(levels: NDArray[np.float64], frequency: float) -> float:
    """The largest amplitude within 0.25 Hz: the speed wanders by 2e-4, that is 0.06 Hz at 280 Hz."""
    at, reach = round(frequency * DURATION), round(0.25 * DURATION)
    return float(levels[at - reach : at + reach + 1].max())


def beside(levels: NDArray[np.float64], frequency: float) -> float:
    """The largest amplitude from 0.6 to 1.6 Hz beside a line, 26 values."""
    at, near, far = (round(one * DURATION) for one in (frequency, 0.6, 1.6))
    return float(np.concatenate([levels[at - far : at - near + 1], levels[at + near : at + far + 1]]).max())


@pytest.mark.parametrize("family", FAMILIES)
def test_four_families_stand_at_their_frequencies_and_are_gone_behind_the_report_filter(family: str) -> None:
    frequency = FAMILIES[family]
    made = spectra()
    assert line(made["before"], frequency) > 1.5 * beside(made["before"], frequency)
    assert line(made["after"], frequency) < 1e-9


def test_the_fifth_family_at_280_hz_is_absent_until_a_mesh_of_ring_84_is_added() -> None:
    """Nothing of the nominal rig stands at 280 Hz: order 84 of the output shaft needs the gear mesh."""
    plain, meshed = spectra(), spectra(MESH)
    assert line(plain["before"], 280.0) < 1.5 * beside(plain["before"], 280.0)
    assert line(meshed["before"], 280.0) > 5 * beside(meshed["before"], 280.0)
    assert line(meshed["before"], 280.0) > 50 * line(plain["before"], 280.0)
    assert line(meshed["after"], 280.0) < 1e-9


@pytest.mark.parametrize("harmonic", [2, 3, 4])
def test_harmonics_of_the_electrical_family_stand_too(harmonic: int) -> None:
    frequency = harmonic * FAMILIES["electrical"]
    assert line(spectra()["before"], frequency) > 1.5 * beside(spectra()["before"], frequency)
