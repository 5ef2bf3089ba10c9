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

REAL = 1e-6  # [1] part of a root's size below which its imaginary part is rounding: a double root is known to 1e-8


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
        ``Im lambda / 2 pi`` [Hz]: where it rings; 0 where it is overdamped.
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

    @property
    def is_overdamped(self) -> bool:
        """Whether it returns without oscillation, so that it has no damped frequency."""
        return self.damped == 0.0

    @property
    def time_constant(self) -> float:
        """Time in which it falls by a factor e [s]."""
        rate = 2 * np.pi * self.magnitude * self.damping
        return 1 / rate if rate else np.inf


@dataclass(frozen=True)
class Pole:
    """One root of the rig with its speed loop closed: frequency ``|lambda| / 2 pi`` [Hz], damping [1], what it is."""

    frequency: float
    damping: float
    what: str
    oscillates: bool = True

    @property
    def time_constant(self) -> float:
        """Time in which it falls by a factor e [s]; negative where it grows, infinite where it stays."""
        rate = 2 * np.pi * self.frequency * self.damping
        return 1 / rate if rate else np.inf


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
    elastic = range(len(rigid_motions(lowered)), free.size)
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
                damped=float(abs(value.imag) / (2 * np.pi)) if _oscillates(value) else 0.0,
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
        Pole(
            float(abs(root) / (2 * np.pi)), float(-root.real / abs(root)), named.get(row, "speed loop"),
            oscillates=_oscillates(root),
        )
        for row, root in enumerate(left)
    )  # fmt: skip


def rigid_motions(lowered: Lowered) -> tuple[tuple[str, ...], ...]:
    """Return the groups of nodes that turn freely together: linked by springs, and none of them held or imposed.

    Each group is one rigid-body motion, which has no frequency; it is counted by its springs and not by a small root.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    springs, n = lowered.arrays.springs, len(lowered.nodes)
    ends = (springs.a.astype(np.int64), springs.b.astype(np.int64))
    linked = coo_array((np.ones(springs.a.size), ends), shape=(n + 1, n + 1))
    _, group = connected_components(linked, directed=False)
    held = {int(group[n]), *(int(group[int(on)]) for on in lowered.arrays.imposed.on)}
    free = [one for one in dict.fromkeys(group[:n].tolist()) if one not in held]
    return tuple(tuple(name for row, name in enumerate(lowered.nodes) if group[row] == one) for one in free)


def _oscillates(root: complex) -> bool:
    """Whether a root is one of a pair; the imaginary part of a real root is not exactly 0 in floating point."""
    return abs(root.imag) > REAL * abs(root)


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
