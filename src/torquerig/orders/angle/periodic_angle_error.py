"""Deviations of a shaft's angle that repeat with each turn, estimated from the side lines of the torque's lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.line_sums.sums import order_sums, put_in

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Phasors = NDArray[np.complex128]

SLOW = 2.05  # [1/rev] highest order whose torque moves the motor's angle noticeably
_SLOWEST_CARRIER = 2.5  # [1/rev] lowest order of a carrier: slower lines move the shaft themselves
_APART = 0.03  # [1/rev] a side line nearer than this to a known line is not used
_CLEAR = 30.0  # [1] power of a carrier over the noise floor, at least
_ROUNDS = 3  # iterations: a better angle makes sharper carriers
_REWEIGHED = 6  # iterations of the Cauchy weights, which reject side lines that are separate lines


def periodic_angle_error(torque: Floats, angle: Floats, orders: Floats, floor: Floats) -> Floats:
    """Return the periodic correction [rad], shape (samples,), to be added to ``angle``.

    A torque at order m moves the shaft by ``Re(c exp(i m theta))``. To first order, each line ``A`` of order n then has
    the side lines ``i n A c / 2`` at n + m and ``i n A conj(c) / 2`` at n - m (narrow-band phase modulation). A
    least-squares fit over many lines finds the common c. Amplitude modulation and separate lines do not have this
    pattern and get little weight (Cauchy weights).

    Parameters
    ----------
    torque, angle : ndarray, shape (samples,)
        The torque in any unit, and the angle [rad], correct but for deviations that repeat within a few turns.
    orders, floor : ndarray, shape (orders,)
        Known orders of the motor [1/rev], and the noise power of a bin near each [unit^2].

    Notes
    -----
    Valid while ``n |c|`` is below about 1. Deviations at other orders than the slow known ones are not corrected.
    """
    slow = orders[orders < SLOW]
    if not slow.size:
        return np.zeros_like(angle)
    window = np.hanning(torque.size)
    windowed = (torque - torque.mean()) * window
    noise = floor * float((window**2).sum())
    correction = np.zeros_like(angle)
    for _ in range(_ROUNDS):
        found = _fitted(windowed, angle + correction, orders, noise, slow)
        if found is None:
            break
        sizes = np.repeat(np.stack([found.real, -found.imag])[:, :, None], 2, axis=2)
        put_in(correction, (angle + correction) / (2 * np.pi), slow, np.array([0, angle.size]), sizes, gain=1.0)
    return np.asarray(correction)


def _fitted(windowed: Floats, angle: Floats, orders: Floats, noise: Floats, slow: Floats) -> Phasors | None:
    """Return the complex amplitude of the angle at each slow order [rad], or None where there are too few carriers."""
    lines = _phasors(windowed, angle, orders)
    carries = (np.abs(lines) ** 2 > _CLEAR * noise) & (orders > _SLOWEST_CARRIER) & np.isfinite(noise)
    if not carries.any():
        return None
    carriers, sizes = orders[carries], lines[carries]
    at = np.unique(np.round((carriers[:, None, None] + slow[:, None] * np.array([1.0, -1.0])).ravel(), 6))
    at = at[(at > 0) & (np.abs(at[:, None] - orders).min(axis=1) > _APART)]
    if at.size < 2 * slow.size:
        return None
    side = _phasors(windowed, angle, at)
    level = np.interp(at, orders[np.isfinite(noise)], noise[np.isfinite(noise)])
    design = np.zeros((at.size, 2, slow.size, 2))  # side line (re, im) by slow order (re, im)
    for column, order in enumerate(slow.tolist()):
        for sign in (1.0, -1.0):
            where = np.round(carriers + sign * order, 6)
            row = np.searchsorted(at, where)
            hit = (row < at.size) & (at[np.minimum(row, at.size - 1)] == where)
            gain = 0.5j * carriers[hit] * sizes[hit]
            np.add.at(design[:, :, column, 0], row[hit], np.stack([gain.real, gain.imag], axis=1))
            turned = 1j * sign * gain
            np.add.at(design[:, :, column, 1], row[hit], np.stack([turned.real, turned.imag], axis=1))
    rows = (design / np.sqrt(level)[:, None, None, None]).reshape(2 * at.size, 2 * slow.size)
    seen = (np.stack([side.real, side.imag], axis=1) / np.sqrt(level)[:, None]).ravel()
    weight, solved = np.ones(at.size), np.zeros(2 * slow.size)
    for _ in range(_REWEIGHED):
        each = np.repeat(np.sqrt(weight), 2)
        solved = np.linalg.lstsq(rows * each[:, None], seen * each, rcond=1e-8)[0]
        residual = ((seen - rows @ solved) ** 2).reshape(-1, 2).sum(axis=1)
        weight = 1 / (1 + residual / max(2 * float(np.median(residual)), 2.0))
    return np.asarray(solved.reshape(-1, 2) @ np.array([1.0, 1j]))


def _phasors(windowed: Floats, angle: Floats, orders: Floats) -> Phasors:
    sums = order_sums(windowed, angle / (2 * np.pi), orders, np.array([0, windowed.size]))[:, :, 0]
    return np.asarray(sums[0] - 1j * sums[1])
