"""Which quantity the residuals of mean torques follow: the time of a recording, the speed, or the torque itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.context import Context
from torquerig.inference.fit import Data, Fit
from torquerig.inference.mean_torques import MeanTorques

Floats = NDArray[np.float64]

_PLACES = np.linspace(0.1, 0.9, 9)  # quantiles of a quantity at which a course may step or bend


def followed(fit: Fit, data: Data) -> str:
    """Return ``time``, ``speed`` or ``level``, by the course over it that explains most: a step or a bend.

    A course over the time is the same in every recording. Where two explain as much, it is the first of these.
    """
    torques = MeanTorques.of(Context(fit, data, ()))
    time, speed = 0.5 * (torques.low + torques.high), torques.speed.mean(axis=1)
    quantities = {"time": (time, torques.sign), "speed": (speed, np.sign(speed)),
                  "level": (torques.expected, np.sign(torques.expected))}  # fmt: skip
    explained = {name: _most(torques, *each) for name, each in quantities.items()}
    return max(explained, key=lambda name: explained[name])


def _most(torques: MeanTorques, own: Floats, sign: Floats) -> float:
    """Return the largest gain of the log-posterior by a step or a bend over the size of a quantity [nats]."""
    if not own.size:
        return 0.0
    over = np.abs(own)[:, None] - np.quantile(np.abs(own), _PLACES)
    courses = np.concatenate([np.where(over > 0, 1.0, 0.0), np.maximum(over, 0.0)], axis=1)
    gains, _ = torques.explained(sign[:, None] * courses)
    return float(gains.max())
