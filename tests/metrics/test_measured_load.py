"""A measured load as the truth of a filter evaluation, and how much of the rest is load."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.metrics.load_shares import load_shares
from torquerig.metrics.measured_load import measured_load
from torquerig.metrics.truth_error import true_load, truth_error
from torquerig.recordings.recording import Channel, Recording

TIME = np.arange(4000) / 1000
LOAD = 2 + np.convolve(np.random.default_rng(1).normal(size=TIME.size), np.ones(50) / 7, mode="same")
LINE = 1.5 * np.cos(2 * pi * 60 * TIME)


def recording(reading=LOAD + LINE, **further: Channel) -> Recording:
    torque = Channel(values=reading, quantity="torque", unit="N*m", role="compared")
    return Recording(sample_rate=1000.0, channels={"torque_Nm": torque, **further})


def channel(values, **stated) -> Channel:
    return Channel(values=values, quantity="torque", unit="N*m", **stated)


def test_an_input_of_the_readings_quantity_is_the_load():
    both = recording(brake=channel(LOAD, role="input"))
    assert true_load(both) == pytest.approx(LOAD)
    assert truth_error(both, both) == pytest.approx(1.5 / np.sqrt(2), rel=0.01)
    assert true_load(recording(other=channel(LOAD))) is None
    assert true_load(recording(other=channel(LOAD, role="context"))) is None


def test_a_load_sensor_the_other_way_round_is_the_same_load():
    found = measured_load(recording(brake=channel(-LOAD, role="input")))
    assert found is not None
    assert found.is_turned
    assert found.values == pytest.approx(LOAD)
    mirrored = measured_load(recording(reading=-LOAD - LINE, brake=channel(LOAD, of="load")))
    assert mirrored is not None
    assert mirrored.values == pytest.approx(-LOAD)


def test_the_simulated_truth_goes_before_a_measured_load():
    both = recording(brake=channel(LOAD + 1, role="input"), true_load_Nm=channel(LOAD, truth=True))
    assert true_load(both) == pytest.approx(LOAD)


def test_of_two_inputs_the_one_that_is_the_load_is_named():
    two = {"brake": channel(LOAD, role="input"), "drive": channel(LINE, role="input")}
    with pytest.raises(RecordingError, match="write of: load at the one that is"):
        measured_load(recording(**two))
    named = measured_load(recording(**{**two, "brake": channel(LOAD, role="input", of="load")}))
    assert named is not None
    assert named.channel == "brake"


def test_the_shares_say_how_much_is_load():
    both = recording(brake=channel(LOAD, role="input"))
    shares = load_shares(both, recording(reading=LOAD), longest=0.02)
    assert shares is not None
    # by hand: variance of the load over that of load plus line
    assert shares.before == pytest.approx(LOAD.var() / (LOAD.var() + LINE.var()), abs=0.03)
    assert shares.after == pytest.approx(1.0)
    assert shares.removed < 0.02
    assert load_shares(recording(), recording(), longest=0.02) is None
