"""Where a single parameter of a fit would be without its prior.

Near the maximum the posterior is ``exp(-1/2 d' H d)``, with H the Hessian and C its inverse. Without the prior of the
parameter i, whose standard deviation is 1, its maximum moves from x to ``x / (1 - C_ii)``, and the log-likelihood plus
the other priors gain ``1/2 x^2 / (1 - C_ii)``.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.likelihood import LINE
from torquerig.inference.places import Place

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


def stated_again(fit: Fit) -> Floats:
    """Return the positions of a fit with the parameters that have moved far at their stated values, shape (knobs,)."""
    return np.where(np.abs(fit.positions) > MOVED, 0.0, fit.positions)


def moved_lines(fit: Fit, data: Data) -> list[Place]:
    """Return the lines of the rig whose stated size has moved far: of each number the line that it changes most."""
    residuals = all_residuals(data, fit.expected, fit.gains, fit.off)
    kind = np.concatenate([np.zeros(0), *(one.kind for one in residuals)])
    places = [seen.places[at] if is_line else None for seen, one in zip(data.seen, residuals, strict=True)
              for at, is_line in zip(one.at.tolist(), (one.kind == LINE).tolist(), strict=True)]  # fmt: skip
    answer = dict[Place, None]()
    for column in np.flatnonzero(np.abs(fit.positions) > MOVED).tolist():
        slopes = np.abs(fit.jacobian[: kind.size, column])
        most = int(np.argmax(slopes)) if slopes.size else 0
        if slopes.size and kind[most] == LINE and (place := places[most]) is not None:
            answer[place] = None
    return list(answer)
