"""How the angle strays slowly from a course: followed by the common phase of the lines that stand alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.angle.smooth_course import second_difference_bands, times_bands
from torquerig.orders.turning.sums import order_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

ACCELERATION = 1e-3  # 1/s, one sigma of the relative acceleration that a steady run may have
_TURNS_PER_HOP = 2.0  # motor turns between the blocks that follow the wander; each block is twice as long
_PARTS = 8  # of a hop
_LEADING = 300.0  # power over the noise beyond which a line has no more say
_LIVELIER = (1.0, 3.0, 10.0)  # times the acceleration: a random load may shake the speed more than the drive does
_ORDER_CAPS = (8.0, 16.0, 32.0, 90.0, np.inf)  # slow lines first: they bear the largest error of angle


def wander(
    torque: NDArray[np.float64],
    angle: NDArray[np.float64],
    orders: NDArray[np.float64],
    floor: NDArray[np.float64],
    rate: float,
    *,
    acceleration: float = ACCELERATION,
    livelier: tuple[float, ...] = _LIVELIER,
) -> tuple[NDArray[np.float64], float]:
    """Follow the slow deviation of the angle [rad], shape (samples,), by the common phase of lines that stand alone.

    The second value is the standard uncertainty of the angle between the two ends [rad].
    """
    lone = np.diff(orders, prepend=-np.inf, append=np.inf)
    alone = np.minimum(lone[:-1], lone[1:]) >= 0.9
    speed = (angle[-1] - angle[0]) / angle.size * rate
    usable = alone & (orders * abs(speed) / (2 * np.pi) < 0.4 * rate) & np.isfinite(floor)
    hop = _PARTS * max(round(_TURNS_PER_HOP * 2 * np.pi / abs(speed) * rate / _PARTS), 1)
    blocks = torque.size // hop - 1
    if blocks < 8 or not usable.any():
        return np.zeros_like(angle), 0.0
    seen = orders[usable]
    phasors = _phasors(torque, angle, seen, hop, blocks)
    noise = floor[usable]
    bend = acceleration * abs(speed) * (hop / rate) ** 2
    found = [_course(phasors, seen, noise, bend=bend * each) for each in livelier]
    course, ends = max(found, key=lambda each: each.evidence).course, found[0].ends
    centres = (np.arange(blocks) + 1) * hop
    at = np.arange(angle.size)
    first, last = (course[1] - course[0]) / hop, (course[-1] - course[-2]) / hop
    outer = first * np.minimum(at - centres[0], 0) + last * np.maximum(at - centres[-1], 0)
    return np.asarray(np.interp(at, centres, course - course.mean()) + outer), ends


@dataclass(frozen=True)
class _Followed:
    """A course of the angle [rad], shape (blocks,), how sure its ends are [rad], and the evidence for its liveliness.

    The evidence is the logarithm of the marginal likelihood, up to a constant.
    """

    course: NDArray[np.float64]
    ends: float
    evidence: float


def _course(
    phasors: NDArray[np.complex128], orders: NDArray[np.float64], noise: NDArray[np.float64], *, bend: float
) -> _Followed:
    """Follow the angle in the slow lines first, then in more and more of them."""
    followed = _Followed(np.zeros(phasors.shape[1]), 0.0, 0.0)
    for cap in _ORDER_CAPS:
        low = orders <= cap
        followed = _followed(phasors[low], orders[low], noise[low], course=followed.course, bend=bend)
    return followed


def _phasors(
    torque: NDArray[np.float64], angle: NDArray[np.float64], orders: NDArray[np.float64], hop: int, blocks: int
) -> NDArray[np.complex128]:
    """Complex amplitude of each line in each block, scaled so that white noise has the power of a spectrum bin.

    A block is two hops under a Hann window, which is taken as constant over an eighth of a hop.
    """
    part = hop // _PARTS
    edges = part * np.arange((blocks + 1) * _PARTS + 1)
    in_phase, quadrature = order_sums(torque, angle / (2 * np.pi), orders, edges, offset=torque.mean())
    pieces = (in_phase - 1j * quadrature).reshape(orders.size, blocks + 1, _PARTS)
    window = np.sin(np.pi * (np.arange(2 * _PARTS) + 0.5) / (2 * _PARTS)) ** 2
    sums = pieces[:, :-1] @ window[:_PARTS] + pieces[:, 1:] @ window[_PARTS:]
    return np.asarray(sums / np.sqrt((window**2).sum() * part))


def _followed(
    phasors: NDArray[np.complex128],
    orders: NDArray[np.float64],
    noise: NDArray[np.float64],
    *,
    course: NDArray[np.float64],
    bend: float,
) -> _Followed:
    """Take Gauss-Newton steps on the common angle, shape (blocks,), with its second difference held small."""
    from scipy.linalg import cholesky_banded, solveh_banded

    stiffness = second_difference_bands(course.size) / bend**2
    order, level = orders[:, None], noise[:, None]
    across = np.zeros(course.size)
    across[[0, -1]] = -1.0, 1.0
    ends, evidence = 0.0, -np.inf
    for _ in range(4):
        turned = phasors * np.exp(-1j * order * course)
        mean = turned.mean(axis=1, keepdims=True)
        # the noise itself has a mean of power level / blocks; only what exceeds it is a line
        strength = np.maximum(np.abs(mean) ** 2 - 2 * level / course.size, 0.0)
        # no line alone leads: the strongest may be hum that happens to stand at an order
        heard = np.maximum(level, strength / _LEADING)
        information = float((strength * order**2 / heard).sum()) * 2
        if information <= 0:
            break
        pull = (2 * order * (np.conj(mean) * turned).imag * (strength > 0) / heard).sum(axis=0)
        curvature = stiffness + information * np.array([[0.0], [0.0], [1.0]])
        course = course + solveh_banded(curvature, pull - times_bands(stiffness, course))
        # beyond the outer blocks, and over as many as are averaged, the speed may bend: once at each end
        bent = bend * max(1.0, 1 / (bend * np.sqrt(information)))
        ends = float(np.sqrt(np.vdot(across, solveh_banded(curvature, across)) + 2 * bent**2))
        fit = course.size * float(
            (np.abs((phasors * np.exp(-1j * order * course)).mean(axis=1)) ** 2 / heard[:, 0]).sum()
        )
        prior = 0.5 * float(course @ times_bands(stiffness, course)) + (course.size - 2) * np.log(bend)
        evidence = fit - prior - float(np.log(cholesky_banded(curvature)[2]).sum())
    return _Followed(course, ends, evidence)
