"""Synthetic signals are what they say: flat spectra, exact sums, closed forms, the same bytes for the same seed."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.document import parse_document
from torquerig.errors import InputError, RecordingError
from torquerig.filters.chains.filter_chain import report_filter_code_chain
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Recording, random_for
from torquerig.recordings.run import Run
from torquerig.recordings.spectrum import amplitude_spectrum
from torquerig.synthetic.control_signal import control_signal
from torquerig.synthetic.description import read_mixture
from torquerig.synthetic.mixture import components_of, mixed, volts
from torquerig.synthetic.pairs import load_only, noise_only
from torquerig.synthetic.sweep import sweep

MIXTURE = """
synthetic: made
duration: 2 s
sample_rate: 5 kHz
seed: 3
motor: bldc-12n14p
gear_ratio: 5
motor_speed: 1000 rpm
speed_error: 0.4 %
speed_wander: 0.1 %
counts_per_rev: 16384
components:
  mean: {type: constant, part: load, torque: 1 N*m}
  slow: {type: coloured_noise, part: load, rms: 0.06 N*m, cutoff: 1.5 Hz}
  hits: {type: hits, part: load, rate: 60 1/s, height: 0.1 N*m, decay: 4 ms}
  start: {type: step, part: load, torque: 0.2 N*m, at: 500 ms, until: 1 s}
  ripple: {type: order_line, order: 84, amplitude: 0.05 N*m}
  mains: {type: sine, frequency: 50 Hz, amplitude: 10 mN*m, phase: 90 deg}
  white: {type: white_noise, rms: 5 mN*m}
  chirp: {type: sweep, start: 10 Hz, stop: 1 kHz, amplitude: 20 mN*m}
  flat: {type: control, amplitude: 0.1 mN*m}
