import numpy as np
import pytest
from matplotlib.colors import to_rgb

from torquerig.errors import InputError
from torquerig.metrics.figure import Figure
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.figures.before_after_figure import before_after_figure
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure, svg, write_picture
from torquerig.reporting.figures.shades import GOOD_IS_HIGH, GOOD_IS_LOW, shade
from torquerig.reporting.figures.spectrum_figure import spectrum_figure
from torquerig.reporting.layout import figure_text, plain


@pytest.mark.parametrize("logarithmic", [False, True])
def test_the_envelope_keeps_every_extreme_and_few_points(logarithmic):
    x = np.linspace(1, 1000, 100_000)
    y = np.random.default_rng(1).standard_normal(x.size)
    y[54_321] = 99.0
    across, along = envelope(x, y, columns=100, logarithmic=logarithmic)
    assert across.size <= 200
    assert (along.max(), along.min()) == (99.0, y.min())
    assert np.all(np.diff(across) > 0)


def test_a_short_curve_is_drawn_as_it_is():
    x, y = np.arange(10.0), np.arange(10.0) ** 2
    assert envelope(x, y, columns=5)[1] is y


@pytest.mark.parametrize("value", np.linspace(0, 1, 21))
def test_text_on_the_colour_scale_has_the_contrast_that_wcag_asks_for(value):
    style = dict(part.split(":") for part in shade(value, 0, 1, scale=GOOD_IS_HIGH).split(";"))
    luminances = sorted(_luminance(to_rgb(style[key])) for key in ("background", "color"))
    assert (luminances[1] + 0.05) / (luminances[0] + 0.05) >= 4.5  # WCAG 2.2, success criterion 1.4.3, level AA


def test_the_scale_runs_from_orange_over_white_to_blue_never_from_red_to_green():
    colours = [to_rgb(shade(value, 0, 1, scale=GOOD_IS_HIGH)[11:18]) for value in (0.0, 0.5, 1.0)]
    assert colours[0][0] > colours[0][2]  # red above blue
    assert colours[1] == (1, 1, 1)
    assert colours[2][2] > colours[2][0]
    assert shade(0.2, 0, 1, scale=GOOD_IS_LOW) == shade(0.8, 0, 1, scale=GOOD_IS_HIGH)


def test_numbers_have_no_exponent():
    assert plain(1.3e3) == "1300"
    assert plain(2.0e-5) == "0.00002"
    assert figure_text(Figure(low=340.0, high=1.3e3)) == "340..1300"
    assert figure_text(Figure(value=0.1, low=0.1, high=0.1)) == "0.1"
    assert figure_text(Figure()) == "?"


def test_the_spectrum_labels_its_lines_by_cause(runs):
    drive = runs.drives[0]
    kinematics_lines = [
        level.line for level in drive.chains["report_filter_code"].effect.levels if level.line.harmonic == 1
    ]
    figure = spectrum_figure(
        drive.recording, drive.recording, lines=kinematics_lines, motor_speed=drive.motor_speed, ratio=5.0
    )
    texts = [text.get_text() for text in figure.axes[0].texts]
    assert "motor shaft  16.67 Hz" in texts
    assert "electrical  116.7 Hz" in texts
    peaks = max(figure.axes[0].lines, key=lambda line: len(line.get_xdata()))
    tallest = peaks.get_xdata()[np.argmax(peaks.get_ydata())]
    assert tallest == pytest.approx(116.67, abs=0.5)  # the sine of seven periods per motor turn, drawn at its place
    assert svg(figure) == svg(figure)


@pytest.mark.parametrize("ending", ["svg", "png"])
def test_a_picture_is_written_once_and_not_overwritten(tmp_path, ending):
    path = tmp_path / f"bars.{ending}"
    write_picture(new_figure(2, 1), path)
    drawn = path.read_bytes()
    assert drawn[:5] in (b"<?xml", b"\x89PNG\r")
    with pytest.raises(InputError, match="is there already"):
        write_picture(new_figure(3, 1), path)
    assert path.read_bytes() == drawn
    write_picture(new_figure(3, 1), path, overwrite=True)
    assert path.read_bytes() != drawn
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(("name", "told"), [("a.jpeg", "svg or .png"), ("missing/a.svg", "there is no folder")])
def test_a_picture_that_cannot_be_written_is_refused_in_words(tmp_path, name, told):
    with pytest.raises(InputError, match=told):
        write_picture(new_figure(2, 1), tmp_path / name)


def _luminance(colour):
    """Relative luminance of an sRGB colour, WCAG 2.2."""
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in colour]
    return float(np.dot([0.2126, 0.7152, 0.0722], linear))


def test_a_picture_of_a_filter_has_the_time_signal_above_the_spectrum():
    time = np.arange(20_000) / 5000
    values = 1 + 0.2 * np.sin(2 * np.pi * 100 * time)
    before = Recording(sample_rate=5000.0, channels={"torque_V": Channel(values=values, quantity="torque", unit="V")})
    after = before.with_values("torque_V", np.ones(values.size))
    lines = Kinematics(pole_pairs=7, slots=12, ratio=5.0).lines(1)
    figure = before_after_figure(before, after, lines=lines, motor_speed=2 * np.pi * 100 / 6, ratio=5.0)
    signal, spectrum = figure.axes[:2]
    assert signal.get_xlim() == pytest.approx((1.0, 1.3))
    # both ends of the sine, not an average; 50 samples a period miss its peak by 1 - cos(3.6 deg)
    assert np.ptp(signal.lines[0].get_ydata()) == pytest.approx(0.4, rel=3e-3)
    assert np.ptp(signal.lines[1].get_ydata()) == 0
    assert spectrum.get_xlabel() == "frequency [Hz]"
    assert spectrum.lines[0].get_ydata().max() == pytest.approx(0.2, rel=1e-3)
