"""The modes of a rig: natural frequencies without and with damping, and their shapes in words."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.assembly import Rig
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.operating_point import OperatingPoint, operating_point
from torquerig.simulation.twin.plant import plant
from torquerig.simulation.twin.shapes import node_names, shape_in_words
from torquerig.simulation.twin.system import LinearSystem

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Mode:
    """One mode of the open-loop rig.

    Parameters
    ----------
    undamped : float
        [Hz] of M and K alone, losses and friction left out; what tables of eigenfrequencies mean.
    magnitude : float
        ``|lambda| / 2 pi`` [Hz] of the damped rig. It is not ``undamped`` where damping couples the modes.
    damped : float
        ``Im lambda / 2 pi`` [Hz]: where it rings; 0 where it creeps back.
    damping : float
        ``-Re lambda / |lambda|`` [1].
    shape : ndarray, shape (nodes,)
        Angles, the largest 1.
    words : str
        The shape in words.
    """

    undamped: float
    magnitude: float
    damped: float
    damping: float
    shape: Floats
    words: str


@dataclass(frozen=True)
class Pole:
    """One root of the rig with its speed loop closed: frequency ``|lambda| / 2 pi`` [Hz], damping [1], what it is."""

    frequency: float
    damping: float
    what: str


def modes(rig: Rig, lowered: Lowered, *, point: OperatingPoint | None = None) -> tuple[Mode, ...]:
    """Return the elastic modes by rising undamped frequency; rigid turning is not among them.

    Nodes whose motion is imposed are clamped.

    Each undamped mode is paired with the damped root of the most similar shape (the modal assurance criterion of
    Allemang & Brown 1982, weighted by the masses), every root once.
    """
    from scipy.linalg import eigh

    system = matrices(lowered)
    free = np.setdiff1d(np.arange(len(lowered.nodes)), lowered.arrays.imposed.on.astype(np.int64))
    squares, clamped = eigh(system.stiffness[np.ix_(free, free)], system.mass[np.ix_(free, free)])
    shapes = np.zeros((len(lowered.nodes), free.size))
    shapes[free] = clamped
    elastic = np.flatnonzero(squares > 1e-10 * (squares[-1] if squares.size else 1.0))
    damped = plant(lowered, operating_point(rig, lowered) if point is None else point)
    roots, motion = _roots(damped, len(lowered.nodes))
    turns, names = _turns(rig, lowered), node_names(rig, lowered)
    found = []
    for column in elastic:
        shape = shapes[:, column]
        root = _likest(shape, float(np.sqrt(squares[column])), roots, motion, lowered.inertia)
        value = roots[root]
        roots, motion = np.delete(roots, root), np.delete(motion, root, axis=1)
        found.append(
            Mode(
                undamped=float(np.sqrt(squares[column]) / (2 * np.pi)),
                magnitude=float(abs(value) / (2 * np.pi)),
                damped=float(abs(value.imag) / (2 * np.pi)),
                damping=float(-value.real / abs(value)),
                shape=shape / shape[np.abs(shape).argmax()],
                words=shape_in_words(shape, lowered=lowered, turns=turns, names=names),
            )
        )
    return tuple(found)


def loop_poles(closed: LinearSystem, found: tuple[Mode, ...]) -> tuple[Pole, ...]:
    """Return the roots of a closed loop by rising frequency, each named after the open mode it comes from, or the loop.

    Conjugate pairs are returned once, without the root of free turning.
    """
    roots = closed.poles()
    roots = roots[(roots.imag >= 0) & (np.abs(roots) > 1e-6)]
    left = sorted(roots, key=abs)
    named: dict[int, str] = {}
    for number, mode in enumerate(found, start=1):
        free = [row for row in range(len(left)) if row not in named and left[row].imag > 0]
        if free:
            nearest = min(free, key=lambda row: abs(left[row].imag - 2 * np.pi * mode.damped))
            named[nearest] = f"mode {number}"
    return tuple(
        Pole(float(abs(root) / (2 * np.pi)), float(-root.real / abs(root)), named.get(row, "speed loop"))
        for row, root in enumerate(left)
    )


def _roots(system: LinearSystem, nodes: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Return the mechanical roots of a plant with Im >= 0 and the angles of their eigenvectors."""
    values, vectors = np.linalg.eig(system.A[: 2 * nodes, : 2 * nodes].astype(np.complex128))
    kept = values.imag >= 0
    return values[kept], vectors[:nodes, kept]


def _likest(
    shape: Floats, frequency: float, roots: NDArray[np.complex128], motion: NDArray[np.complex128], mass: Floats
) -> int:
    own = float(shape @ (mass * shape))
    theirs = np.einsum("nk,n,nk->k", motion.conj(), mass, motion).real
    alike = np.abs(shape @ (mass[:, None] * motion)) ** 2 / np.where(theirs > 0, own * theirs, np.inf)
    # shapes of one rig may be alike; among those, the nearer root
    return int(np.argmax(alike - 1e-3 * np.abs(np.abs(roots) - frequency) / frequency))


def _turns(rig: Rig, lowered: Lowered) -> Floats:
    ratios = rig.speed_ratios(lowered.leader())
    return np.array([ratios.get(node, 0.0) for node in lowered.nodes])
