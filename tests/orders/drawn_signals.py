"""Steady torque signals of known constant speed, drawn at random: lines, hum, noise and a broad load."""

from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

WINDINGS = ((7, 12), (4, 12), (5, 12), (11, 12), (2, 9), (10, 9), (7, 6), (21, 18))  # pole pairs, slots
RATIOS = (1.0, 3.0, 4.3, 5.0, 10.0)


@dataclass(frozen=True)
class DrawnSignal:
    """A recording without an encoder, its kinematics and true motor speed [rad/s], and its lines above 20 dB."""

    recording: Recording
    kinematics: Kinematics
    speed: float
    strong_lines: int


def drawn_signal(seed, *, longest=60.0, fastest=51_200.0):
    """Return a signal of 5 s to ``longest`` [s] at 1 kHz to ``fastest`` [Hz]; equal seeds give equal signals."""
    rng = np.random.default_rng(seed)
    pole_pairs, slots = WINDINGS[rng.integers(len(WINDINGS))]
    kinematics = Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=float(rng.choice(RATIOS)))
    orders = np.unique([round(line.motor_order, 9) for line in kinematics.lines()])
    rate, seconds = _log_uniform(rng, 1000, fastest), _log_uniform(rng, 5, longest)
    mains = float(rng.choice([50.0, 60.0]))
    speed = _log_uniform(rng, 300, 4000) * pi / 30
    next_to_hum = None
    if rng.uniform() < 0.4:  # a line within 2 Hz of a harmonic of the mains
        order = float(rng.choice(orders[orders < 50]))
        beside = 2 * pi * (mains * rng.integers(1, 4) + rng.uniform(-2, 2) * rng.uniform()) / order
        if 30 < beside < 450:
            speed, next_to_hum = beside, order
    at = np.arange(int(rate * seconds)) / rate
    hertz = orders * speed / (2 * pi)
    possible = orders[(hertz < 0.45 * rate) & (hertz * seconds > 10)]
    lines = rng.choice(possible, size=min(int(rng.integers(1, 11)), possible.size), replace=False)
    if next_to_hum in possible and next_to_hum not in lines:
        lines[0] = next_to_hum
    torque = rng.uniform(-2, 2) + np.zeros(at.size)
    for order in lines:
        torque += 10 ** rng.uniform(-2.5, 0) * np.cos(order * speed * at + rng.uniform(0, 2 * pi))
    torque += 10 ** rng.uniform(-2.8, -0.3) * _noise(rng, at.size, rate)
    if rng.uniform() < 0.5:
        torque += 10 ** rng.uniform(-1.5, 0) * _load(rng, at.size, rate)
    if next_to_hum is not None or rng.uniform() < 0.2:
        torque += _hum(rng, at, mains)
    run = Run(speed=speed / (1 + rng.uniform(-0.01, 0.01)), gear_ratio=kinematics.ratio)
    channel = Channel(values=torque, quantity="torque", unit="N*m")
    recording = Recording(sample_rate=rate, channels={"torque_Nm": channel}, run=run, name=f"drawn {seed}")
    return DrawnSignal(recording, kinematics, speed, _strong(torque, lines * speed / (2 * pi) * seconds))


def _log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _noise(rng, samples, rate):
    """White, pink or band noise of standard deviation 1."""
    hertz = np.fft.rfftfreq(samples, 1 / rate)
    spectrum = np.fft.rfft(rng.normal(size=samples))
    kind = rng.choice(["white", "pink", "band"])
    if kind == "pink":
        spectrum /= np.sqrt(np.maximum(hertz, 0.5))
    if kind == "band":
        middle = _log_uniform(rng, 20, 0.4 * rate)
        spectrum *= np.where((hertz > middle / 2) & (hertz < 1.2 * middle), 1, 0.05)
    noise = np.fft.irfft(spectrum, samples)
    return noise / noise.std()


def _load(rng, samples, rate):
    """A broad load of standard deviation 1, as of particles: second-order low-pass at 2 to 60 Hz."""
    hertz = np.fft.rfftfreq(samples, 1 / rate)
    load = np.fft.irfft(np.fft.rfft(rng.normal(size=samples)) / (1 + (hertz / rng.uniform(2, 60)) ** 2), samples)
    return load / load.std()


def _hum(rng, at, mains):
    """Hum of a mains frequency that is off by some 1e-4, in half of the signals with one harmonic."""
    mains *= 1 + 3e-4 * rng.normal()
    hum = 10 ** rng.uniform(-2, 0) * np.cos(2 * pi * mains * at + rng.uniform(0, 2 * pi))
    if rng.uniform() < 0.5:
        hum += 10 ** rng.uniform(-2.5, -0.5) * np.cos(2 * pi * rng.integers(2, 7) * mains * at + rng.uniform(0, 2 * pi))
    return hum


def _strong(torque, bins):
    """The number of lines that exceed the noise floor by 20 dB."""
    power = np.abs(np.fft.rfft((torque - torque.mean()) * np.hanning(torque.size))) ** 2
    count = 0
    for at in np.round(bins).astype(int):
        floor = np.median(power[max(at - 40, 1) : at + 41]) / np.log(2)
        count += bool(power[max(at - 1, 0) : at + 2].max() > 100 * floor)
    return count
