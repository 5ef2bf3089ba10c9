"""Lines and bands whose power changes within a run at one speed, which no feature that is a mean of blocks shows.

The blocks of a segment have one speed, so a model expects one power. With X_b the power of a line in block b, P the
mean without the noise N, the deviation from the mean has the variance ``2 P N + N^2`` (a phasor in noise), and that of
what a right model may be wrong by. The logarithm of a band's density has that of its bins. All lines and bands of a
load may become louder together: that is a common factor of a block, and removed. Each deviation in standard deviations
z has Student's distribution. The sum of the deviances ``(nu + 1) ln(1 + z^2 / nu)`` of a line or a band over all blocks
and runs has a gamma distribution of its mean and variance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import digamma, polygamma

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.likelihood import BAND, DEGREES_OF_FREEDOM, FEWEST, LINE, deviance_moments, floor_density
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]

FEWEST_BLOCKS = 2
LINE_MAY_CHANGE, BAND_MAY_CHANGE = 0.05, 0.08  # [1] relative, of an amplitude and a density from block to block: what a
# right model may be wrong by in their size (the medians of the discrepancy) it may be wrong by in their constancy
_NOTHING = 1e-300


@dataclass(frozen=True)
class Change:
    """How much a line or a band changes.

    Parameters
    ----------
    kind : int
        ``LINE`` or ``BAND``.
    p_value : float
        Of this place alone [1].
    run, segment, row : int
        Where it changes most: the run among the tested ones, its segment, and the index of the place or band.
    size : float
        rms of the change in the reading there [N m].
    """

    kind: int
    p_value: float
    run: int
    segment: int
    row: int
    size: float


@dataclass(frozen=True)
class _Seen:
    """Deviances of one line or band in the blocks of one segment."""

    key: tuple[int, str, float]
    deviance: Floats
    size: float
    run: int
    segment: int
    row: int


def changes(runs: Sequence[tuple[RunFeatures, ExpectedRun]]) -> tuple[Change, ...]:
    """Return how much each line and band changes within runs at one speed, the least probable change first.

    ``runs`` are features with what a model expects of them.
    """
    found: dict[tuple[int, str, float], list[_Seen]] = {}
    for number, (seen, model) in enumerate(runs):
        if not seen.run.is_steady:
            continue
        for each in (*_lines(number, seen, model), *_bands(number, seen, model)):
            found.setdefault(each.key, []).append(each)
    return tuple(sorted(map(_change, found.values()), key=lambda one: one.p_value))


def _change(rows: Sequence[_Seen]) -> Change:
    from scipy.stats import gamma

    mean, variance = deviance_moments()
    total, count = sum(float(each.deviance.sum()) for each in rows), sum(each.deviance.size for each in rows)
    p_value = float(gamma.sf(total, count * mean**2 / variance, scale=variance / mean))
    most = max(rows, key=lambda each: float(each.deviance.mean()))
    largest = max(each.size for each in rows)
    return Change(most.key[0], p_value, most.run, most.segment, most.row, largest)


def _deviance(z: Floats) -> Floats:
    nu = DEGREES_OF_FREEDOM
    return np.asarray((nu + 1) * np.log1p(z**2 / nu))


def _lines(number: int, seen: RunFeatures, model: ExpectedRun) -> Iterator[_Seen]:
    floor = floor_density(seen, model)
    for index, segment in enumerate(seen.segments):
        for row in np.flatnonzero(segment.line_count >= FEWEST_BLOCKS).tolist():
            power = segment.block_lines[:, row]
            power = power[np.isfinite(power)]
            mean, noise = float(power.mean()), float(segment.line_noise_bandwidth[row] * floor[index, row])
            steady = max(mean - noise, 0.0)
            share = steady / max(mean, _NOTHING)
            own = (2 * LINE_MAY_CHANGE) ** 2 + model.line_range[index, row] ** 2
            beats = model.line_beat[index, row] * power.size
            near = np.log1p(model.near_lines[index, row] * LINE_MAY_CHANGE**2 / max(mean, _NOTHING))
            variance = (2 * steady * noise + noise**2) / max(mean**2, _NOTHING) + (own + beats) * share**2 + near**2
            z = (power / max(mean, _NOTHING) - 1) * _unbiased(power.size) / np.sqrt(max(variance, _NOTHING))
            size = float(np.sqrt(0.5 * np.mean(np.square(np.sqrt(power) - np.sqrt(mean)))))
            place = seen.places[row]
            yield _Seen((LINE, place.domain, place.at), _deviance(z), size, number, index, row)


def _bands(number: int, seen: RunFeatures, model: ExpectedRun) -> Iterator[_Seen]:
    for index, segment in enumerate(seen.segments):
        bands = segment.bands
        rows = np.flatnonzero((bands.block_count >= FEWEST).all(axis=0) & np.isfinite(bands.block_power).all(axis=0))
        if len(segment.blocks) < FEWEST_BLOCKS or not rows.size:
            continue
        count, power = bands.block_count[:, rows], bands.block_power[:, rows]
        value = np.log(np.maximum(power, _NOTHING)) + np.log(count) - digamma(count)
        modulated = model.near_bands[index, rows] * LINE_MAY_CHANGE**2 / np.maximum(power.mean(axis=0), _NOTHING)
        weight = 1 / (polygamma(1, count) + BAND_MAY_CHANGE**2 + np.log1p(modulated) ** 2)
        value = value - (weight * value).sum(axis=0) / weight.sum(axis=0)
        share = np.broadcast_to(model.load_share[index, rows], value.shape)
        louder = (weight * share * value).sum(axis=1) / np.maximum((weight * share**2).sum(axis=1), 1e-12)
        value = value - louder[:, None] * share
        z = value * np.sqrt(weight) * _unbiased(len(value))
        width = (bands.high - bands.low)[rows]
        moved = np.mean(np.square(np.sqrt(power) - np.sqrt(power.mean(axis=0))), axis=0) * width
        for at, row in enumerate(rows.tolist()):
            key = (BAND, "", round(float(bands.middle[row]), 3))
            yield _Seen(key, _deviance(z[:, at]), float(np.sqrt(moved[at])), number, index, row)


def _unbiased(blocks: int) -> float:
    """Return the factor that gives deviations from a mean of so many values the variance of the values."""
    return float(np.sqrt(blocks / (blocks - 1)))
