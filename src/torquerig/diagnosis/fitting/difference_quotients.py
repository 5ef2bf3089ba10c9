"""Derivatives of residuals by stepping knobs, several at once where they share no residual."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Residuals = Callable[[Floats], Floats]

_STEP = 1e-6
_SHARED = 0.1  # what two knobs may share: residuals are in units of their spread, positions too


def quotients(residuals: Residuals, here: Floats, found: Floats, *, known: Floats, kept: bool = False) -> Floats:
    """Return the difference quotients at ``here``, shape (residuals, knobs).

    Knobs that share no residual are stepped together, each residual taken as changed by the knob that rules it
    (Curtis, Powell and Reid 1974, IMA J. Appl. Math. 13). Who shares what is seen in ``known``, the quotients of the
    first knobs at another position, which are returned as they are where ``kept``.

    Parameters
    ----------
    here : ndarray, shape (knobs,)
    found : ndarray, shape (residuals,)
        At ``here``.
    known : ndarray, shape (residuals, first knobs)
    """
    answer = np.zeros((found.size, here.size))
    answer[:, : known.shape[1]] = known
    alone = [[column] for column in range(known.shape[1], here.size)]
    for together in alone if kept else [*_apart(known), *alone]:
        step = np.where(here[together] <= 0, _STEP, -_STEP)
        beside = here.copy()
        beside[together] += step
        change = residuals(beside) - found
        rules = np.argmax(np.abs(answer[:, together]), axis=1)
        ruled = (np.arange(found.size), np.array(together)[rules])
        others = answer[:, together] @ step - answer[ruled] * step[rules]
        answer[ruled] = (change - others) / step[rules]
    return answer


def _apart(known: Floats) -> list[list[int]]:
    """Return the knobs in groups of which no two share more than a trace, the greatest first."""
    size = np.abs(known)
    answer: list[list[int]] = []
    for column in np.argsort(-np.linalg.norm(size, axis=0)).tolist():
        for group in answer:
            if all(np.linalg.norm(np.minimum(size[:, column], size[:, other])) < _SHARED for other in group):
                group.append(column)
                break
        else:
            answer.append([column])
    return answer
