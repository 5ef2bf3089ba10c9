"""A model with fewer parts or parameters, fitted anew from where the larger one is.

The gains of the load and the sizes of the discrepancy of the larger model may lead to a lower maximum. A fit that
begins without them is compared with one that begins with them, and the better sketch of both is finished.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.climb import Case, Point, resized
from torquerig.inference.fit import Data, Fit, finished, sketched
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import Discrepancy

Floats = NDArray[np.float64]


def refitted(
    fit: Fit, data: Data, *, keeps: Callable[[Knob], bool], without: frozenset[str] = frozenset()
) -> Fit | None:  # fmt: skip
    """Return the fit without some parts and parameters; None where there cannot be such a rig.

    Parameters
    ----------
    keeps : callable
        Whether a parameter is still fitted; the others are at the medians of their priors.
    without : frozenset of str
        Names of the parts that are left out.
    """
    kept = [at for at, knob in enumerate(fit.knobs) if keeps(knob)]
    columns = [*kept, *range(len(fit.knobs), fit.jacobian.shape[1])]
    rig = fit.rig
    try:
        for name in sorted(without):
            rig = rig.without(name)
        again = partial(sketched, rig, tuple(fit.knobs[at] for at in kept), data, start=fit.positions[kept],
                        nominal=fit.nominal)  # fmt: skip
        both = (again(gains=fit.gains, off=fit.off, jacobian=fit.jacobian[:, columns]),
                again(jacobian=slopes_at_medians(fit, data)[:, columns]))  # fmt: skip
        return finished(max(both, key=lambda one: one.log_evidence), data)
    except (TorquerigError, ValueError, np.linalg.LinAlgError):
        return None


def slopes_at_medians(fit: Fit, data: Data) -> Floats:
    """Return the derivatives of a fit for another that begins at the medians of the sizes of the discrepancy."""
    point = Point(fit.positions, fit.gains, fit.expected, fit.jacobian)
    return resized(Case(fit.rig, fit.knobs, data, fit.off), point, Discrepancy()).slopes
