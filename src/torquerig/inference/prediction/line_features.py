"""What the lines of a rig leave in the features of a run: power at places, density in bands, slow waves in levels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.kept_twin import kept_skirts
from torquerig.inference.prediction.line_routes import LineRoutes, line_routes
from torquerig.inference.prediction.rig_lines import SHIFT, RigLines, beat_variance, lines_key, rig_lines
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
    return seen.kept.get("lines", lines_key(twin, seen), lambda: _line_features(twin, seen))


def _line_features(twin: Twin, seen: RunFeatures) -> LineFeatures:
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
            own, hole = (
                np.where(at, one[row, np.maximum(routes.place, 0)], 0.0) if places else np.zeros(at.shape)
                for one in (core, excluded)
            )
            kept = 1 - skirts.lost(each.frequency / turning, own)
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
    low, high, step = seen.bands.low, seen.bands.high, 1 / seen.durations
    slow, fast = ((frequency * swept[:, column]).T[..., None] for column in (0, 1))
    inside = np.zeros((*slow.shape[:2], low.size))
    for row, width in enumerate((_WINDOW * step).tolist()):
        cuts, free = seen.kept.get("free of lines", row, partial(free_of_lines, seen, row))
        share = np.diff(swept_below(cuts, slow=slow[row], fast=fast[row], width=np.array(width)), axis=1)
        inside[row] = share @ free
    step = step[:, None, None]
    bins = np.maximum(np.maximum(low - fast, slow - high) / step, _FIRST_LOBE)
    lobes = np.where(bins > _FIRST_LOBE, _LOBE * (_FIRST_LOBE / bins) ** 6, 0.0)
    return np.asarray(np.maximum(inside, lobes / (fast - slow + _WINDOW * step)))


def free_of_lines(seen: RunFeatures, segment: int) -> tuple[Floats, Floats]:
    """Return frequencies [Hz] that cut the bands where lines with a place begin and end in a segment, and what counts.

    The bins of such lines are in no density. The second array, shape (cuts - 1, bands), is the inverse of the width
    [1/Hz] that is left of a band for the parts in it that are left, and 0 for the others.
    """
    edges = np.append(seen.bands.low, seen.bands.high[-1:])
    shown = seen.lines.count[segment] > 0
    follows = np.array([place.domain == "order" for place in seen.places], dtype=bool)[shown]
    at, reach = seen.line_frequency[segment, shown], seen.line_excluded[segment, shown]
    begin, end = (at * np.where(follows, seen.swept[segment, column], 1.0) for column in (0, 1))
    begin, end = begin - reach, end + reach
    cuts = np.unique(np.clip(np.concatenate([edges, begin, end]), edges[0], edges[-1]))
    middle, length = 0.5 * (cuts[1:] + cuts[:-1]), np.diff(cuts)
    left = ~((middle[:, None] > begin) & (middle[:, None] < end)).any(axis=1)
    band = np.searchsorted(edges, middle) - 1
    none = np.bincount(band, weights=length * left, minlength=edges.size - 1) < 1e-9 * np.diff(edges)
    left = left | none[band]
    width = np.bincount(band, weights=length * left, minlength=edges.size - 1)
    return cuts, np.where((band[:, None] == np.arange(edges.size - 1)) & left[:, None], 1 / width, 0.0)


def swept_below(frequency: Floats, *, slow: Floats, fast: Floats, width: Floats) -> Floats:
    """Return the share of a line's power below a frequency [1], of the broadcast shape, under a Hann window.

    The line sweeps evenly from ``slow`` to ``fast`` [Hz] in a block. What it shows at the share u of its way has the
    weight of the squared window, ``8/3 sin(pi u)^4``: at the ends of a sweep there is hardly anything. The window
    widens each moment to ``width`` [Hz], taken as even. Source: stationary phase (Papoulis 1977, Signal Analysis, 8-2).
    """
    reach = np.maximum(fast - slow, 1e-6 * width)
    upper, lower = (_summed_share((frequency + way * width - slow) / reach) for way in (0.5, -0.5))
    return np.asarray((upper - lower) * reach / width)


def _summed_share(way: Floats) -> Floats:
    """Return the integral over u of the integral of ``8/3 sin(pi u)^4`` from 0 on, u up to ``way``."""
    u = np.clip(way, 0.0, 1.0)
    inside = 0.5 * u**2 + (np.cos(2 * pi * u) - 1) / (3 * pi**2) - (np.cos(4 * pi * u) - 1) / (48 * pi**2)
    return np.asarray(inside + np.maximum(way - 1, 0.0))
