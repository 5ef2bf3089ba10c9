"""The picture of a recording is drawn for sound and for faulty ones, the same bytes each time."""

import numpy as np
import pytest

from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.figures.info_figure import info_figure
from torquerig.reporting.figures.picture import svg


def recording(values: np.ndarray) -> Recording:
    channels = {
        "angle_rad": Channel(values=np.arange(values.size) / 10.0, quantity="angle", unit="rad"),
        "torque_V": Channel(values=values, quantity="torque", unit="V"),
        "true_load_Nm": Channel(values=values, quantity="torque", unit="N*m", truth=True),
    }
    return Recording(sample_rate=1000.0, channels=channels, name="run1.csv")


def noise(count: int = 5000) -> np.ndarray:
    return np.random.default_rng(1).standard_normal(count)


def test_panels_marks_and_axes() -> None:
    values = noise()
    values[100:110], values[3000] = np.nan, 99.0
    figure = info_figure(recording_info(recording(np.minimum(values, 50.0))), main="torque_V", output_speed=20.0)
    torque, angle, spectrum, levels = figure.axes[:4]
    assert [axes.get_ylabel() for axes in (torque, angle)] == ["torque_V", "angle_rad"]
    legend = torque.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["no numbers (1)", "spikes (1)"]
    assert spectrum.get_xscale() == "log"
    assert "order of the output shaft [1/rev]" in {child.get_xlabel() for child in spectrum.child_axes}
    assert levels.get_ylabel() == "share of samples [%]"


@pytest.mark.long
def test_the_same_recording_gives_the_same_bytes() -> None:
    first, second = (svg(info_figure(recording_info(recording(noise(300_000))), main="torque_V")) for _ in range(2))
    assert first == second


@pytest.mark.long
def test_short_constant_and_lost_signals_are_drawn() -> None:
    for values in (np.full(50, 0.7), np.array([1.0, 2.0]), np.full(50, np.nan), np.zeros(3)):
        assert svg(info_figure(recording_info(recording(values)), main="torque_V")).startswith(b"<?xml")
