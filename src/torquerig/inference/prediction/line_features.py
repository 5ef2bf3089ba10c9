"""What the lines of a rig leave in the features of a run: power at places, density in bands, slow waves in levels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import spence

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.kept_twin import kept_skirts
from torquerig.inference.prediction.line_routes import LineRoutes, line_routes
from torquerig.inference.prediction.rig_lines import SHIFT, RigLines, rig_lines
from torquerig.inference.prediction.skirts import core_of, density_of
from torquerig.inference.prediction.slow_lines import UnshownLines
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]

_WINDOW = 1.5  # [bins] noise bandwidth of a Hann window
_FIRST_LOBE, _LOBE = 2.4, 10**-3.15  # [bins], [1] where its first side lobe is, and its power
_NOTHING = 1e-300  # keeps logarithms finite


@dataclass(frozen=True, eq=False)
class LineFeatures:
    """Shares of the lines in the features.

    Parameters
    ----------
    power, slope, varied, beat : ndarray, shape (segments, places)
        As ``line_power``, ``line_slope``, ``line_range`` and ``line_beat`` of ``ExpectedRun``.
    density : ndarray, shape (segments, bands)
        Of lines without a place, and of the skirts of all [(N m)^2/Hz].
    unshown : tuple of UnshownLines
        Lines in the segments that have no place for them.
    """

    power: Floats
    slope: Floats
    varied: Floats
    beat: Floats
    density: Floats
    unshown: tuple[UnshownLines, ...]


def line_features(twin: Twin, seen: RunFeatures) -> LineFeatures:
    """Return where the lines of a rig show in the features of a run."""
    count, places = len(seen.segments), len(seen.places)
    density, unshown, shown = np.zeros((count, seen.bands.low.size)), list[UnshownLines](), list[_Shown]()
    turning = np.maximum(np.abs(seen.speed) / (2 * pi), 1e-12)
    core, excluded = core_of(seen), seen.line_excluded
    for each in rig_lines(twin, seen):
        routes = line_routes(seen, each.frequency)
        row = np.broadcast_to(np.arange(count), each.frequency.shape)
        at, inside = routes.place >= 0, routes.band >= 0
        kept, share = np.ones(each.frequency.shape), routes.share
        if places and np.any(each.half_width):  # wider than a bin, it shows as much at a place next to its middle
            apart = np.abs(each.frequency - seen.line_frequency[row, np.maximum(routes.place, 0)])
            share = np.maximum(share, 1 / (1 + np.square(apart / np.maximum(each.half_width, 1e-9))))
        skirts = kept_skirts(twin, seen, each.node) if each.follows and count else None
        if skirts is not None:
            there = row, np.maximum(routes.place, 0)
            kept = 1 - skirts.lost(each.frequency / turning, np.where(at, core[there], 0.0))
            hole = np.where(at, excluded[there], 0.0)
            density += density_of(skirts, seen, each.frequency, np.where(at | inside, 0.5 * each.square, 0.0), hole)
        if at.any():
            shown.append(_shown(each, routes, at, row[at] * places + routes.place[at], share * kept))
        without = np.where(inside, 0.5 * kept * each.square, 0.0)
        swept = seen.swept if each.follows else np.ones((count, 2))
        density += _swept_density(seen, each.frequency, without, swept)
        if each.about is not None:
            density += np.einsum("ls,lsb->sb", np.where(at, 0.5 * each.square, 0.0), each.about)
        if count and not at.all():
            which, square = (slice(None), each.square) if each.each is None else each.each
            orders = (each.frequency / (turning if each.follows else 1.0))[which, 0]
            unshown.append(UnshownLines(orders, np.where(at[which], 0.0, 0.5 * square), each.follows))
    return LineFeatures(*_at_places(shown, seen), density, tuple(unshown))


class _Shown(NamedTuple):
    """What lines leave at the places of their segments, one entry for each, shape (entries,).

    ``place`` counts the places of all segments; ``power``, ``shifted``, ``varied``, ``beats`` and ``noisy`` are shares
    of the squares of ``RigLines``, ``aligned`` those that keep their phase to a line at the place.
    """

    place: NDArray[np.intp]
    power: Floats
    shifted: Floats
    varied: Floats
    beats: Floats
    aligned: Floats
    noisy: Floats


def _shown(
    each: RigLines, routes: LineRoutes, at: NDArray[np.bool_], place: NDArray[np.intp], share: Floats
) -> _Shown:  # fmt: skip
    own = share[at]
    power = own * each.square[at]
    beats = each.beats * power
    scatter = np.broadcast_to(each.scatter, at.shape)[at]
    return _Shown(
        place, power, own * each.shifted[at], power * each.varied[at], beats, beats * routes.aligned[at],
        power * scatter,
    )  # fmt: skip


def _at_places(shown: Sequence[_Shown], seen: RunFeatures) -> tuple[Floats, Floats, Floats, Floats]:
    """Return power, slope, range and beat at the places, shape (segments, places) each."""
    count, places = len(seen.segments), len(seen.places)
    if not shown:
        none = np.zeros((count, places))
        return none, none.copy(), none.copy(), none.copy()
    together = _Shown(*(np.concatenate(parts) for parts in zip(*shown, strict=True)))
    power, moved, varied, beating, aligned, noisy = np.zeros((6, count, places))
    for total, values in zip((power, moved, varied, beating, aligned, noisy), together[1:], strict=True):
        total[:] = np.bincount(together.place, values, minlength=count * places).reshape(count, places)
    strongest = np.zeros((count, places))
    np.maximum.at(strongest.reshape(-1), together.place, together.beats)
    slope = np.log(np.maximum(moved, _NOTHING) / np.maximum(power, _NOTHING)) / SHIFT * (power > 0)
    beat = beat_variance(
        beating, strongest, np.where(aligned - strongest > 0.5 * (beating - strongest), 1.0, seen.lines.count)
    )
    beat = beat + noisy / np.maximum(power, _NOTHING) / np.maximum(seen.lines.count, 1.0)
    return power, slope, varied / np.maximum(power, _NOTHING), beat


def beat_variance(power: Floats, strongest: Floats, count: Floats) -> Floats:
    """Return the variance of the logarithm of the power of lines that share a place, their phases unknown.

    Two phasors of random phase, r the ratio of their powers: ``var ln|1 + sqrt(r) exp(i phi)|^2 = 2 Li2(r)``, Li2 the
    dilogarithm, by the Fourier series ``2 sum (-1)^(k+1) r^(k/2) cos(k phi) / k``. All but the strongest line count as
    the second phasor. In each of ``count`` blocks the phase is another one; of lines of one frequency it is the same in
    all, so that these count as one block.
    """
    ratio = np.clip((power - strongest) / np.maximum(strongest, _NOTHING), 0.0, 1.0)
    return np.asarray(2 * spence(1 - ratio) / np.maximum(count, 1.0))


def _swept_density(seen: RunFeatures, frequency: Floats, power: Floats, swept: Floats) -> Floats:
    """Return the density of lines in the bands over which they sweep [(N m)^2/Hz], shape (segments, bands).

    ``power`` are mean squares [(N m)^2], ``swept`` the slowest and fastest speed of each segment over its mean [1].
    """
    key = (frequency.shape, frequency.tobytes(), swept.tobytes())
    per_power = seen.kept.get("swept", key, lambda: _per_power(seen, frequency, swept))
    return np.asarray(np.matmul(power.T[:, None, :], per_power)[:, 0])


def _per_power(seen: RunFeatures, frequency: Floats, swept: Floats) -> Floats:
    """Return the same per power of each line [1/Hz], shape (segments, lines, bands).

    A Hann window widens a line by its noise bandwidth and leaves side lobes that fall with the sixth power of the
    distance.
    """
    low, high = seen.bands.low, seen.bands.high
    step = 1 / seen.durations[:, None, None]
    slow, fast = ((frequency * swept[:, column]).T[..., None] for column in (0, 1))
    near, far = slow - 0.5 * _WINDOW * step, fast + 0.5 * _WINDOW * step
    inside = np.clip(np.minimum(far, high) - np.maximum(near, low), 0.0, None) / (high - low)
    bins = np.maximum(np.maximum(low - fast, slow - high) / step, _FIRST_LOBE)
    lobes = np.where(bins > _FIRST_LOBE, _LOBE * (_FIRST_LOBE / bins) ** 6, 0.0)
    return np.asarray(np.maximum(inside, lobes) / (far - near))
