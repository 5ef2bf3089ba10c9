"""The same arrays as mass, damping and stiffness matrices, gaps closed and losses left out; more is in ``twin/``."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered


@dataclass(frozen=True)
class Matrices:
    """``M theta'' + C theta' + K theta = torque``; shapes (nodes, nodes); SI units.

    Gaps are taken as closed, losses of the gears as none, dry friction and loads as constant; viscous friction stays
    (the forward one).
    """

    nodes: tuple[str, ...]
    mass: NDArray[np.float64]
    damping: NDArray[np.float64]
    stiffness: NDArray[np.float64]

    def undamped_frequencies(self) -> NDArray[np.float64]:
        """Return the natural frequencies without damping [Hz], ascending, rigid-body modes as 0."""
        from scipy.linalg import eigh

        squares = eigh(self.stiffness, self.mass, eigvals_only=True)
        scale = squares[-1] if squares.size else 1.0
        return np.asarray(np.sqrt(np.where(squares > 1e-10 * scale, squares, 0.0)) / (2 * np.pi))

    def state_matrix(self) -> NDArray[np.float64]:
        """Return A of ``x' = A x`` with x = (angles, speeds), shape (2 nodes, 2 nodes)."""
        n = len(self.nodes)
        inverse = np.linalg.inv(self.mass)
        return np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ self.stiffness, -inverse @ self.damping]])


def matrices(lowered: Lowered, *, stiffest: bool = False) -> Matrices:
    """Return M, C and K of a lowered rig; ``stiffest`` with bristles stuck and varying springs at their highest."""
    n = len(lowered.nodes)
    mass = np.diag(lowered.inertia)
    damping, stiffness = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1))
    springs = lowered.springs
    highest = springs.stiffness * (1 + lowered.swings()) if stiffest else springs.stiffness
    for a, b, k, c, r in zip(springs.a, springs.b, highest, springs.damping, springs.inverse_ratio, strict=True):
        twist = np.zeros(n + 1)
        twist[a] += r
        twist[b] -= 1.0
        stiffness += k * np.outer(twist, twist)
        damping += c * np.outer(twist, twist)
    frictions = lowered.frictions
    for on, against, viscous in zip(frictions.on, frictions.against, frictions.viscous, strict=True):
        slide = np.zeros(n + 1)
        slide[on] += 1.0
        slide[against] -= 1.0
        damping += viscous * np.outer(slide, slide)
    for on, against, k, c, viscous in zip(*lowered.bristles[:4], lowered.bristles.viscous, strict=True):
        slide = np.zeros(n + 1)
        slide[on] += 1.0
        slide[against] -= 1.0
        damping += (viscous + c if stiffest else viscous) * np.outer(slide, slide)
        stiffness += (k if stiffest else 0.0) * np.outer(slide, slide)
    return Matrices(lowered.nodes, mass, damping[:n, :n], stiffness[:n, :n])


def spring_response(
    lowered: Lowered, spring: str, frequencies: NDArray[np.float64], *, speed_loop: bool = False
) -> dict[str, NDArray[np.complex128]]:
    """Return the transfer from a torque on each node to the torque in ``spring`` [N m per N m], by node.

    Parameters
    ----------
    frequencies : ndarray, shape (frequencies,)
        [Hz], > 0.
    speed_loop : bool
        Close the speed loops (kp, ki and current lag, sampled control taken as continuous).
    """
    system = matrices(lowered)
    row = lowered.spring_names.index(spring)
    s = 2j * np.pi * frequencies[:, None, None]
    dynamic = s**2 * system.mass + s * system.damping + system.stiffness
    if speed_loop:
        drives = lowered.drives
        for on, kp, ki, lag in zip(drives.on, drives.kp, drives.ki, drives.inverse_lag, strict=True):
            gain = (kp + ki / s[:, 0, 0]) / (1 + s[:, 0, 0] / lag)
            dynamic[:, on, on] += s[:, 0, 0] * gain
    angles = np.linalg.inv(dynamic)
    a, b, r = lowered.springs.a[row], lowered.springs.b[row], lowered.springs.inverse_ratio[row]
    twist = angles[:, a, :] * r - angles[:, b, :]
    torque = (lowered.springs.stiffness[row] + s[:, 0] * lowered.springs.damping[row]) * twist
    return {name: torque[:, column] for column, name in enumerate(lowered.nodes)}
