"""Tones so slow that some block has too few of their periods: searched in all fitted blocks of a run together.

The residual of mean torques against a model, in short parts, has a periodogram at frequencies as fine as a run is long.
Over the median of its neighbours its power is an exponential variate where there is no tone; those of all runs are
summed (Fisher's method). Source: periodogram of samples with gaps (Scargle 1982, Astrophys. J. 263).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaincc

from torquerig.inference.features.line_places import FEWEST_PERIODS, FEWEST_SWEPT
from torquerig.inference.features.line_powers import line_powers
from torquerig.inference.features.line_search import LEVEL, FoundLine
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

_PARTS = 16  # of the shortest block, whose means are compared: more than two in each period that it has too few of
_SLOWEST = 3.0  # periods in a run: slower ones are a course of the mean torque
_FINER = 4  # points of the grid for each bin of a whole run
_NEIGHBOURS = 12  # bins of a run either way, whose median is the noise of a bin
_PER_INDEPENDENT = 1.5 * 2.08  # [bins] as of the ratios of blocks: Hann window, median of exponential variates
_MOST = 3  # tones of a rig
_NEAR = 2.0  # [bins] of a run: so near to another line a tone is that line


def slow_waves(
    seen: Sequence[RunFeatures], levels: Sequence[Floats], known: Sequence[Place], orders: Sequence[float]
) -> list[FoundLine]:  # fmt: skip
    """Return the slow tones beyond ``known``, the clearest first.

    Parameters
    ----------
    seen : sequence of RunFeatures
        Of the fitted blocks.
    levels : sequence of ndarray, shape (levels,)
        What a model expects as mean torques [N m].
    known : sequence of Place
        Lines that blocks show.
    orders : sequence of float
        Of the lines of the model [1/rev], also those too slow for blocks.
    """
    runs = [(one, own) for one, own in zip(seen, levels, strict=True) if one.segments]
    longest = max((one.run.recording.duration for one, _ in runs), default=0.0)
    top = max((_highest(one) for one, _ in runs), default=0.0)
    grid = np.arange(_SLOWEST, top * longest, 1 / _FINER) / max(longest, 1e-9)
    if grid.size < _NEIGHBOURS * _FINER:
        return []
    at = [*orders, *(place.at for place in known if place.domain == "order")]
    tones = np.array([place.at for place in known if place.domain == "frequency"])
    parts = [_short_parts(*each) for each in runs]
    shown = [_shown(one, at, tones, grid) for one, _ in runs]
    found = list[FoundLine]()
    while len(found) < _MOST:
        best = _clearest(parts, shown, grid)
        if best is None:
            break
        found.append(best)
        parts = [each.without(best.place.at) for each in parts]
    return found


class _Parts(NamedTuple):
    """Means of short parts of a run: their middles [s], weights [1] and residuals times the weights [N m]."""

    duration: float
    time: Floats
    weight: Floats
    rest: Floats

    def without(self, frequency: float) -> _Parts:
        """Return the parts without the tone of a frequency [Hz], by least squares."""
        phase = 2 * pi * frequency * self.time
        wave = self.weight[:, None] * np.stack([np.cos(phase), np.sin(phase)], axis=1)
        return self._replace(rest=self.rest - wave @ np.linalg.lstsq(wave, self.rest, rcond=None)[0])

    def power(self, grid: Floats) -> Floats:
        """Return the periodogram at frequencies [Hz]."""
        return np.asarray(np.square(np.abs(np.exp(-2j * np.pi * grid[:, None] * self.time) @ self.rest)))


def _clearest(parts: Sequence[_Parts], shown: Sequence[NDArray[np.bool_]], grid: Floats) -> FoundLine | None:
    """Return the clearest tone in all runs; None where none is clear.

    The noise is that of what is left without it: it leaks over the gaps of the held-out blocks.
    """
    power = [np.where(there, each.power(grid), 0.0) for each, there in zip(parts, shown, strict=True)]
    first = float(grid[int(np.argmax(sum(one / max(float(one.mean()), 1e-300) for one in power)))])
    noises = [each.without(first).power(grid) for each in parts]
    total = np.sum([_ratio(one, noise, each.duration * (grid[1] - grid[0]))
                    for one, noise, each in zip(power, noises, parts, strict=True)], axis=0)  # fmt: skip
    count = np.sum(shown, axis=0)
    tail = np.where(count > 0, gammaincc(np.maximum(count, 1), total), 1.0)
    log_p = np.log(np.maximum(tail, 1e-300)) + log(grid.size / _FINER)
    best = int(np.argmax(total))
    if log_p[best] >= log(LEVEL):
        return None
    near = grid[best] + np.linspace(-1.0, 1.0, 2 * _NEIGHBOURS + 1) * (grid[1] - grid[0])
    sizes = [float(one[best]) for one in power]
    finer = sum(each.power(near) / max(float(np.median(noise)), 1e-300)
                for each, noise, size in zip(parts, noises, sizes, strict=True) if size > 0)  # fmt: skip
    return FoundLine(Place("frequency", float(f"{near[int(np.argmax(finer))]:.6g}")), float(log_p[best]), 0.0)


def _ratio(power: Floats, noise: Floats, step: float) -> Floats:
    """Return a power over that of the noise near it, as exponential variates; ``step`` is that of the grid [bins]."""
    reach = min(round(_NEIGHBOURS / step), noise.size - 1)
    padded = np.pad(noise, reach, mode="reflect")
    floor = np.median(np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1), axis=1) / log(2)
    at = np.arange(noise.size)
    count = step * (np.minimum(at, reach) + np.minimum(at[::-1], reach)) / _PER_INDEPENDENT
    return np.asarray(count * np.log1p(power / np.maximum(floor, 1e-300) / count))


def _shown(seen: RunFeatures, orders: Sequence[float], tones: Floats, grid: Floats) -> NDArray[np.bool_]:
    """Return at which frequencies a run may show a tone apart from other lines; orders sweep if the speed changes."""
    turning = np.array(orders) * seen.run.mean_speed / (2 * pi) if seen.run.is_steady else np.zeros(0)
    apart = np.abs(grid[:, None] - np.concatenate([tones, turning])[None]) * seen.run.recording.duration
    slowest = _SLOWEST / seen.run.recording.duration
    return np.asarray((apart >= _NEAR).all(axis=1) & (grid >= slowest) & (grid <= _highest(seen)))


def _highest(seen: RunFeatures) -> float:
    """Return up to which frequency some block of a run does not show a tone as a line [Hz]."""
    return (FEWEST_PERIODS if seen.run.is_steady else FEWEST_SWEPT) / _shortest(seen)


def _shortest(seen: RunFeatures) -> float:
    return min(block.stop - block.start for segment in seen.segments for block in segment.blocks) / seen.run.rate


def _short_parts(seen: RunFeatures, level: Floats) -> _Parts:
    """Return short parts of the fitted blocks without the lines, against the mean torques of a model [N m]."""
    time, mean, length = list[float](), list[float](), _shortest(seen) * seen.run.rate / _PARTS
    blocks = [block for segment in seen.segments for block in segment.blocks]
    for block in sorted(blocks, key=lambda one: one.start):
        rest = line_powers(seen.run, block.samples, seen.places).residual
        edges = np.linspace(0, rest.size, int(rest.size / length) + 1).astype(int)
        time += ((block.start + 0.5 * (edges[1:] + edges[:-1])) / seen.run.rate).tolist()
        mean += [float(part.mean()) for part in np.split(rest, edges[1:-1])]
    at = np.array(time)
    left = np.array(mean) - np.interp(at, seen.level_time, level)
    left = left - np.polyval(np.polyfit(at, left, 1), at)
    weight = np.square(np.sin(pi * at / seen.run.recording.duration))
    return _Parts(seen.run.recording.duration, at, weight, weight * left)
