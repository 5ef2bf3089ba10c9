"""Orders: lines of known amplitude come back, and lines of the shaft are told from fixed frequencies."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.orders.analysis.angle_resampling import cubic, output_turns, over_angle
from torquerig.orders.analysis.labels import causes_of, label_of, mains_multiple
from torquerig.orders.analysis.line_detection import detected_lines
from torquerig.orders.analysis.line_domain import DomainTest
from torquerig.orders.analysis.order_maps import order_map, speed_map
from torquerig.orders.analysis.order_spectrum import LineSpectrum, line_amplitude, order_spectrum
from torquerig.orders.analysis.peaks import floor_of, peaks_of
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, SECONDS = 5000.0, 12.0
TIME = np.arange(int(RATE * SECONDS)) / RATE
TOP = 1000 * pi / 30
DRIVE = Kinematics(pole_pairs=7, slots=12, ratio=5.0)
LINES = {1.0: 0.10, 35.0: 0.04, 84.0: 0.02}  # output order: amplitude


def ramp_angle():
    speed = TOP * np.where(TIME < 0.9 * SECONDS, 0.1 + TIME / SECONDS, 1.0)
    return np.cumsum(speed) / RATE


def steady_angle():
    return TOP * TIME


def made(angle, *, fixed=(), noise=0.01):
    torque = 1 + noise * np.random.default_rng(1).normal(size=TIME.size)
    for order, amplitude in LINES.items():
        torque += amplitude * np.cos(order * angle / 5 + 0.3 * order)
    for frequency, amplitude in fixed:
        torque += amplitude * np.cos(2 * pi * frequency * TIME + 0.7)
    channel = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=TOP, profile="ramp"))


@pytest.mark.parametrize("angle", [ramp_angle(), steady_angle()], ids=["ramp", "steady"])
def test_lines_of_known_amplitude_come_back_within_a_hundredth(angle):
    recording = made(angle, noise=0.0)
    turns = output_turns(angle, ratio=5.0)
    for order, amplitude in LINES.items():
        assert line_amplitude(recording.torque(), turns, order) == pytest.approx(amplitude, rel=0.01)


def test_the_order_spectrum_of_a_ramp_is_that_of_a_steady_run():
    # 40 turns at constant speed, or 40 turns by a ramp: the same lines, on bins
    time = np.arange(60001) / RATE
    turns = 40 * (time / time[-1]) ** 2
    signal = 0.3 * np.cos(2 * pi * 7 * turns) + 0.1 * np.cos(2 * pi * 20 * turns)
    spectrum = order_spectrum(over_angle(made(ramp_angle()), turns, signal), highest=30.0)
    at = {order: spectrum.amplitudes[round(order / spectrum.width)] for order in (7, 20, 13)}
    assert at[7] == pytest.approx(0.3, rel=0.01)
    assert at[20] == pytest.approx(0.1, rel=0.01)
    assert at[13] < 1e-3


def test_a_cubic_keeps_cubics_and_loses_what_it_says():
    x = np.arange(200.0)
    at = np.linspace(3, 190, 777)
    assert cubic(x**3 - 5 * x**2, at) == pytest.approx(at**3 - 5 * at**2, rel=1e-9)
    wave = cubic(np.cos(2 * pi * 0.08 * x), at)
    assert wave == pytest.approx(np.cos(2 * pi * 0.08 * at), abs=2e-3)


def test_on_a_ramp_the_lines_of_the_shaft_are_told_from_the_fixed_one():
    recording = made(ramp_angle(), fixed=[(150.37, 0.03), (50.0, 0.02)])
    found = detected_lines(recording, output_turns(ramp_angle(), ratio=5.0), DRIVE)
    shaft = {round(one.place, 1): one for one in found if one.axis == "order"}
    fixed = {round(one.place, 1): one for one in found if one.axis == "frequency"}
    assert set(shaft) == set(LINES)
    assert set(fixed) == {50.0, 150.4}
    for order, amplitude in LINES.items():
        assert shaft[order].amplitude == pytest.approx(amplitude, rel=0.03)
        assert shaft[order].domain.contrast_dB > 4
    assert fixed[150.4].amplitude == pytest.approx(0.03, rel=0.03)
    assert fixed[150.4].domain.contrast_dB < -4
    assert fixed[150.4].label == ""
    assert fixed[50.0].label == "1 x mains"
    assert "electrical x1" in shaft[35.0].label
    assert shaft[84.0].label == "slots times pole pairs x1 or mesh with 84 teeth"


def test_one_order_line_and_one_fixed_line_at_the_same_place_of_the_top_speed_are_told_apart():
    # order 84 passes 280 Hz at the top speed, where a fixed line stands as well
    recording = made(ramp_angle(), fixed=[(280.0, 0.02)])
    found = detected_lines(recording, output_turns(ramp_angle(), ratio=5.0), DRIVE)
    told = {(one.axis, round(one.place)) for one in found}
    assert ("order", 84) in told
    assert ("frequency", 280) in told
    assert len(found) == len(LINES) + 1


def test_a_steady_run_cannot_tell_and_says_so():
    recording = made(steady_angle(), fixed=[(150.37, 0.03)])
    found = detected_lines(recording, output_turns(steady_angle(), ratio=5.0), DRIVE)
    assert {one.axis for one in found} == {"either"}
    assert len(found) == len(LINES) + 1


def test_at_one_speed_a_line_at_an_order_of_a_shaft_is_no_fixed_frequency():
    # an angle that wanders by the error of its source smears the lines of the shaft, not those of a clock
    random = np.random.default_rng(4)
    wander = np.cumsum(random.normal(size=TIME.size)) * 0.003
    wander -= np.linspace(0, wander[-1], TIME.size)
    recording = made(steady_angle(), fixed=[(33 * TOP / (2 * pi), 0.05), (241.7, 0.05)])
    found = detected_lines(recording, output_turns(steady_angle() + wander, ratio=5.0), DRIVE)
    at = {round(one.place, 1): one for one in found if one.detected_over == "frequency" and one.amplitude > 0.03}
    assert at[550.0].axis == "either"
    assert at[550.0].domain.domain == "frequency"
    assert at[241.7].axis == "frequency"
    shaft = next(one for one in found if "electrical x1" in one.label)
    assert shaft.axis == "either"


def test_noise_alone_shows_no_line():
    torque = np.random.default_rng(3).normal(size=TIME.size)
    channel = Channel(values=torque, quantity="torque", unit="V")
    recording = Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=TOP))
    assert detected_lines(recording, output_turns(ramp_angle(), ratio=5.0), DRIVE) == ()


def test_the_contrast_of_a_pure_sine_is_what_the_sweep_makes_it():
    # a line of the shaft that sweeps evenly over many bins: the angle gathers all of it, time a small share
    angle = ramp_angle()
    turns = output_turns(angle, ratio=5.0)
    values = np.cos(84 * angle / 5)
    even = over_angle(made(angle), turns, values)
    domain = DomainTest(values, turns, even.values).of_order(84.0)
    assert domain.by_order > 0.9
    assert domain.by_frequency < 0.15  # held for a tenth of the time, a sixth of the turns
    assert domain.domain == "order"


def test_the_floor_is_the_noise_and_a_line_does_not_move_it():
    amplitudes = np.random.default_rng(5).rayleigh(scale=1.0, size=4800)
    plain = floor_of(amplitudes)
    assert plain == pytest.approx(np.full(4800, np.sqrt(2)), rel=0.5)
    amplitudes[2000] = 1000.0
    assert floor_of(amplitudes) == pytest.approx(plain, rel=0.05)


def test_a_skirt_is_no_line_of_its_own():
    amplitudes = np.full(2000, 1.0)
    amplitudes[500], amplitudes[506], amplitudes[600] = 1000.0, 100.0, 100.0
    peaks = peaks_of(LineSpectrum(np.arange(2000.0), amplitudes), lowest=1.0)
    assert [round(one.place) for one in peaks] == [500, 600]


def test_turns_count_on_where_the_shaft_turns_back():
    angle = 100 * np.sin(np.linspace(0, 2 * pi, 5001))
    turns = output_turns(angle, ratio=5.0)
    assert turns[-1] == pytest.approx(400 / (2 * pi * 5), rel=1e-3)
    assert (np.diff(turns) >= 0).all()


def test_too_few_turns_are_refused():
    with pytest.raises(RecordingError, match="two turns or more"):
        over_angle(made(steady_angle()), np.linspace(0, 1.5, TIME.size))


def test_labels_name_every_cause_of_an_order():
    lines = DRIVE.lines(4)
    assert label_of(causes_of(35.001, lines, width=0.05)) == "electrical x1"
    assert "cogging per pole x2" in label_of(causes_of(60.0, lines, width=0.05))
    assert label_of(causes_of(33.3, lines, width=0.05)) == ""
    assert mains_multiple(149.97, mains=50.0, width=0.01) == 3
    assert mains_multiple(151.0, mains=50.0, width=0.1) is None


def test_maps_show_a_line_upright_over_its_own_axis():
    angle = ramp_angle()
    turns = output_turns(angle, ratio=5.0)
    recording = made(angle, fixed=[(150.0, 0.03)])
    over_orders = order_map(over_angle(recording, turns), turns, RATE, highest=100.0)
    over_hertz = speed_map(recording.torque(), turns, RATE, highest=400.0)
    assert over_orders.by_speed
    assert over_hertz.by_speed
    at_84 = over_orders.amplitudes[:, np.argmin(abs(over_orders.places - 84))]
    assert np.median(at_84) == pytest.approx(0.02, rel=0.15)
    at_150 = over_hertz.amplitudes[:, np.argmin(abs(over_hertz.places - 150))]
    assert np.median(at_150) == pytest.approx(0.03, rel=0.15)
    assert over_orders.rows[-1] == pytest.approx(TOP / (2 * pi) / 5, rel=0.05)
    assert np.isfinite(over_orders.amplitudes).all()


def test_a_steady_run_is_mapped_over_time():
    turns = output_turns(steady_angle(), ratio=5.0)
    shown = speed_map(made(steady_angle()).torque(), turns, RATE, highest=400.0)
    assert not shown.by_speed
    assert 0 < shown.rows[0] < shown.rows[-1] < SECONDS


def test_a_weak_line_counts_where_one_is_expected_and_nowhere_else():
    rng = np.random.default_rng(2)
    # amplitudes of noise: Rayleigh, rms 1; a peak of 3.7 is one bin in a million of it, and 20 000 are looked at
    places = 0.05 * np.arange(20_000)
    amplitudes = np.minimum(rng.rayleigh(np.sqrt(0.5), places.size), 3.0)
    amplitudes[2000] = amplitudes[7003] = 3.7
    spectrum = LineSpectrum(places=places, amplitudes=amplitudes)
    assert peaks_of(spectrum, lowest=1.0) == ()
    (found,) = peaks_of(spectrum, lowest=1.0, expected=[50.0, 100.0, 150.0])
    assert found.place == pytest.approx(100.0, abs=0.05)
