"""Slow drift of the shaft's angle from a given one, estimated from the common phase of isolated lines."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.angle.second_differences import second_difference_bands, times_bands
from torquerig.orders.line_sums.sums import order_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

ACCELERATION = 1e-3  # [1/s] standard deviation of the relative acceleration of a steady run
_TURNS_PER_HOP = 2.0  # motor turns between block centres; each block is twice as long
_PARTS = 8  # parts of a hop with a constant window value
_LEADING = 300.0  # [1] power over the noise beyond which a line gets no more weight
_CONSTANT = 0.01  # multiple of the acceleration that stands for a constant speed
_FACTORS = (_CONSTANT, 1.0, 3.0, 10.0)  # tried multiples: a random load may vary the speed more
_ORDER_CAPS = (8.0, 16.0, 32.0, 90.0, np.inf)  # [1/rev] low orders first: they tolerate the largest angle error


def slow_angle_drift(
    torque: NDArray[np.float64],
    angle: NDArray[np.float64],
    orders: NDArray[np.float64],
    floor: NDArray[np.float64],
    rate: float,
    *,
    acceleration: float = ACCELERATION,
    factors: tuple[float, ...] = _FACTORS,
    used: NDArray[np.bool_] | None = None,
) -> tuple[NDArray[np.float64], float]:
    """Return the slow drift [rad], shape (samples,), and the standard uncertainty of the angle between the ends [rad].

    The drift is the common phase of the isolated lines, smoothed by a penalty on its second difference. It is zero
    where a constant speed has the highest evidence.

    Parameters
    ----------
    torque, angle : ndarray, shape (samples,)
        The torque in any unit, and the angle [rad] without the drift.
    orders, floor : ndarray, shape (orders,)
        Known orders of the motor [1/rev], rising, and the noise power of a bin near each [unit^2].
    rate : float
        Samples per second [Hz].
    acceleration : float
        Standard deviation of the relative acceleration [1/s].
    factors : tuple of float
        Multiples of ``acceleration`` of which the one with the highest evidence is taken [1].
    used : ndarray, shape (orders,), bool, optional
        The lines from which the drift is estimated; by default all isolated ones.
    """
    speed = (angle[-1] - angle[0]) / angle.size * rate
    usable = usable_lines(angle, orders, floor) if used is None else used
    hop = _PARTS * max(round(_TURNS_PER_HOP * 2 * np.pi / abs(speed) * rate / _PARTS), 1)
    blocks = torque.size // hop - 1
    if blocks < 8 or not usable.any():
        return np.zeros_like(angle), 0.0
    seen = orders[usable]
    phasors = _phasors(torque, angle, seen, hop, blocks)
    noise = floor[usable]
    bend = acceleration * abs(speed) * (hop / rate) ** 2
    found = {each: _estimated(phasors, seen, noise, bend=bend * each) for each in factors}
    likeliest = max(found, key=lambda each: found[each].evidence)
    if likeliest == _CONSTANT:
        return np.zeros_like(angle), 0.0
    drift, ends = found[likeliest].drift, max(found[1.0].ends, found[likeliest].ends)
    centres = (np.arange(blocks) + 1) * hop
    at = np.arange(angle.size)
    first, last = (drift[1] - drift[0]) / hop, (drift[-1] - drift[-2]) / hop
    outer = first * np.minimum(at - centres[0], 0) + last * np.maximum(at - centres[-1], 0)
    return np.asarray(np.interp(at, centres, drift - drift.mean()) + outer), ends


def usable_lines(angle: Floats, orders: Floats, floor: Floats) -> NDArray[np.bool_]:
    """Return which lines are isolated, below 0.4 of the sample rate, and of known floor, shape (orders,)."""
    gaps = np.diff(orders, prepend=-np.inf, append=np.inf)
    isolated = np.minimum(gaps[:-1], gaps[1:]) >= 0.9
    per_sample = abs(float(angle[-1] - angle[0])) / angle.size
    return np.asarray(isolated & (orders * per_sample / (2 * np.pi) < 0.4) & np.isfinite(floor))


@dataclass(frozen=True)
class _Drift:
    """A drift [rad], shape (blocks,), the uncertainty between its ends [rad], and the evidence for its acceleration.

    The evidence is the logarithm of the marginal likelihood, up to a constant.
    """

    drift: NDArray[np.float64]
    ends: float
    evidence: float


def _estimated(
    phasors: NDArray[np.complex128], orders: NDArray[np.float64], noise: NDArray[np.float64], *, bend: float
) -> _Drift:
    """Return the drift estimated from the low orders first, then from more and more of them."""
    found = _Drift(np.zeros(phasors.shape[1]), 0.0, 0.0)
    for cap in _ORDER_CAPS:
        low = orders <= cap
        found = _refined(phasors[low], orders[low], noise[low], drift=found.drift, bend=bend)
    return found


def _phasors(
    torque: NDArray[np.float64], angle: NDArray[np.float64], orders: NDArray[np.float64], hop: int, blocks: int
) -> NDArray[np.complex128]:
    """Return the complex amplitude of each line in each block, scaled so that white noise has a spectrum bin's power.

    A block is two hops with a Hann window that is constant over each eighth of a hop.
    """
    part = hop // _PARTS
    edges = part * np.arange((blocks + 1) * _PARTS + 1)
    in_phase, quadrature = order_sums(torque, angle / (2 * np.pi), orders, edges, offset=torque.mean())
    pieces = (in_phase - 1j * quadrature).reshape(orders.size, blocks + 1, _PARTS)
    window = np.sin(np.pi * (np.arange(2 * _PARTS) + 0.5) / (2 * _PARTS)) ** 2
    sums = pieces[:, :-1] @ window[:_PARTS] + pieces[:, 1:] @ window[_PARTS:]
    return np.asarray(sums / np.sqrt((window**2).sum() * part))


def _refined(
    phasors: NDArray[np.complex128],
    orders: NDArray[np.float64],
    noise: NDArray[np.float64],
    *,
    drift: NDArray[np.float64],
    bend: float,
) -> _Drift:
    """Take Gauss-Newton steps on the drift, shape (blocks,); ``bend`` [rad] is the sd of its second difference."""
    from scipy.linalg import cholesky_banded, solveh_banded

    stiffness = second_difference_bands(drift.size) / bend**2
    order, level = orders[:, None], noise[:, None]
    across = np.zeros(drift.size)
    across[[0, -1]] = -1.0, 1.0
    ends, evidence = 0.0, -np.inf
    for _ in range(4):
        turned = phasors * np.exp(-1j * order * drift)
        mean = turned.mean(axis=1, keepdims=True)
        # the mean of noise has the power level / blocks; only power beyond it is a line
        strength = np.maximum(np.abs(mean) ** 2 - 2 * level / drift.size, 0.0)
        # the weight of one line is limited: the strongest may be hum that coincides with an order
        variance = np.maximum(level, strength / _LEADING)
        information = float((strength * order**2 / variance).sum()) * 2
        if information <= 0:
            break
        gradient = (2 * order * (np.conj(mean) * turned).imag * (strength > 0) / variance).sum(axis=0)
        curvature = stiffness + information * np.array([[0.0], [0.0], [1.0]])
        drift = drift + solveh_banded(curvature, gradient - times_bands(stiffness, drift))
        # at each end the speed may change once, within the outer blocks and over as many as are averaged
        bent = bend * max(1.0, 1 / (bend * np.sqrt(information)))
        ends = float(np.sqrt(np.vdot(across, solveh_banded(curvature, across)) + 2 * bent**2))
        fit = drift.size * float(
            (np.abs((phasors * np.exp(-1j * order * drift)).mean(axis=1)) ** 2 / variance[:, 0]).sum()
        )
        prior = 0.5 * float(drift @ times_bands(stiffness, drift)) + (drift.size - 2) * np.log(bend)
        evidence = fit - prior - float(np.log(cholesky_banded(curvature)[2]).sum())
    return _Drift(drift, ends, evidence)
