"""What an effect beyond the linear twin changes in the features, from two simulations alike but for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.expectation import Expectation

Floats = NDArray[np.float64]

_FURTHEST = 1e4  # ratio of densities beyond which noise decides
_CHANCE = 0.25  # share of a simulated change that differs from one start to the next
_WHEN = 0.5  # share of a change in the blocks of a reversal: when flanks meet again is a matter of the last rad/s


@dataclass(frozen=True)
class Correction:
    """Factor on the density, addition to the square of the amplitudes, additions to level and turning torque.

    ``scatter`` is what the small number of events that make the change leaves of the density's logarithm to chance [1],
    ``beside`` what they leave of the square of any amplitude in each stretch [(N m)^2].
    """

    power: Floats
    squares: Floats
    level: Floats
    turning: Floats | None
    scatter: float = 0.0
    beside: Floats | float = 0.0


def between(
    after: Sequence[Expectation], before: Sequence[Expectation], *, scatter: Sequence[float] = ()
) -> list[Correction]:
    """Return what leads from features ``before`` to those ``after``, run by run; ``scatter`` as in ``Correction``."""
    answer = []
    for one, other, own in zip(after, before, scatter or [0.0] * len(after), strict=True):
        ratio = np.clip(np.nan_to_num(one.power / np.maximum(other.power, 1e-300), nan=1.0), 1 / _FURTHEST, _FURTHEST)
        turning = None if one.turning is None or other.turning is None else one.turning - other.turning
        answer.append(Correction(ratio, one.amplitude**2 - other.amplitude**2, one.level - other.level, turning, own))
    return answer


def corrected(model: Expectation, correction: Correction) -> Expectation:
    """Return the twin's expectation with the correction applied."""
    if model.turning is not None and correction.turning is not None:
        beside = np.hypot(model.turning_tolerance, _WHEN * correction.turning)
        return replace(model, turning=model.turning + correction.turning, turning_tolerance=beside)
    power = model.power * correction.power if model.power.size == correction.power.size else model.power
    chance = np.hypot(_CHANCE * np.log(correction.power), correction.scatter)
    return replace(
        model,
        variance=model.variance + correction.beside,
        power_tolerance=np.hypot(model.power_tolerance, chance) if power.size else 0.0,
        amplitude_tolerance=np.hypot(model.amplitude_tolerance, _CHANCE * np.sqrt(np.abs(correction.squares))),
        power=power,
        amplitude=np.sqrt(np.maximum(model.amplitude**2 + correction.squares, 0.0)),
        level=model.level + correction.level,
    )
