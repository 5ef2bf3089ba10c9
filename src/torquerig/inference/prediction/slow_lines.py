"""Slow lines in the mean torques: what a line leaves there where a block has too few of its periods to remove it.

A line of order n with the amplitude A and an unknown phase p moves the mean of part i by ``A_i Re(exp(i p) G_i)``,
``G_i`` the mean of ``exp(i n theta)`` over the part. The angle is that of the run, so all parts have one phase also
where the speed changes. The covariance of two means is then ``(1/2) A_i A_j Re(G_i conj(G_j))``, times
``exp(-(n e_ij)^2 / 2)`` where the angle between the parts is uncertain by ``e_ij``. A tone has ``2 pi f t`` for
``n theta``. The lag of the response is taken to be the same in all parts: a line that moves a mean is far below the
first mode of its rig.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Indices = NDArray[np.intp]

_POINTS = 48  # of a part
_MOST_PERIODS = 6.0  # in a part: the mean of a faster line is below 3 % of its amplitude
_DIGITS = 9  # of an order or a frequency: lines that differ later are of one
_NOTHING = 1e-4  # [1] of the mean square of a line: a smaller share moves no mean


@dataclass(frozen=True, eq=False)
class UnshownLines:
    """Lines in the segments that do not show them at a place.

    Parameters
    ----------
    at : ndarray, shape (lines,)
        Orders of the motor [1/rev], or frequencies [Hz].
    square : ndarray, shape (lines, segments)
        Mean squares [(N m)^2]; 0 in a segment that shows the line, where the mean torque is without it.
    follows : bool
        Whether ``at`` are orders.
    """

    at: Floats
    square: Floats
    follows: bool


def covariance_of_lines(seen: RunFeatures, lines: UnshownLines) -> Floats:
    """Return the covariance that lines leave in the levels of a run [(N m)^2], shape (levels, levels)."""
    rows, means, alike = seen.kept.get("slow lines", (lines.follows, lines.at.tobytes()), lambda: _moving(seen, lines))
    own = means * np.sqrt(lines.square[rows])[:, seen.level_segment]
    if alike is None:
        return _summed(own)
    total = np.zeros((own.shape[1], own.shape[1]))
    for each, known in alike:
        total += _summed(own[each]) * known
    return total


def _moving(seen: RunFeatures, lines: UnshownLines) -> tuple[Indices, Complex, list[tuple[Indices, Floats]] | None]:
    """Return the lines that move a mean, their means in each part [1], shape (lines, levels), and those of one order.

    With each order comes what the error of the angle leaves of the products, shape (levels, levels); None without one.
    """
    phase, uncertain = seen.kept.get("phases", lines.follows, lambda: _phases(seen, follows=lines.follows))
    slowest = 2 * pi * _MOST_PERIODS / max(float(np.ptp(phase, axis=1).min(initial=np.inf)), 1e-12)
    rows = np.flatnonzero(lines.at < slowest)
    orders, which = np.unique(np.round(lines.at[rows], _DIGITS), return_inverse=True)
    made = [seen.kept.get(f"mean of {order:.9g}, {lines.follows}", order, partial(_mean_of, order, phase))
            for order in orders.tolist()]  # fmt: skip
    means = np.array(made, dtype=np.complex128).reshape(orders.size, len(phase))[which]
    moves = means.any(axis=1)
    rows, means, which = rows[moves], means[moves], which[moves]
    if not uncertain.any():
        return rows, means, None
    moving = np.unique(which)
    known = seen.kept.get(
        "known phases", (lines.follows, orders[moving].tobytes()),
        lambda: np.exp(-0.5 * np.square(orders[moving, None, None] * uncertain)),
    )  # fmt: skip
    return rows, means, [(np.flatnonzero(which == row), each) for row, each in zip(moving, known, strict=True)]


def _summed(own: Complex) -> Floats:
    """Return ``Re(G_i conj(G_j))`` summed over lines, shape (levels, levels)."""
    both = np.concatenate([own.real, own.imag])
    return np.asarray(both.T @ both)


def _mean_of(order: float, phase: Floats) -> Complex:
    """Return the mean of a line in each part [1], shape (levels,); all are 0 where it moves none."""
    turned = order * np.ptp(phase, axis=1) / (2 * pi)
    mean = np.where(turned < _MOST_PERIODS, np.exp(1j * order * phase).mean(axis=1), 0.0)
    moves = 0.5 * np.square(np.abs(mean)).max(initial=0.0) > _NOTHING
    return np.asarray(mean if moves else np.zeros_like(mean))


def _phases(seen: RunFeatures, *, follows: bool) -> tuple[Floats, Floats]:
    """Return the phase of a line of the order or frequency 1 in each part [rad], shape (levels, points), and its error.

    The error is the standard deviation of the difference between two parts [rad], shape (levels, levels).
    """
    run, parts = seen.run, seen.parts
    share = (np.arange(_POINTS) + 0.5) / _POINTS
    at = parts[:, :1] + share * (parts[:, 1:] - parts[:, :1])
    if not follows:
        return np.asarray(2 * pi * at / run.rate, dtype=np.float64), np.zeros((len(parts), len(parts)))
    samples = np.arange(run.angle.size)
    travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(run.angle)))])
    path = np.interp(at.mean(axis=1), samples, travelled)
    smeared = run.smearing(slice(int(parts[:, 0].min()), int(parts[:, 1].max())))
    turned = np.asarray(np.interp(at, samples, run.angle), dtype=np.float64)
    return turned, np.asarray(smeared * np.abs(path[:, None] - path[None]))