"""


def made(text: str = MIXTURE) -> Recording:
    return mixed(read_mixture(parse_document(text, Path("made.yaml"))))


@pytest.mark.parametrize("samples", [1000, 1001, 2])
def test_the_control_signal_has_every_frequency_at_equal_amplitude(samples: int) -> None:
    values = control_signal(samples, amplitude=0.3, rng=random_for(1, "x"))
    _, amplitudes = amplitude_spectrum(values, 1.0)
    assert amplitudes == pytest.approx(np.full(samples // 2 + 1, 0.3), rel=1e-12)


def test_the_report_filter_cuts_its_lines_from_the_control_signal_and_nothing_else() -> None:
    # reference report, Figures 4.4 and 4.5: the filtered control signal is gone in the bands and as before outside
    kinematics = Kinematics(pole_pairs=7, slots=12, ratio=5.0)
    chain = report_filter_code_chain(kinematics)
    speed = 1000 * np.pi / 30
    values = control_signal(50_000, amplitude=1.0, rng=random_for(1, "x"))
    recording = Recording(sample_rate=5000.0, channels={"torque_V": volts(values)}, run=Run(speed=speed))
    frequencies, amplitudes = amplitude_spectrum(chain.apply(recording).torque(), 5000.0)
    inside = np.zeros(frequencies.size, dtype=bool)
    for line in chain.lines:
        inside |= np.abs(frequencies - line.frequency(speed)) <= 0.5 + 1e-9
    assert inside.sum() > 100
    assert np.abs(amplitudes[inside]).max() < 1e-12
    assert amplitudes[~inside] == pytest.approx(np.ones((~inside).sum()), rel=1e-9)


@pytest.mark.parametrize("logarithmic", [True, False])
@pytest.mark.parametrize(("start", "stop"), [(5.0, 400.0), (400.0, 5.0), (50.0, 50.0)])
def test_a_sweep_runs_from_start_to_stop(start: float, stop: float, logarithmic: bool) -> None:
    time = np.arange(100_000) / 10_000
    wave = sweep(time, start=start, stop=stop, duration=10.0, logarithmic=logarithmic)
    crossings = np.flatnonzero((wave[:-1] < 0) & (wave[1:] >= 0))
    middle = np.sqrt(start * stop) if logarithmic else (start + stop) / 2
    half = np.searchsorted(crossings, 50_000)
    assert 10_000 / np.diff(crossings[half - 2 : half + 2]).mean() == pytest.approx(middle, rel=0.03)
    # turns are the integral of the frequency
    mean = (start + stop) / 2 if not logarithmic or start == stop else (stop - start) / np.log(stop / start)
    assert crossings.size == pytest.approx(10 * mean, abs=1.5)


def test_components_sum_to_the_mixture_to_the_last_bit() -> None:
    recording = made()
    parts = list(components_of(recording).values())
    assert len(parts) == 9
    for order in (parts, parts[::-1]):
        assert np.array_equal(sum(order, np.zeros(recording.samples)), recording.torque())
    load, noise = (recording.channels[f"true_{word}_Nm"].values for word in ("load", "noise"))
    assert np.array_equal(load + noise, recording.torque())
    assert np.array_equal(load, sum(components_of(recording)[name] for name in ("mean", "slow", "hits", "start")))


def test_components_are_their_closed_forms() -> None:
    recording = made()
    parts, time = components_of(recording), recording.time()
    assert parts["mains"] == pytest.approx(-0.01 * np.sin(2 * np.pi * 50 * time), abs=1e-12)
    assert np.array_equal(parts["start"] > 0, (time >= 0.5) & (time < 1.0))
    assert parts["white"].std() == pytest.approx(5e-3, rel=0.03)
    # mean of shot noise: rate * height * decay (Campbell's theorem)
    assert parts["hits"].mean() == pytest.approx(60 * 0.1 * 4e-3, rel=0.3)
    counts = recording.channels["encoder_count"].values
    assert (counts[-1] - counts[0]) / 16384 == pytest.approx(1000 / 60 * 2 * 1.004, rel=2e-3)
    # the line follows the encoder, not the set-point
    turned = np.cos(84 * 2 * np.pi * (counts + 0.5) / 16384)
    assert np.corrcoef(turned, parts["ripple"])[0, 1] > 0.9995


def test_load_only_and_noise_only_are_a_pair() -> None:
    recording = made()
    load, noise = load_only(recording), noise_only(recording)
    assert np.array_equal(load.torque() + noise.torque(), recording.torque())
    assert np.array_equal(load.torque(), load.channels["true_load_Nm"].values)
    assert not noise.channels["true_load_Nm"].values.any()
    assert list(load.channels) == list(noise.channels) == ["torque_V", "encoder_count", "true_load_Nm"]
    with pytest.raises(RecordingError, match="its load is not known"):
        load_only(Recording(sample_rate=1.0, channels={"torque_V": volts(np.zeros(3))}))


@pytest.mark.parametrize("ending", [".parquet", ".csv", ".mat", ".tdms"])
def test_the_same_seed_gives_the_same_bytes_in_every_format(tmp_path: Path, ending: str) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        write_recording(made(), tmp_path / folder / f"run1{ending}")
    for name in (f"run1{ending}", "run1.yaml"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    back = read_recording(tmp_path / "a" / f"run1{ending}")
    assert np.array_equal(sum(components_of(back).values(), np.zeros(back.samples)), back.torque())


def test_another_seed_gives_other_noise_and_the_same_lines() -> None:
    first, second = components_of(made()), components_of(made(MIXTURE.replace("seed: 3", "seed: 4")))
    assert not np.array_equal(first["white"], second["white"])
    assert np.array_equal(first["mains"], second["mains"])


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("type: sine", "type: sin", "made.yaml:18: components.mains: the component has no known type ('sin'); did you"),
        ("cutoff: 1.5 Hz", "cutof: 1.5 Hz", "made.yaml:14: components.slow.cutof: unknown key; did you mean 'cutoff'"),
        ("cutoff: 1.5 Hz", "cutoff: 1.5", "made.yaml:14: components.slow.cutoff: "),
        ("frequency: 50 Hz", "frequency: 3 kHz", "mains: 3000 Hz is not below half the sample rate of 5000 Hz"),
        ("motor_speed: 1000 rpm\n", "", "an encoder needs a speed to count; add motor_speed: 1000 rpm"),
        ("motor_speed: 1000 rpm\nspeed_error: 0.4 %\nspeed_wander: 0.1 %\ncounts_per_rev: 16384\n", "",
         "ripple: a line of order 84 needs a speed"),
        ("duration: 2 s", "duration: 0.1 ms", "a recording of 0.0001 s at 5000 Hz has 0 samples; ask for more"),
        ("  mains:", "  a b:", "'a b' cannot name a component"),
        ("components:", "parts:", "is no mixture; write synthetic: NAME"),
    ],
)  # fmt: skip
def test_a_bad_description_is_one_sentence(old: str, new: str, told: str) -> None:
    assert old in MIXTURE
    with pytest.raises(InputError) as caught:
        made(MIXTURE.replace(old, new, 1))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
