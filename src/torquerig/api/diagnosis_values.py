"""The parts of a diagnosis as values, from the contract's form: findings, and the residual before and after."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from torquerig.inference.answer.mismatch import Mismatch


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A number with the ends of its 95 % interval, in the contract's unit; both are nan where none is stated."""

    value: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Finding:
    """One effect that the scenario leaves out.

    Parameters
    ----------
    mechanism, variant : str
        Name in the contract; which kind of it, empty where there is one.
    explanation : str
    confidence : float
        Between 0 and 1.
    parameters : mapping of str to Estimate
        By the contract's names.
    equivalent_to : tuple of str
        Mechanisms that the recordings do not distinguish from it.
    next_experiment : str or None
        The run that would.
    """

    mechanism: str
    variant: str
    explanation: str
    confidence: float
    parameters: Mapping[str, Estimate]
    equivalent_to: tuple[str, ...] = ()
    next_experiment: str | None = None


@dataclass(frozen=True, kw_only=True)
class HeldOutResidual:
    """The residual of held-out data, in the contract's metric.

    Parameters
    ----------
    nominal, before, after : float
        Of the scenario as it is stated, with its parameters fitted, and of the completed model.
    improvement : tuple of float or None
        Relative fall with the ends of its 95 % interval [1]; None where there was nothing to improve.
    """

    nominal: float
    before: float
    after: float
    improvement: tuple[float, float, float] | None


def finding_of(row: Mapping[str, Any]) -> Finding:
    """Return a row of ``findings``."""
    return Finding(
        mechanism=row["mechanism"],
        variant=row.get("variant", ""),
        explanation=row["explanation"],
        confidence=row["confidence"],
        parameters={name: _estimate(each) for name, each in row["parameters"].items()},
        equivalent_to=tuple(row["equivalent_to"]),
        next_experiment=row["next_experiment"],
    )


def mismatch_of(row: Mapping[str, Any]) -> Mismatch:
    """Return a row of ``mismatch``."""
    return Mismatch(**{**row, "recordings": tuple(row["recordings"])})


def residual_of(fit: Mapping[str, Any]) -> HeldOutResidual:
    """Return ``fit``."""
    improvement = fit["improvement"]
    return HeldOutResidual(
        nominal=fit["before"]["nominal"],
        before=fit["before"]["heldout_misfit"],
        after=fit["after"]["heldout_misfit"],
        improvement=None if improvement is None else (improvement["value"], *improvement["ci95"]),
    )


def _estimate(each: Mapping[str, Any]) -> Estimate:
    low, high = each["ci95"] or (float("nan"), float("nan"))
    return Estimate(value=each["value"], low=low, high=high, unit=each["unit"])
