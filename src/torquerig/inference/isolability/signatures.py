"""What a hypothesis changes in the features, in standard deviations, with all nuisances projected out.

With J the derivatives of the standardised residuals by the parameters of the model, whose prior is a standard normal
distribution, a change ``d`` of the residuals keeps ``|d|^2 = d' (I - J (J'J + I)^-1 J') d`` of its square when the
parameters follow it. Half of it is the gain of log-likelihood [nats] that the hypothesis would bring.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.addition import DECADE, Addition, Reported
from torquerig.inference.context import Context
from torquerig.inference.fit import all_residuals
from torquerig.inference.knobs import turned
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.search import LEAST_GAIN
from torquerig.inference.slopes import stacked

Floats = NDArray[np.float64]

_DECADES = 4.0  # around the median of the prior in which the smallest size is searched
_FAR = 4.0  # [standard deviations of the prior] the same of a parameter with a sign
_PRECISE = 0.05  # of the logarithm of the change: an amplitude is then known to 2.5 %
_STEPS = 12  # at most
_FREEDOM = 3.0  # [nats] that a size costs which is then known to a twentieth of its prior's decade
ONE_SIDED = 1.645  # standard deviations: 95 % of all recordings show more


@dataclass(frozen=True, eq=False)
class Signature:
    """A hypothesis at the smallest size that these runs would show.

    Parameters
    ----------
    addition : Addition
    reported : Reported
        The parameter that measures its size.
    value : float
        In the unit of ``reported``.
    positions : ndarray, shape (knobs,)
        Of the addition's parameters.
    change : ndarray, shape (features + parameters,)
        Change of the standardised residuals, nuisances projected out.
    grows_down : bool
        Whether a smaller value is the larger effect, as with a cutoff.
    two_sided : bool
        Whether the effect has a sign.
    """

    addition: Addition
    reported: Reported
    value: float
    positions: Floats
    change: Floats
    grows_down: bool
    two_sided: bool


def required(each: Addition) -> float:
    """Return the size of a change [standard deviations] from which an addition is found in 95 % of recordings."""
    return float(np.sqrt(2 * (LEAST_GAIN - each.log_odds + _FREEDOM))) + ONE_SIDED


class Projection:
    """Changes of a model's residuals with its parameters projected out."""

    def __init__(self, context: Context) -> None:
        self.context = context
        fit, data = context.fit, context.data
        self.base = all_residuals(data, fit.expected, fit.gains, fit.off)
        self.along = np.linalg.qr(np.concatenate([fit.jacobian, np.eye(fit.jacobian.shape[1])]))[0]
        self._kept: dict[tuple[int, bytes], tuple[Addition, Floats | None]] = {}  # an address is unique while held

    def change(self, each: Addition, positions: Floats) -> Floats | None:
        """Return what an addition with its parameters at ``positions`` changes; None where there is no such rig."""
        key = id(each), positions.tobytes()
        if key not in self._kept:
            self._kept[key] = each, self._changed(each, positions)
        return self._kept[key][1]

    def _changed(self, each: Addition, positions: Floats) -> Floats | None:
        fit, data = self.context.fit, self.context.data
        try:
            rig = turned(each.added_to(self.context.rig), each.knobs, positions)
            expected = [expected_run(rig, seen) for seen in data.seen]
        except (TorquerigError, ValueError, OverflowError, np.linalg.LinAlgError):
            return None
        there = all_residuals(data, expected, fit.gains, fit.off)
        pairs = list(zip(there, self.base, strict=True))
        moved = np.concatenate([(one.value - own.value) / own.sd for one, own in pairs])
        wider = np.log(np.concatenate([one.sd / own.sd for one, own in pairs]))
        full = np.concatenate([stacked(moved, wider), np.zeros(self.along.shape[1])])
        return np.asarray(full - self.along @ (self.along.T @ full))


