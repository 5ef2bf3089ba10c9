"""The same arrays as mass, damping and stiffness matrices, gaps closed and losses left out; more is in ``twin/``."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered
from torquerig.simulation.term_kinds import KINDS


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

    def held_at(self, nodes: NDArray[np.int64]) -> Matrices:
        """Return the matrices of the other nodes, where the numbers ``nodes`` follow an imposed motion."""
        free = np.setdiff1d(np.arange(len(self.nodes)), nodes)
        inner = np.ix_(free, free)
        names = tuple(self.nodes[at] for at in free)
        return Matrices(names, self.mass[inner], self.damping[inner], self.stiffness[inner])

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
    for kind in KINDS:
        for link in kind.links(getattr(lowered.arrays, kind.field), stiffest=stiffest):
            lean = np.zeros(n + 1)
            lean[link.on] += link.lever
            lean[link.against] -= 1.0
            stiffness += link.stiffness * np.outer(lean, lean)
            damping += link.damping * np.outer(lean, lean)
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
        drives = lowered.arrays.drives
        for on, kp, ki, lag in zip(drives.on, drives.kp, drives.ki, drives.inverse_lag, strict=True):
            gain = (kp + ki / s[:, 0, 0]) / (1 + s[:, 0, 0] / lag)
            dynamic[:, on, on] += s[:, 0, 0] * gain
    angles = np.linalg.inv(dynamic)
    a, b, r = lowered.arrays.springs.a[row], lowered.arrays.springs.b[row], lowered.arrays.springs.inverse_ratio[row]
    twist = angles[:, a, :] * r - angles[:, b, :]
    torque = (lowered.arrays.springs.stiffness[row] + s[:, 0] * lowered.arrays.springs.damping[row]) * twist
    return {name: torque[:, column] for column, name in enumerate(lowered.nodes)}
