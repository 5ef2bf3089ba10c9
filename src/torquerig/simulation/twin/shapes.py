"""A mode's shape in words: which shafts turn against which, and which spring twists most."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.assembly import Rig
from torquerig.simulation.lower import Lowered

Floats = NDArray[np.float64]

MOVES = 0.05  # [1] share of the largest motion below which a shaft counts as still
STRAINED = 0.25  # [1] share of the strain energy from which a spring is named


def node_names(rig: Rig, lowered: Lowered) -> dict[str, str]:
    """Return the names of each node for texts: its name and those of the bodies on it."""
    riders: dict[str, list[str]] = {node: [] for node in lowered.nodes}
    for part in rig.parts:
        if part.on_shaft and not part.opens_node and rig.node(part.name) in riders:
            riders[rig.node(part.name)].append(part.name)
    return {node: " + ".join(dict.fromkeys((node, *names))) for node, names in riders.items()}


def shape_in_words(shape: Floats, *, lowered: Lowered, turns: Floats, names: dict[str, str]) -> str:
    """Return a shape in words.

    Parameters
    ----------
    shape : ndarray, shape (nodes,)
        Angles of a mode.
    turns : ndarray, shape (nodes,)
        How fast each node turns per turn of the first, by the gears; 0 where nothing links it.
    """
    shares = strain_shares(shape, lowered)
    spring = _springs(shares, lowered)
    referred = shape / np.where(turns == 0, 1.0, turns)  # as if all were one shaft
    referred = referred / np.abs(referred).max() * np.sign(referred[np.abs(referred).argmax()])
    if not shares.any() or np.ptp(referred) < 1e-6:
        return "all shafts turn together"
    ahead = [names[node] for node, value in zip(lowered.nodes, referred, strict=True) if value > MOVES]
    behind = [names[node] for node, value in zip(lowered.nodes, referred, strict=True) if value < -MOVES]
    still = [names[node] for node, value in zip(lowered.nodes, referred, strict=True) if abs(value) <= MOVES]
    words = f"{_listed(ahead)} against {_listed(behind)}" if behind else f"{_listed(ahead)} alone"
    return words + (f"; {_listed(still)} nearly still" if still else "") + f"; twist in {spring}"


def strain_shares(shape: Floats, lowered: Lowered) -> Floats:
    """Return the share of each spring in the strain energy of a shape [1]; zeros where none is strained."""
    springs, angles = lowered.arrays.springs, np.append(shape, 0.0)
    twist = angles[springs.a] * springs.inverse_ratio - angles[springs.b]
    energy = springs.stiffness * twist**2
    largest = springs.stiffness * (angles[springs.a] ** 2 * springs.inverse_ratio**2 + angles[springs.b] ** 2)
    if energy.sum() <= 1e-10 * largest.sum():
        return np.zeros(energy.size)
    return np.asarray(energy / energy.sum())


def _springs(shares: Floats, lowered: Lowered) -> str:
    order = [int(row) for row in np.argsort(-shares) if shares[row] >= STRAINED]
    return _listed([f"{lowered.spring_names[row]} {100 * shares[row]:.0f} %" for row in order])


def _listed(names: list[str]) -> str:
    return " and ".join(", ".join(names).rsplit(", ", 1))
