"""Sequentially thresholded least squares: a sparse fit of columns to a target."""

from __future__ import annotations

from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_RIDGE = 1e-8
_MOST_PASSES = 20


def stlsq(columns: Floats, target: Floats, *, threshold: float) -> Floats:
    """Return the coefficients (columns,), 0 below ``threshold``; uses PySINDy if it is installed.

    Source: Brunton, Proctor and Kutz 2016, PNAS 113(15), 3932-3937; PySINDy 2, ``STLSQ``.
    """
    if find_spec("pysindy") is None:
        return plain_stlsq(columns, target, threshold=threshold)
    return pysindy_stlsq(columns, target, threshold=threshold)


def solver() -> str:
    """Return the name of the solver that ``stlsq`` calls."""
    return "a plain STLSQ (PySINDy is not installed)" if find_spec("pysindy") is None else "PySINDy's STLSQ"


def pysindy_stlsq(columns: Floats, target: Floats, *, threshold: float) -> Floats:
    """Return the coefficients of PySINDy's optimiser."""
    import warnings

    from pysindy import STLSQ

    with warnings.catch_warnings():  # it warns if no column remains, which is a valid result here
        warnings.simplefilter("ignore")
        found = STLSQ(threshold=threshold, alpha=_RIDGE, max_iter=_MOST_PASSES).fit(columns, target[:, None])
    return np.asarray(found.coef_[0], dtype=float)


def plain_stlsq(columns: Floats, target: Floats, *, threshold: float) -> Floats:
    """Return the coefficients without PySINDy: fit, remove small ones, and repeat until none is removed."""
    kept = np.ones(columns.shape[1], dtype=bool)
    answer = np.zeros(columns.shape[1])
    for _ in range(_MOST_PASSES):
        answer[:] = 0.0
        if not kept.any():
            return answer
        part = columns[:, kept]
        answer[kept] = np.linalg.solve(part.T @ part + _RIDGE * np.eye(part.shape[1]), part.T @ target)
        smaller = kept & (np.abs(answer) >= threshold)
        if (smaller == kept).all():
            break
        kept = smaller
    return answer
