"""FIR and causal low-passes against their closed forms, and the spike remover."""

from math import pi

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from torquerig.errors import InputError, RecordingError
from torquerig.filters.butterworth import CausalButterworthLowPass
from torquerig.filters.fir_low_pass import CausalFirLowPass, FirLowPass
from torquerig.filters.hampel import Hampel
from torquerig.recordings.recording import Channel, Recording

RATE = 1000.0
AT = np.arange(10_000) / RATE


def recording(values):
    torque = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": torque})


@pytest.mark.parametrize(("frequency", "gain"), [(5.0, 1.0), (20.0, 0.5), (40.0, 0.0)])
def test_a_window_has_no_delay_and_the_stated_gain(frequency, gain):
    wave = np.cos(2 * pi * frequency * AT)
    answer = FirLowPass(cutoff=20.0, transition=20.0).apply(recording(wave)).torque()
    middle = slice(1000, -1000)
    # 80 dB of ripple in pass and stop
    assert answer[middle] == pytest.approx(gain * wave[middle], abs=2e-4)


def test_a_causal_window_is_late_by_what_it_states():
    stage = CausalFirLowPass(cutoff=20.0, transition=20.0)
    values = np.random.default_rng(1).normal(size=AT.size)
    late = round(stage.delay(recording(values)) * RATE)
    assert late / RATE == stage.delay(recording(values))
    centred = FirLowPass(cutoff=20.0, transition=20.0).apply(recording(values)).torque()
    causal = stage.apply(recording(values)).torque()
    assert causal[2 * late :] == pytest.approx(centred[late:-late], abs=1e-12)


def test_a_causal_butterworth_is_scipys_and_states_its_delay():
    stage = CausalButterworthLowPass(cutoff=20.0, order=4)
    values = np.random.default_rng(2).normal(size=AT.size)
    sections = butter(4, 20.0, fs=RATE, output="sos")
    answer = stage.apply(recording(np.concatenate([[0.0], values]))).torque()
    assert np.array_equal(answer[1:], sosfilt(sections, values))
    late = (AT - stage.apply(recording(AT)).torque())[-1]
    assert late == pytest.approx(stage.delay(recording(AT)), rel=1e-9)


def test_constants_stay():
    for stage in (FirLowPass(cutoff=20.0, transition=20.0), CausalFirLowPass(cutoff=20.0, transition=20.0),
                  CausalButterworthLowPass(cutoff=20.0), Hampel()):  # fmt: skip
        assert stage.apply(recording(np.full(2000, 1.5))).torque() == pytest.approx(1.5, abs=1e-12)


def test_spikes_go_and_nothing_else_changes():
    rng = np.random.default_rng(3)
    clean = 2.0 + np.sin(2 * pi * 2 * AT) + 0.01 * rng.normal(size=AT.size)
    spikes = rng.choice(AT.size, 40, replace=False)
    torn = clean.copy()
    torn[spikes] += 3.0 * rng.choice([-1.0, 1.0], 40)
    answer = Hampel().apply(recording(torn)).torque()
    assert np.abs(answer[spikes] - clean[spikes]).max() < 0.15
    # of the others, at five robust deviations of 21 neighbours, few are touched
    others = np.setdiff1d(np.arange(AT.size), spikes)
    assert np.mean(answer[others] != clean[others]) < 0.005


def test_a_coarse_converter_makes_no_spikes():
    steps = np.round(np.sin(2 * pi * 0.5 * AT) * 20) / 20
    assert np.array_equal(Hampel().apply(recording(steps)).torque(), steps)


@pytest.mark.parametrize(
    "make",
    [
        lambda: FirLowPass(cutoff=0.0, transition=1.0),
        lambda: FirLowPass(cutoff=10.0, transition=30.0),
        lambda: CausalButterworthLowPass(cutoff=0.0),
        lambda: Hampel(half_window=0),
    ],
)
def test_filters_that_cannot_be_are_refused_here(make):
    with pytest.raises(InputError, match="is not possible"):
        make()


@pytest.mark.parametrize(
    ("stage", "samples", "message"),
    [
        (FirLowPass(cutoff=495.0, transition=20.0), 10_000, "lower the cutoff"),
        (FirLowPass(cutoff=20.0, transition=2.0), 500, "too few for a window"),
        (CausalButterworthLowPass(cutoff=500.0), 100, "lower the cutoff"),
    ],
)
def test_recordings_too_slow_or_short_are_refused(stage, samples, message):
    with pytest.raises(RecordingError, match=message):
        stage.apply(recording(np.zeros(samples)))
