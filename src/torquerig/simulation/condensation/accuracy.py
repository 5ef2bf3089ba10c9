"""What a condensation changes below the recorded band: natural frequencies, and the response of the reading."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.linear import Matrices, matrices
from torquerig.simulation.lower import Lowered

POINTS = 300  # frequencies of a response
DECADES = 3.0  # below the top of the band down to which a response is compared


@dataclass(frozen=True)
class Accuracy:
    """Changes below ``band`` [Hz].

    Parameters
    ----------
    shift : float
        The largest relative change of a natural frequency [1].
    response : float
        The largest change of a response [1]: from a torque that acts to a torque that is read, its rms over the
        logarithm of frequency, in parts of the rms of that response.
    fastest : tuple of float
        The fastest motion, ``|root| / 2 pi`` [Hz], before and after.
    """

    band: float
    shift: float
    response: float
    fastest: tuple[float, float]


def accuracy(full: Lowered, small: Lowered, *, band: float, acting: Sequence[str], read: Sequence[str]) -> Accuracy:
    """Return how far a condensed rig is from the full one below ``band`` [Hz], both linear and without speed loop.

    Parameters
    ----------
    acting : sequence of str
        Nodes on which torques act.
    read : sequence of str
        Springs whose torque is read.
    """
    before, after = (np.sort(_moving(one, stiffest=True).undamped_frequencies()) for one in (full, small))
    # rigid motions have no frequency; below a thousandth of the band they cannot be separated from one
    lows = [one[one > band * 10**-DECADES] for one in (before, after)]
    lows = [one[one < band] for one in lows]
    count = min(one.size for one in lows)
    shift = np.abs(lows[1][:count] / lows[0][:count] - 1)
    frequencies = np.geomspace(band * 10**-DECADES, band, POINTS)
    want, have = (_responses(one, frequencies, acting=acting, read=read) for one in (full, small))
    size = np.sqrt(np.mean(np.abs(want) ** 2, axis=0))
    change = np.sqrt(np.mean(np.abs(have - want) ** 2, axis=0))
    imposed = _imposed_among(acting, full)
    return Accuracy(
        band=band,
        shift=float(shift.max(initial=0.0)),
        response=max(_worst(change[:, kind], size[:, kind]) for kind in (imposed, ~imposed)),
        fastest=(fastest_motion(full), fastest_motion(small)),
    )


def fastest_motion(lowered: Lowered) -> float:
    """Return ``|root| / 2 pi`` [Hz] of the fastest motion, an oscillation or a decay; imposed motions are none."""
    system = _moving(lowered, stiffest=True)
    return float(np.abs(np.linalg.eigvals(system.state_matrix())).max()) / (2 * pi) if system.nodes else 0.0


def _held(lowered: Lowered) -> NDArray[np.int64]:
    """Return the numbers of the nodes whose motion is imposed."""
    on = [lowered.node(term.on) for term in lowered.imposed_terms if not term.released]
    return np.array([at for at in on if at < len(lowered.nodes)], dtype=np.int64)


def _moving(lowered: Lowered, *, stiffest: bool = False) -> Matrices:
    """Return the matrices of the nodes that move freely."""
    return matrices(lowered, stiffest=stiffest).held_at(_held(lowered))


def _imposed_among(acting: Sequence[str], lowered: Lowered) -> NDArray[np.bool_]:
    """Return which of the acting nodes follow an imposed motion."""
    held = {lowered.nodes[at] for at in _held(lowered)}
    return np.array([name in held for name in acting], dtype=bool)


def _worst(change: NDArray[np.float64], size: NDArray[np.float64]) -> float:
    """Return the largest change of a read spring [1], shape (springs, nodes).

    A node that hardly moves what is read is judged by the one that moves it most.
    """
    if not change.size:
        return 0.0
    return float((change.max(axis=1) / np.maximum(size.max(axis=1), 1e-300)).max(initial=0.0))


def _responses(
    lowered: Lowered, frequencies: NDArray[np.float64], *, acting: Sequence[str], read: Sequence[str]
) -> NDArray[np.complex128]:
    """Return the torque in each read spring, shape (frequencies, springs, nodes).

    Per torque on each acting node, or per angle of one whose motion is imposed.
    """
    system, springs, held = matrices(lowered), lowered.arrays.springs, _held(lowered)
    s = 2j * pi * frequencies[:, None, None]
    pushed, moved = np.zeros((len(lowered.nodes), len(acting))), np.zeros((len(lowered.nodes), len(acting)))
    for column, name in enumerate(acting):
        if (row := lowered.node(name)) < len(lowered.nodes):
            (moved if row in held else pushed)[row, column] = 1.0
    free = np.setdiff1d(np.arange(len(lowered.nodes)), held)
    dynamic = s**2 * system.mass + s * system.damping + system.stiffness
    angles = np.broadcast_to(moved, (frequencies.size, *moved.shape)).astype(np.complex128)
    driven = pushed[free] - dynamic[:, free, :] @ moved.astype(np.complex128)
    angles[:, free, :] = np.linalg.solve(dynamic[:, free[:, None], free], driven)
    angles = np.concatenate([angles, np.zeros((frequencies.size, 1, len(acting)))], axis=1)
    rows = [lowered.spring(name) for name in read]
    twist = angles[:, springs.a[rows], :] * springs.inverse_ratio[rows][:, None] - angles[:, springs.b[rows], :]
    return np.asarray((springs.stiffness[rows][:, None] + s * springs.damping[rows][:, None]) * twist)
