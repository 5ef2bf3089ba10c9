"""Integrators: three explicit rules as tables of weights."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program.laws import Integrator

_DORMAND_PRINCE = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
)
_LAST = (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84)


def rule_of(integrator: Integrator) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return a rule's weights of earlier stages (s, s) and of all stages at the end (s,).

    Source: Dormand and Prince 1980, J. Comp. Appl. Math. 6(1), 19-26, table 2 (the fifth-order rule).
    """
    if integrator is Integrator.EULER:
        return np.zeros((1, 1)), np.ones(1)
    if integrator is Integrator.MIDPOINT:
        return np.array([[0.0, 0.0], [0.5, 0.0]]), np.array([0.0, 1.0])
    rows = np.zeros((6, 6))
    for i, row in enumerate(_DORMAND_PRINCE):
        rows[i, : len(row)] = row
    return rows, np.array(_LAST)
