"""What recordings with a measured motion would show of each mechanism, and what they do not separate, without a search.

A hypothesis of the size a changes the transformed effort by d(a). The parameters of the nominal model, with the
derivatives J, follow a part of it. What remains has, with the weights W = (9/8) / S of the likelihood, the square

    |d|^2_perp = d' W d - d' W J (J' W J + I)^-1 J' W d

A size is found in 95 % of such recordings if |d|_perp = sqrt(2 T) + 1.645, with T the nats that an addition needs.
Two hypotheses whose signatures have the angle phi differ by 1/2 |d|^2_perp sin^2 phi nats. Source: section 9 of
docs/explanation-diagnosis.md; Krysander & Frisk 2008, IEEE Trans. SMC A 38. True where the nominal rig explains the
recordings; a density S that holds missing physics makes the sizes too large.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import log, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.answer.confidence import ALIKE
from torquerig.inference.motion.density import weights
from torquerig.inference.motion.fitted_model import Fit, simulated
from torquerig.inference.motion.hypotheses import proposals
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.inference.motion.parameters_found import FIELDS
from torquerig.inference.motion.search import LEAST_GAIN

Floats = NDArray[np.float64]

_FREEDOM = 3.0  # [nats] of the evidence that a fitted size costs, as in torquerig.inference.isolability
_POWER = 1.645  # [standard deviations] quantile of 95 %
_LARGER = 2.0  # times the smallest size, for which two hypotheses are compared
_SHARES = np.geomspace(1e-4, 100.0, 10)  # of the median of the prior, at which an effect is simulated
_SIZES = ("coulomb", "gap", "coefficient", "inertia")  # fields that are the size of an effect


@dataclass(frozen=True, eq=False)
class Signature:
    """A hypothesis at its smallest visible size, in SI units, and its change in standard deviations."""

    hypothesis: Hypothesis
    field: str
    size: float
    change: Floats


@dataclass(frozen=True, eq=False)
class _Nominal:
    """The fitted nominal model: its derivatives J and the root of W, in the rows that are fitted."""

    fit: Fit
    design: Floats
    root: Floats

    @staticmethod
    def of(fit: Fit) -> _Nominal:
        rows = [row for row, run in enumerate(fit.runs) if run.seen.any()]
        density = [np.broadcast_to(fit.density[row], fit.residuals[row][fit.runs[row].seen].shape) for row in rows]
        root = np.sqrt(weights(np.zeros(1), np.concatenate([one.ravel() for one in density])))
        design = np.column_stack([_stacked(fit, fit.derivatives[name]) for name in fit.names]) * root[:, None]
        return _Nominal(fit, design, root)

    def signature(self, change: list[Floats]) -> Floats:
        """Return a change without what the nominal parameters follow, so that its square is ``|d|^2_perp``."""
        whole = self.root * _stacked(self.fit, change)
        inner = self.design.T @ self.design + np.eye(self.design.shape[1])
        left = whole - self.design @ np.linalg.solve(inner, self.design.T @ whole)
        square = float(whole @ left)  # d' W d - d' W J (J' W J + I)^-1 J' W d
        return np.asarray(left * np.sqrt(max(square, 0.0) / max(float(left @ left), 1e-300)))


def _stacked(fit: Fit, each: list[Floats]) -> Floats:
    return np.concatenate([one[run.seen].ravel() for one, run in zip(each, fit.runs, strict=True) if run.seen.any()])


def signatures(fit: Fit) -> list[Signature]:
    """Return one hypothesis of each mechanism and place at its smallest visible size, where it has one."""
    nominal, found, done = _Nominal.of(fit), [], set[str]()
    for each in proposals(fit):
        if each.is_named and each.name not in done:
            done.add(each.name)
            one = _linear(nominal, each) if each.columns is not None else _simulated(nominal, each)
            found += [] if one is None else [one]
    return found


def _least(each: Hypothesis) -> float:
    return float(np.sqrt(2 * (LEAST_GAIN - each.log_odds + _FREEDOM)) + _POWER)


def _linear(nominal: _Nominal, each: Hypothesis) -> Signature | None:
    assert each.columns is not None
    change = nominal.signature([run.transformed(each.columns(run)[:, 0]) for run in nominal.fit.runs])
    length = float(np.linalg.norm(change))
    size = _least(each) / length if length else np.inf
    return None if size > 10 * each.scale else Signature(each, "amplitude", size, size * change)


def _simulated(nominal: _Nominal, each: Hypothesis) -> Signature | None:
    """Return the size between two simulated ones at which the length of the signature is the least one."""
    main = next((knob for knob in each.knobs if knob.field in _SIZES), None)
    if main is None:  # a limit has no size that grows from nothing
        return None
    median, least, before = main.value(nominal.fit.model.plus(each).rig), _least(each), (0.0, 0.0)
    for share in _SHARES.tolist():
        change = _change(nominal, each, share)
        length = 0.0 if change is None else float(np.linalg.norm(change))
        if change is not None and length >= least:
            power = log(length / before[1]) / log(share / before[0]) if before[1] else 1.0
            size = median * share * (least / length) ** (1 / max(power, 0.2))
            return Signature(each, main.field, size, change * (least / length))
        before = (share, length)
    return None


def _change(nominal: _Nominal, each: Hypothesis, share: float) -> Floats | None:
    """Return the signature of an effect at a share of its median size; its drag grows with it."""
    fit = nominal.fit
    sized = [knob.field in (*_SIZES, "viscous") for knob in each.knobs]
    model = fit.model.plus(each)
    moved = [log(share) / knob.spread if grows else 0.0 for knob, grows in zip(each.knobs, sized, strict=True)]
    at = np.concatenate([fit.positions[: len(fit.model.knobs)], moved])
    made = simulated(model, fit.runs, at, [bool(run.seen.any()) for run in fit.runs])
    return None if made is None else nominal.signature(
        [one - two for one, two in zip(fit.base, made, strict=True)]
    )  # fmt: skip


def limits(found: Sequence[Signature], unit: str) -> Iterator[dict[str, Any]]:
    """Yield the smallest visible sizes in the form of the contract; ``unit`` is that of the effort, N*m or N."""
    for each in sorted(found, key=lambda one: one.hypothesis.mechanism):
        name, turning, moving = FIELDS.get(each.field, ("amplitude_Nm", "N*m", "N"))
        factor = 60 * 180 / pi if each.field == "gap" and unit == "N*m" else 1.0
        if each.field == "gap" and unit == "N":
            name = "gap_m"
        yield {
            "mechanism": each.hypothesis.mechanism, "parameter": name, "value": float(f"{factor * each.size:.3g}"),
            "unit": turning if unit == "N*m" else moving, "place": each.hypothesis.label, "grows": "up",
        }  # fmt: skip


def inseparable(found: Sequence[Signature]) -> Iterator[tuple[Hypothesis, Hypothesis]]:
    """Yield the pairs of mechanisms that are less than ``ALIKE`` nats apart at twice the smallest visible size."""
    for one, other in combinations(found, 2):
        square = float(one.change @ one.change)
        cosine = float(one.change @ other.change) / np.sqrt(square * float(other.change @ other.change))
        names = {one.hypothesis.mechanism, other.hypothesis.mechanism}
        if len(names) == 2 and 0.5 * square * (1 - cosine**2) * _LARGER**2 < ALIKE:
            yield one.hypothesis, other.hypothesis
