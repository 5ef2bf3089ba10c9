"""What drives a run over time: the set-point, the load's resistance, turbulence, and pushes of effects."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from proof.fleet.design import Design
from proof.fleet.laws import FleetLaws
from proof.fleet.plans import Run

Floats = NDArray[np.float64]
COARSE = 250.0  # [Hz] at which slow variations are drawn


@dataclass(frozen=True)
class Courses:
    """Inputs of the train over all frames, settling included; see `kernel.run_train`."""

    set_point: Floats
    resist: Floats
    swirl: Floats
    push_motor: Floats
    push_load: Floats
    soft: Floats

    def arrays(self) -> tuple[Floats, ...]:
        """Return the arrays in the order of the kernel."""
        return (self.set_point, self.resist, self.swirl, self.push_motor, self.push_load, self.soft)

    def with_pushes(self, pushes: dict[str, Floats]) -> Courses:
        """Return the courses with what effects add to them; ``soft`` is a factor."""
        changed = {
            name: getattr(self, name) * value if name == "soft" else getattr(self, name) + value
            for name, value in pushes.items()
        }
        return replace(self, **changed)


def courses_of(
    design: Design, truth: dict[str, Any], laws: FleetLaws, run: Run, *, frame_rate: float, settling: float,
    seed: list[int], speed_error: float, wander: float,
) -> Courses:  # fmt: skip
    """Draw the inputs of one run; the same seed draws the same."""
    frames = round((settling + run.duration) * frame_rate)
    time = np.arange(frames) / frame_rate - settling
    speed_rng, load_rng = (np.random.default_rng([*seed, stream]) for stream in (1, 2))
    set_point = _set_point(run, time, speed_rng, error=speed_error, wander=wander) * np.sign(design.ratio)
    nothing = np.zeros(frames)
    resist, swirl = nothing, nothing
    if "load" in truth:
        resist = _resistance(truth["load"], laws, run, time=time, rng=load_rng, frame_rate=frame_rate)
    if "flow" in truth:
        flow = truth["flow"]
        cutoff = float(flow["turbulence_cutoff"].split()[0])
        swirl = flow["turbulence"] * _one_pole(load_rng, time, cutoff) * _unsteady(laws, time, run)
    return Courses(set_point, resist, swirl, nothing, nothing, np.ones(frames))


def _set_point(run: Run, time: Floats, rng: np.random.Generator, *, error: float, wander: float) -> Floats:
    top = run.speed * (1.0 + error)
    if run.profile == "ramp":
        return np.asarray(top * np.clip(0.1 + 0.9 * time / (0.9 * run.duration), 0.1, 1.0))
    if run.profile == "reversal":
        return np.asarray(top * np.sin(4.0 * np.pi * time / run.duration))
    return np.asarray(top * (1.0 + wander * _slow(rng, time, 0.3, 2.0)))


def _resistance(
    load: dict[str, Any], laws: FleetLaws, run: Run, *, time: Floats, rng: np.random.Generator, frame_rate: float
) -> Floats:
    levels = load["mean_by_occupancy_percent"]
    mean = float(np.interp(run.occupancy, list(levels), list(levels.values())))
    slow = load["slow_rms"] * _slow(rng, time, float(load["slow_cutoff"].split()[0]), laws.slow_steepness)
    course = slow * _unsteady(laws, time, run)
    if load["hit_rms"]:
        rate = float(load["hit_rate"].split()[0]) * (0.3 + run.occupancy / 10.0)
        course = course + load["hit_rms"] * _hits(rng, time, rate, load=load, laws=laws, frame_rate=frame_rate)
    return np.asarray(np.maximum(mean * (1.0 + course), 0.0))


def _unsteady(laws: FleetLaws, time: Floats, run: Run) -> Floats:
    """Return the factor by which the load's variation changes over a run, with a mean square of about one."""
    return np.asarray(1.0 + laws.unsteadiness * np.sin(2.0 * np.pi * 0.8 * time / run.duration + 0.7))


def _slow(rng: np.random.Generator, time: Floats, cutoff: float, steepness: float) -> Floats:
    """Return noise of unit rms whose amplitude falls with this power of the frequency above a cut-off at -3 dB (n,)."""
    span = time[-1] - time[0]
    points = int(span * COARSE) + 1024
    ratio = np.fft.rfftfreq(points, 1.0 / COARSE) / cutoff
    gain = 1.0 / np.sqrt(1.0 + ratio ** (2.0 * steepness))
    spectrum = np.fft.rfft(rng.standard_normal(points)) * gain
    course = np.fft.irfft(spectrum, points) / np.sqrt(np.mean(np.concatenate([gain, gain[1:-1]]) ** 2))
    return np.asarray(np.interp(time - time[0], np.arange(points) / COARSE, course))


def _one_pole(rng: np.random.Generator, time: Floats, cutoff: float) -> Floats:
    """Return noise of unit rms through a first-order low-pass (n,)."""
    from scipy.signal import lfilter

    rate = max(COARSE, 40.0 * cutoff)
    points = int((time[-1] - time[0]) * rate) + 2 + int(3.0 * rate / cutoff)
    keep = np.exp(-2.0 * np.pi * cutoff / rate)
    course = lfilter([np.sqrt(1.0 - keep**2)], [1.0, -keep], rng.standard_normal(points))[int(3.0 * rate / cutoff) :]
    return np.asarray(np.interp(time - time[0], np.arange(course.size) / rate, course))


def _hits(
    rng: np.random.Generator, time: Floats, rate: float, *, load: dict[str, Any], laws: FleetLaws, frame_rate: float
) -> Floats:
    """Return hits of unit rms without their mean (n,): random instants, gamma sizes, pulses of the law's course."""
    decay = float(load["hit_decay"].split()[0]) * 1e-3
    pulse = _pulse(laws.pulse, decay, frame_rate)
    count = rng.poisson(rate * (time.size / frame_rate))
    train = np.zeros(time.size)
    np.add.at(train, rng.integers(0, time.size, count), rng.gamma(1.5, 1.0 / 1.5, count))
    from scipy.signal import oaconvolve

    course = oaconvolve(train, pulse)[: time.size]
    mean = rate * pulse.sum() / frame_rate
    return np.asarray((course - mean) / np.sqrt(rate * (1.0 + 1.0 / 1.5) * np.sum(pulse**2) / frame_rate))


def _pulse(kind: str, decay: float, frame_rate: float) -> Floats:
    """Return one hit of unit height (m,) with the impulse of an exponential decay."""
    t = np.arange(1, max(int(8.0 * decay * frame_rate), 4)) / frame_rate
    if kind == "triangle":
        return np.asarray(np.maximum(1.0 - t / (2.0 * decay), 0.0))
    if kind == "half_sine":
        return np.asarray(np.where(t < 0.5 * np.pi * decay, np.sin(2.0 * t / decay), 0.0))
    rise = 0.15 * decay
    return np.asarray(np.exp(-t / decay) - np.exp(-t / rise))
