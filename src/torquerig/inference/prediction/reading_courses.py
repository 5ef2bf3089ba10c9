"""What courses of gain and zero of a reading make of the expected features of a run."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.bands import bands
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.slow_torque import covariance
from torquerig.rig.assembly import Rig
from torquerig.sensor_stages.band_noise import BandNoise
from torquerig.sensor_stages.course import Course

Floats = NDArray[np.float64]

_NOTHING = 1e-300
_SLOWEST = 1e-3  # [1] of the first step of the grid: no noise that moves mean torques is slower


@dataclass(frozen=True)
class Courses:
    """Gain and zero of a reading over a run.

    Parameters
    ----------
    gain, zero : ndarray, shape (levels,)
        Mean of the gain [1] and of the added zero [N m] in each part.
    power : ndarray, shape (segments,)
        Mean of the square of the gain in the blocks of each segment [1].
    blocks : tuple of ndarray, shape (blocks,) each
        Logarithm of the mean of the square of the gain in each block of each segment [1].
    """

    gain: Floats
    zero: Floats
    power: Floats
    blocks: tuple[Floats, ...]


def courses(rig: Rig, seen: RunFeatures) -> Courses | None:
    """Return the courses that the stages of a rig make in a run; None without such a stage."""
    stages = [stage for stage in rig.stages() if isinstance(stage, Course)]
    if not stages:
        return None
    size = seen.run.torque.size
    low, high = (seen.parts / size).T
    gain, zero = np.ones(low.size), np.zeros(low.size)
    blocks = [np.zeros(len(segment.blocks)) for segment in seen.segments]
    for stage in stages:
        shown = stage.mean(low, high)
        zero = zero * (1 + stage.gain * shown) + seen.unit * stage.zero * shown
        gain *= 1 + stage.gain * shown
        blocks = [own + _log_square(stage, [(block.start / size, block.stop / size) for block in segment.blocks])
                  for own, segment in zip(blocks, seen.segments, strict=True)]  # fmt: skip
    power = np.array([float(np.mean(np.exp(own))) for own in blocks])
    return Courses(gain, zero, power, tuple(blocks))


def _log_square(stage: Course, blocks: list[tuple[float, float]]) -> Floats:
    """Return the logarithm of the mean of the square of a gain in each block of a run, by thirds [1]."""
    edges = np.concatenate([np.linspace(low, high, 4) for low, high in blocks]).reshape(-1, 4)
    square = np.square(1 + stage.gain * stage.mean(edges[:, :-1], edges[:, 1:]))
    return np.asarray(np.log(np.maximum(square.mean(axis=1), _NOTHING)))


def course_density(rig: Rig, seen: RunFeatures, level: Floats) -> Floats:
    """Return what the courses leave in the bands [(N m)^2/Hz], shape (segments, bands): a step has a wide spectrum.

    ``level`` are the mean torques before them [N m], shape (levels,).
    """
    total = np.zeros((len(seen.segments), seen.bands.low.size))
    if level.size:
        for stage in (stage for stage in rig.stages() if isinstance(stage, Course)):
            unit = seen.kept.get("courses", (stage.shape, stage.at), partial(_unit_density, stage, seen))
            there = float(np.interp(stage.at * seen.run.recording.duration, seen.level_time, level))
            total += (seen.unit * stage.zero + stage.gain * there) ** 2 * unit
    return total


def _unit_density(stage: Course, seen: RunFeatures) -> Floats:
    """Return the mean periodogram of a course of size 1 in the blocks of each segment [1/Hz], (segments, bands)."""
    rows, none = [], (np.zeros(0), np.zeros(0))
    for segment in seen.segments:
        parts = [stage.course(np.arange(block.start, block.stop) / seen.run.torque.size) for block in segment.blocks]
        rows.append(np.nan_to_num(bands(parts, [none] * len(parts), seen.run.rate, slowest=seen.run.slowest).power))
    return np.array(rows)


def slow_noise(rig: Rig, seen: RunFeatures) -> Floats | None:
    """Return the covariance of the levels under noise in bands [(N m)^2], shape (levels, levels); None without one."""
    stages = [stage for stage in rig.stages() if isinstance(stage, BandNoise)]
    if not stages or not seen.level.size:
        return None
    grid = np.maximum(seen.level_grid, _SLOWEST * seen.level_grid[1])
    density = np.sum([stage.density(grid, seen.run.rate) for stage in stages], axis=0)
    return covariance(seen, seen.unit**2 * density)
