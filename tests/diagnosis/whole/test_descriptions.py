"""Noise of a fixed band: its density by its own samples, and no name for what only describes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.signal import welch

from torquerig.diagnosis.engine import diagnose
from torquerig.errors import InputError
from torquerig.mechanisms import NoiseHump
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.scenario.model import Scenario
from torquerig.sensor_stages.band_noise import BandNoise

RATE = 5000.0


def quiet(samples: int) -> Recording:
    channel = Channel(values=np.zeros(samples), quantity="torque", unit="V", si_per_unit=1.0)
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=100.0))


def test_band_noise_has_the_density_it_states() -> None:
    """Averaged over 600 segments, within 5 % over the band; its mean between two edges is the density's integral."""
    noise = BandNoise(rms=0.02, frequency=400.0, width=0.1)
    made = noise.apply(quiet(300_000)).channels["torque_V"].values
    assert made.std() == pytest.approx(0.02, rel=0.03)
    frequency, density = welch(made, RATE, nperseg=1000)
    inside = (frequency > 330) & (frequency < 490)
    assert density[inside] == pytest.approx(noise.density(frequency[inside], RATE), rel=0.2)
    assert density[inside].mean() == pytest.approx(noise.density(frequency[inside], RATE).mean(), rel=0.05)
    fine = np.linspace(350.0, 420.0, 5001)
    mean = noise.density_between(np.array([350.0]), np.array([420.0]))
    assert mean[0] == pytest.approx(noise.density(fine, RATE).mean(), rel=0.01)


@pytest.mark.parametrize("wrong", [{"rms": -1.0}, {"frequency": 0.0}, {"width": 0.0}])
def test_noise_that_cannot_be_is_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(InputError, match="cannot be"):
        BandNoise(**{"rms": 0.1, "frequency": 100.0, "width": 0.1, **wrong})


@pytest.mark.long
def test_noise_of_a_fixed_band_gets_no_name(known_rig: Scenario, three_runs: Callable[..., list[Recording]]) -> None:
    """It is described, modelled and written, but nothing is called missing."""
    hidden = known_rig.rig + NoiseHump(name="hidden", rms=0.08, frequency=400.0, width=0.03)
    outcome = diagnose(known_rig, three_runs(hidden, 5), seed=0)
    diagnosis = outcome.diagnosis
    assert diagnosis.verdict == "unexplained"
    assert diagnosis.findings == ()
    assert diagnosis.fit.after < 0.5 * diagnosis.fit.before
    (said,) = (remark for remark in diagnosis.remarks if "No mechanism of the library explains" in remark)
    assert "V rms in a fixed band around" in said
    found = outcome.completed.part("noise_hump")
    assert isinstance(found, NoiseHump)
    assert (found.frequency, found.rms) == (pytest.approx(400.0, rel=0.02), pytest.approx(0.08, rel=0.15))
