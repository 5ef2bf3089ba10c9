"""Whether an effect counts: the log-likelihood ratio of a recording with it, against the rig without it.

Both models are learned from recordings of the rig program with load, speed wander and noise drawn anew: power of the
periodogram (Whittle) and mean of stretches. The recording that is judged is none of them, so the ratio is one of
held-out data. An effect that changes single samples is judged by these samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from proof.fleet.effect import Effect, Motion
from proof.fleet.recording import Recorded, measure, move
from proof.fleet.rig import FleetRig

Floats = NDArray[np.float64]
COUNTS_FROM = 15.0  # nats
REDRAWN = 3  # recordings from which each model is learned
STRETCHES = 8  # of a run, for levels and for periodograms
HANN_BINS = 1.5  # noise bandwidth of a Hann window [bins]
LOWEST_BIN = 3  # below it the means of the stretches count
SMOOTHED = 5  # bins of a periodogram of one stretch, where the speed changes


@dataclass(frozen=True)
class Shown:
    """How well an effect shows: log-likelihood ratio [nats], and its size at the sensor, rms of the change [N m]."""

    nats: float
    size: float

    @property
    def counts(self) -> bool:
        """Whether it counts."""
        return self.nats >= COUNTS_FROM


def shown(rig: FleetRig, effect: Effect, *, redrawn: int = REDRAWN) -> Shown:
    """Return how well an effect of a rig shows in all its runs, next to the rig's other effects."""
    others = tuple(one for one in rig.effects if one is not effect)
    per_volt = float(rig.design.parts[rig.design.sensor]["sensitivity"].split()[0])
    nats, squares = 0.0, []
    for number, run in enumerate(rig.runs):
        moved: dict[int, Motion] = {}

        recorded = partial(_recorded, rig, number, moved, moves=effect.mechanical)
        first, second = recorded(rig.effects, 0), recorded(others, 0)
        judged, without = first.volts, second.volts
        squares.append(np.mean((judged - without) ** 2))
        if rig.design.angle == "encoder" and not effect.mechanical:
            nats += angles(first.motor_angle, second.motor_angle, rig.design.angle_counts)
        if np.array_equal(judged, without):
            continue
        models = [[recorded(some, 1 + i).volts for i in range(redrawn)] for some in (others, rig.effects)]
        steady = run.profile == "steady"
        nats += whittle(judged, *models, steady=steady) + levels(judged, *models)
        if effect.in_samples:
            nats += samples(judged, without)
    return Shown(float(nats), float(np.sqrt(np.mean(squares))) / per_volt)


def _recorded(
    rig: FleetRig, number: int, moved: dict[int, Motion], effects: tuple[Effect, ...], redraw: int, *, moves: bool
) -> Recorded:
    """Return a recording with some effects; what only the measuring chain changes is integrated once."""
    run = rig.runs[number]
    if moves or redraw not in moved:
        moved[redraw] = move(rig, run, number, effects, redraw=redraw)
    return measure(rig, run, number, moved[redraw], effects, redraw=redraw)


def whittle(judged: Floats, without: Sequence[Floats], with_it: Sequence[Floats], *, steady: bool) -> float:
    """Return the log-likelihood ratio [nats] of a recording's periodogram, from those of both models."""
    first, averages = _power(judged, steady=steady)
    power0, power1 = (np.mean([_power(one, steady=steady)[0] for one in some], axis=0) for some in (without, with_it))
    cells = first * (1.0 / power0 - 1.0 / power1) - np.log(power1 / power0)
    return float(np.sum(cells) * averages)


def levels(judged: Floats, without: Sequence[Floats], with_it: Sequence[Floats]) -> float:
    """Return the log-likelihood ratio [nats] of the means of a run's stretches (Gaussian)."""
    mean, means0, means1 = _means(judged), _means(np.array(without)), _means(np.array(with_it))
    residuals = np.concatenate([means0 - means0.mean(axis=0), means1 - means1.mean(axis=0)])
    count = len(without)
    variance = np.sum(residuals**2) / (2 * (count - 1) * STRETCHES) * (1.0 + 1.0 / count)
    floor = np.var(np.diff(judged)) / judged.size * STRETCHES
    gain = (mean - means0.mean(axis=0)) ** 2 - (mean - means1.mean(axis=0)) ** 2
    return float(np.sum(gain) / (2.0 * (variance + floor)))


def samples(judged: Floats, without: Floats) -> float:
    """Return the log-likelihood ratio [nats] of changed samples, against their prediction from the sample before."""
    innovation = np.var(np.diff(without)) / 2.0
    return float(np.sum((judged - without) ** 2) / (2.0 * innovation))


def angles(judged: Floats, without: Floats, counts: int) -> float:
    """Return the log-likelihood ratio [nats] of a changed reading of the angle, against its resolution."""
    resolution = (2.0 * np.pi / counts) ** 2 / 12.0
    return float(np.sum((judged - without) ** 2) / (2.0 * resolution))


def _means(volts: Floats) -> Floats:
    usable = volts.shape[-1] // STRETCHES * STRETCHES
    return np.asarray(volts[..., :usable].reshape(*volts.shape[:-1], STRETCHES, -1).mean(axis=-1))


def _power(volts: Floats, *, steady: bool) -> tuple[Floats, float]:
    """Return the powers of the cells and the independent values behind each cell."""
    length = volts.size // STRETCHES
    step = length // 2 if steady else length
    starts = np.arange(0, volts.size - length + 1, step)
    window = np.hanning(length)
    stretches = np.array([volts[start : start + length] for start in starts])
    power = np.abs(np.fft.rfft((stretches - stretches.mean(axis=1, keepdims=True)) * window)) ** 2
    power = power[:, LOWEST_BIN:-1]
    if steady:
        return power.mean(axis=0), len(starts) / 1.056 / HANN_BINS  # 1.056: Hann windows that overlap by half
    usable = power.shape[1] // SMOOTHED * SMOOTHED
    return power[:, :usable].reshape(len(starts), -1, SMOOTHED).mean(axis=2), SMOOTHED / HANN_BINS
