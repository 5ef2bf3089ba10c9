"""What a notebook shows of a recording: plots with all samples, in a frame, without a request to the net."""

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.figures.picture import new_figure

RATE = 5000.0
SAMPLES = 40_000


@pytest.fixture(scope="module")
def recording():
    time = np.arange(SAMPLES) / RATE
    torque = 1 + 0.1 * np.sin(2 * np.pi * 50 * time)
    torque[30_001] = 7.5  # one sample that no view may lose
    torque[100:110] = np.nan
    channels = {
        "x": Channel(values=0.5 * time, quantity="position", unit="mm"),
        "torque_V": Channel(values=torque, quantity="torque", unit="V"),
    }
    return Recording(sample_rate=RATE, channels=channels, name="run <1>.csv")


@pytest.fixture(scope="module")
def frame(recording):
    return recording.plot()._repr_html_()


def test_a_notebook_gets_a_frame_and_a_picture_for_those_that_show_no_html(recording, frame):
    assert frame.startswith('<iframe title="run &lt;1&gt;.csv"')
    assert recording.plot()._repr_png_().startswith(b"\x89PNG")
    formatters = pytest.importorskip("IPython.core.formatters")
    bundle = formatters.DisplayFormatter().format(recording.plot())[0]
    assert {"text/html", "image/png"} <= bundle.keys()


def test_other_figures_stay_pictures():
    assert new_figure(2, 2)._repr_html_() is None


DRAWN = """async () => {
  const opened = await openPlot('plot-channels'), drawn = (name) => opened.document.get_model_by_name(name).data.y;
  const text = await csvOf(document.getElementById('channels'));
  return {
    peak: Math.max(...drawn('torque_V')), places: drawn('x (channel)').length, lines: text.split('\\n').length,
    head: text.split('\\n')[0], gap: opened.curves.torque_V.values[105], content: document.documentElement.scrollHeight,
  };
}"""


def test_the_frame_draws_every_peak_and_saves_every_sample(chromium, frame, tmp_path):
    file = tmp_path / "notebook.html"
    file.write_text(f"<!DOCTYPE html><p>cell</p>{frame}", encoding="utf-8")
    page, asked, errors = chromium.new_page(viewport={"width": 1000, "height": 900}), [], []
    page.on("request", lambda one: asked.append(one.url))
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(file.as_uri())
    found = page.frames[1].evaluate(DRAWN)
    height = page.evaluate("document.querySelector('iframe').clientHeight")
    page.close()
    assert [one for one in asked if not one.startswith(("file:", "data:", "blob:", "about:"))] == []
    assert errors == []
    assert found["peak"] == pytest.approx(7.5, rel=1e-4)
    assert 0 < found["places"] < 3000
    assert found["lines"] == SAMPLES + 2
    assert found["head"] == "time [s],torque_V,x (channel)"
    assert found["content"] <= height  # no second scroll bar
    assert 0.8 < found["gap"] < 1.2  # a straight line over what has no number
