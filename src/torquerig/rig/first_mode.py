"""The first elastic mode of a rig's shafts, from inertias and springs alone."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from torquerig.errors import InputError
from torquerig.rig.terms import Inertia, Spring, Term

_RIGID = 1e-10  # [1] squared frequency relative to the highest one, below which a mode is a rigid rotation


def first_elastic_mode(terms: Iterable[Term]) -> float:
    """Return the lowest angular frequency of the undamped free vibration that twists a spring [rad/s].

    ``K v = omega^2 M v`` with M the inertias and K the springs, each between ``a`` and ``b`` of its ratio (Genta,
    Vibration Dynamics and Control, 2009, section 4.1). Gaps count as closed; friction, drives and loads are left out.

    Raises
    ------
    InputError
        Where no spring lies between two inertias.
    """
    found = tuple(terms)
    inertia: dict[str, float] = {}
    for one in found:
        if isinstance(one, Inertia) and one.inertia > 0:
            inertia[one.node] = inertia.get(one.node, 0.0) + one.inertia
    nodes = {name: row for row, name in enumerate(inertia)}
    stiffness = np.zeros((len(nodes) + 1, len(nodes) + 1))  # the last node stands still
    for one in found:
        if isinstance(one, Spring):
            lean = np.zeros(len(nodes) + 1)
            lean[nodes.get(one.a, -1)] += 1 / one.ratio
            lean[nodes.get(one.b, -1)] -= 1.0
            stiffness += one.stiffness * np.outer(lean, lean)
    root = 1 / np.sqrt(np.array(list(inertia.values())))
    squares = np.linalg.eigvalsh(stiffness[:-1, :-1] * np.outer(root, root)) if nodes else np.zeros(0)
    elastic = squares[squares > _RIGID * squares.max(initial=0.0)]
    if not elastic.size:
        raise InputError("the rig has no spring between two inertias, so that it has no elastic mode")
    return float(np.sqrt(elastic[0]))
