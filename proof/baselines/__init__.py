"""What others would say of the same recordings: three baselines whose verdicts are scored like the diagnosis'.

All three are given the calibrated nominal model of the diagnosis, which flatters them.

- ``refit_only``         the nominal model with its numbers fitted: whether something is left, never what
- ``residual_fft``       lines of the residual's spectrum, each named after the nearest line of the kinematic table
- ``named_lines``        that table: what stands where
- ``sparse_regression``  STLSQ on the torque with a column for every effect that can be one
- ``columns``            those columns
- ``stlsq``              sequentially thresholded least squares: PySINDy's, or the same in a few lines without it
- ``verdict``            the form of a diagnosis
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from proof.baselines.refit_only import refit_only
from proof.baselines.residual_fft import residual_fft
from proof.baselines.sparse_regression import sparse_regression
from torquerig.diagnosis.engine import Outcome

BASELINES: dict[str, Callable[[Outcome], dict[str, Any]]] = {
    "residual_fft": residual_fft,
    "sparse_regression": sparse_regression,
    "refit_only": refit_only,
}
TITLES = {
    "torquerig": "torquerig diagnose",
    "residual_fft": "residual FFT with kinematic table",
    "sparse_regression": "sparse regression (STLSQ)",
    "refit_only": "refitting parameters only",
}

__all__ = ["BASELINES", "TITLES"]
