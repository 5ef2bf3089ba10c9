"""Features of all runs, and their residuals under a model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.likelihood import Discrepancy, Residuals, residuals
from torquerig.inference.load_spectrum import GainShapes, gain_shapes, with_gains
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Data:
    """Features of all runs, with the triangles of the load's spectrum in the bands of each."""

    seen: tuple[RunFeatures, ...]
    shapes: tuple[GainShapes, ...]

    @staticmethod
    def of(seen: Sequence[RunFeatures], *, rows: Sequence[int] | None = None, runs: Sequence[MeasuredRun] = ()) -> Data:
        """Return the data of the features of all runs, or of those with the numbers ``rows`` among ``runs``."""
        numbers, all_runs = range(len(seen)) if rows is None else rows, runs or [each.run for each in seen]
        shapes = [gain_shapes(each, run=row, runs=all_runs) for row, each in zip(numbers, seen, strict=True)]
        return Data(tuple(seen), tuple(shapes))


def all_residuals(data: Data, expected: Sequence[ExpectedRun], gains: Floats, off: Discrepancy) -> list[Residuals]:
    """Return the residuals of each run, the gains of the load's spectrum applied."""
    return [
        residuals(seen, with_gains(model, shape, gains), off)
        for seen, model, shape in zip(data.seen, expected, data.shapes, strict=True)
    ]
