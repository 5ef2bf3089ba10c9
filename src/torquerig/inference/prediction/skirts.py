"""What a line loses to its sides where the angle does not follow the sway of its shaft.

A line of order n turns by ``n theta`` in phase when the shaft sways by theta about the angle that is known. Of its
power the share ``1 - exp(-n^2 Theta(d))`` lies farther than d from its frequency, ``Theta(d)`` the mean square of theta
faster than d: exact to first order for a small sway, where side bands of density ``n^2 S(f) / 2`` of the line's power
stand on either side; for a speed of white noise, whose lines are Lorentzian, right to 0.05 at the half-width and exact
far out. Source: phase noise of oscillators, any text (Rutman 1978, Proc. IEEE 66).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.measured_run import MeasuredRun
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]

_NOTHING = 1e-18  # [rad^2] a sway of a nanoradian has no skirts
_CORE = 0.75  # [bins] half the noise bandwidth of a Hann window: what a regression takes as the line
_SHARP = 2.1  # [bins] half the width of a line that was found by regression
_HALF = 0.5  # [1] of a line's power: the rest, on both sides, is lower than a line by the bins that it fills


@dataclass(frozen=True, eq=False)
class Skirts:
    """Sway of the motor's angle that is not followed.

    Parameters
    ----------
    frequency : ndarray, shape (points,)
        [Hz], ascending.
    density : ndarray, shape (points,)
        [rad^2/Hz]
    beyond : ndarray, shape (points,)
        Mean square of the sway faster than that [rad^2].
    """

    frequency: Floats
    density: Floats
    beyond: Floats

    def lost(self, order: Floats, distance: Floats) -> Floats:
        """Return which share of a line's power lies farther than ``distance`` [Hz] from it, of the broadcast shape."""
        return np.asarray(-np.expm1(-(order**2) * np.interp(distance, self.frequency, self.beyond, right=0.0)))

    def side_density(self, order: float, distance: Floats) -> Floats:
        """Return the density on one side of a line of unit power [1/Hz] at distances [Hz]."""
        sway = np.interp(distance, self.frequency, self.density, right=0.0)
        return np.asarray(0.5 * order**2 * sway * (1 - self.lost(np.array(order), distance)))


def skirts_of(twin: Twin, run: MeasuredRun, node: str) -> Skirts | None:
    """Return the sway of a node that the angle of a run does not follow; None where it follows all of it."""
    grid = twin.shafts.frequency
    density = twin.sway(node or twin.drives[0].on, followed=run.followed)
    density = density + np.where(grid <= run.followed, run.angle_noise, 0.0)
    steps = 0.5 * (density[1:] + density[:-1]) * np.diff(grid)
    beyond = np.append(np.cumsum(steps[::-1])[::-1], 0.0)
    return Skirts(grid, density, beyond) if beyond[0] > _NOTHING else None


def smears(skirts: Skirts | None, seen: RunFeatures, order: float) -> bool:
    """Return whether no segment keeps half of a line at an order of the motor where a search for lines finds it."""
    reach = _SHARP / seen.durations
    return skirts is not None and bool((skirts.lost(np.array(order), reach) > _HALF).all())


def core_of(seen: RunFeatures) -> Floats:
    """Return within which distance [Hz] the power of each place counts as its line, shape (segments, places)."""
    return seen.kept.get("core", None, lambda: _core_of(seen))


def _core_of(seen: RunFeatures) -> Floats:
    rows = []
    for segment in seen.segments:
        step = 1 / seen.duration_of(segment)
        reach = np.nan_to_num(segment.line_half_width)
        rows.append(np.where(reach <= _SHARP * step, _CORE * step, reach))
    return np.array(rows)


def density_of(skirts: Skirts, seen: RunFeatures, frequency: Floats, power: Floats, excluded: Floats) -> Floats:
    """Return the density that the skirts of lines leave in each band [(N m)^2/Hz], shape (segments, bands).

    Parameters
    ----------
    frequency, power : ndarray, shape (lines, segments)
        [Hz], and mean square [(N m)^2].
    excluded : ndarray, shape (lines, segments)
        Within this distance [Hz] of each line the bands have no bins.
    """
    key = (frequency.shape, frequency.tobytes(), excluded.tobytes())
    which = (*key, skirts.frequency.tobytes(), skirts.beyond.tobytes())
    per_power = seen.kept.get("skirts", which, lambda: _per_power(skirts, seen, frequency, excluded))
    return np.asarray(np.matmul(power.T[:, None, :], per_power)[:, 0])


def _per_power(skirts: Skirts, seen: RunFeatures, frequency: Floats, excluded: Floats) -> Floats:
    """Return the same per power of each line [1/Hz], shape (segments, lines, bands)."""
    key = (frequency.shape, frequency.tobytes(), excluded.tobytes())
    edges = seen.kept.get("edges", key, lambda: _edges_of(seen, frequency, excluded))
    outside = edges.side * (skirts.lost(edges.order, edges.apart) - skirts.lost(edges.order, edges.hole))
    return np.asarray(np.diff(outside, axis=2) * edges.per_width)


class _Edges(NamedTuple):
    """Where the edges of the bands are next to lines, arrays of shape (segments, lines, edges).

    ``apart`` is the distance of each edge [Hz], the half-width ``hole`` [Hz] of what the bands leave out at least;
    ``side`` is 1 above the line and -1 below it, and ``order`` that of the line. ``per_width`` is minus half the
    inverse width of each band [1/Hz], 0 where a hole leaves nothing of it, shape (segments, lines, bands).
    """

    order: Floats
    apart: Floats
    hole: Floats
    side: Floats
    per_width: Floats


def _edges_of(seen: RunFeatures, frequency: Floats, excluded: Floats) -> _Edges:
    turning = np.maximum(np.abs(seen.speed) / (2 * pi), 1e-12)
    order = (frequency / turning).T[..., None]
    at, hole = frequency.T[..., None], excluded.T[..., None]
    above = np.append(seen.bands.low, seen.bands.high[-1:]) - at
    apart, side = np.maximum(np.abs(above), hole), np.sign(above)
    width = np.diff(side * (apart - hole), axis=2)
    per_width = np.where(width > 0, -0.5 / np.maximum(width, 1e-12), 0.0)
    return _Edges(order, apart, hole, side, per_width)