def signature(projection: Projection, each: Addition) -> Signature | None:
    """Return a hypothesis at its smallest visible size; None where no size within four decades is visible.

    Its size is one of the reported parameters: an amplitude, with all other amplitudes in proportion; else the
    parameter with which the effect vanishes, and of several the one that grows up and moves least.
    """
    best: Signature | None = None
    for one in each.reported:
        columns = _size_columns(each, one)
        found = None if columns is None else _along(projection, each, one, columns)
        if found is not None and columns is not None and each.knobs[columns[0]].spread == DECADE:
            return found
        if found is not None and (best is None or _reach(found) < _reach(best)):
            best = found
    return best


def _size_columns(each: Addition, one: Reported) -> tuple[int, ...] | None:
    """Return the parameters that move with a reported one, itself first: all amplitudes that nobody knows."""
    part = each.parts[0].name
    own = next(
        (at for at, knob in enumerate(each.knobs) if (knob.part, knob.field, knob.key) == (part, one.field, one.key)),
        None,
    )
    if own is None:
        return None
    alike = [at for at, knob in enumerate(each.knobs) if at != own and knob.spread == each.knobs[own].spread == DECADE]
    return (own, *alike)


def _reach(found: Signature) -> tuple[bool, float]:
    spreads = np.array([knob.spread if knob.factor else DECADE for knob in found.addition.knobs])
    return found.grows_down, float(np.abs(found.positions * spreads).max())


def _along(projection: Projection, each: Addition, one: Reported, columns: tuple[int, ...]) -> Signature | None:
    """Return where the change reaches the required size along some parameters that make the effect vanish."""
    wanted, knob = required(each), each.knobs[columns[0]]
    at, size = partial(_positions, each, columns), partial(_size, projection, each, columns)
    far = _DECADES * DECADE / knob.spread
    ends = (-far, far) if knob.factor else (0.0, _FAR)
    sizes = [size(end) for end in ends]
    if not (np.isfinite(sizes).all() and min(sizes) < wanted < max(sizes)):
        return None
    down = sizes[0] > sizes[1]
    found = _crossing(lambda position: float(np.log(max(size(position), 1e-12) / wanted)), ends, sizes, wanted)
    there = projection.change(each, at(found))
    if there is None:
        return None
    value = knob.turned(knob.value(each.added_to(projection.context.rig)), found)
    return Signature(each, one, value, at(found), there, grows_down=down, two_sided=not knob.factor)


def is_shown(projection: Projection, each: Addition, name: str, value: float) -> bool:
    """Return whether these runs would show a hypothesis with such a value of the reported parameter ``name``."""
    one = next((one for one in each.reported if one.name == name), None)
    columns = None if one is None else _size_columns(each, one)
    if columns is None:
        return False
    knob = each.knobs[columns[0]]
    median = knob.value(each.added_to(projection.context.rig))
    position = (np.log(value / median) if knob.factor else value - median) / knob.spread
    return _size(projection, each, columns, float(position)) >= required(each)


def _positions(each: Addition, columns: tuple[int, ...], position: float) -> Floats:
    positions = np.zeros(len(each.knobs))
    positions[list(columns)] = position
    return positions


def _size(projection: Projection, each: Addition, columns: tuple[int, ...], position: float) -> float:
    """Return the size of a change [standard deviations]; NaN where there is no such rig."""
    found = projection.change(each, _positions(each, columns, position))
    return np.nan if found is None else float(np.linalg.norm(found))


def _crossing(
    above: Callable[[float], float], ends: tuple[float, float], sizes: Sequence[float], wanted: float
) -> float:
    """Return where a change has the required size: secants on its logarithm, halvings where they leave the bracket."""
    none, full = ends if sizes[0] < sizes[1] else ends[::-1]
    low, high = (float(np.log(max(one, 1e-12) / wanted)) for one in (min(sizes), max(sizes)))
    middle = 0.5 * (none + full)
    for _ in range(_STEPS):
        gap = above(middle)
        if abs(gap) < _PRECISE:
            break
        none, low, full, high = (none, low, middle, gap) if gap > 0 else (middle, gap, full, high)
        share = -low / (high - low)
        middle = none + min(max(share, 0.1), 0.9) * (full - none)  # a change that saturates misleads a secant
    return middle
