"""Where a single parameter of a fit would be without its prior.

Near the maximum the posterior is ``exp(-1/2 d' H d)``, with H the Hessian and C its inverse. Without the prior of the
parameter i, whose standard deviation is 1, its maximum moves from x to ``x / (1 - C_ii)``, and the log-likelihood plus
the other priors gain ``1/2 x^2 / (1 - C_ii)``.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.fit import Fit

Floats = NDArray[np.float64]

FAR = 2.0  # [standard deviations] nearer than this to its stated value a number is not far off
MOVED = 4.0  # [standard deviations] farther from its stated value it explains what is no spread of copies of a rig
_DETERMINED = 1e-6  # [1] least share of the prior variance by which data narrow a parameter; less moves it anywhere


def without_priors(fit: Fit) -> tuple[Floats, Floats]:
    """Return where each parameter would be without its prior [standard deviations of it], and the gain [nats].

    Both have the shape (knobs,).
    """
    count = len(fit.knobs)
    narrowed = np.maximum(1 - np.diag(fit.covariance())[:count], _DETERMINED)
    return fit.positions / narrowed, 0.5 * np.square(fit.positions) / narrowed
