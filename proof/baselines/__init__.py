"""Three simpler methods on the same recordings; their verdicts are scored like those of the diagnosis.

All start from the calibrated nominal model of the diagnosis, which is an advantage for them.

- ``refit_only``         the nominal model with fitted parameters: tests for a significant residual, names no mechanism
- ``residual_fft``       lines of the residual's spectrum, each named after the nearest line of the kinematic table
- ``named_lines``        the kinematic table of lines
- ``sparse_regression``  STLSQ on the torque, with columns for the mechanisms
- ``columns``            the columns of that regression
- ``stlsq``              sequentially thresholded least squares, of PySINDy or a plain version
- ``calibrated``         the calibrated model
- ``verdict``            the verdict in the form of a diagnosis
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from proof.baselines.calibrated import Calibrated
from proof.baselines.refit_only import refit_only
from proof.baselines.residual_fft import residual_fft
from proof.baselines.sparse_regression import sparse_regression

BASELINES: dict[str, Callable[[Calibrated], dict[str, Any]]] = {
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
