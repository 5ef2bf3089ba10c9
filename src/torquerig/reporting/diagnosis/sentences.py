"""Words of a diagnosis: the place and kind of a mismatch, a wrong fact, a p-value, how a residual is named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.layout import plain

_SMALLEST = 1e-12
_STROKE = ("m", "rad")  # axes of a measured position, as opposed to a count of turns
_SHAFT = {"output_shaft": "output shaft", "motor_shaft": "motor shaft"}
_ANGLE = {axis: f"angle of the {shaft}" for axis, shaft in _SHAFT.items()}
WORDS = {
    "adequate": "adequate",
    "missing_physics": "missing physics",
    "unexplained": "unexplained",
}


@dataclass(frozen=True, kw_only=True)
class ResidualMeasure:
    """How the residual on held-out data is named and formatted.

    Parameters
    ----------
    name : str
    percent : bool
        Whether it is a share, written in per cent.
    of : str
        What the share refers to, written behind the number.
    true_model : str
        Sentence with the value that a true model has, or empty.
    without_place : str
        Sentence for an unexplained residual that no place locates.
    """

    name: str
    percent: bool = False
    of: str = ""
    true_model: str = ""
    without_place: str = "The evidence is in single samples; see the remarks."

    def formatted(self, value: float) -> str:
        """Return a residual as text."""
        return f"{plain(100 * value)} %" if self.percent else plain(value)


FEATURE_RESIDUAL = ResidualMeasure(
    name="mean squared standardised residual on held-out data", true_model=" A true model has about 1."
)
MOTION_RESIDUAL = ResidualMeasure(
    name="rms residual on held-out data", percent=True, of=" of the measured torque or force",
    without_place="No single place shows the remaining residual; see the remarks.",
)  # fmt: skip


def mechanism_text(name: str) -> str:
    """Return a mechanism's name without underscores."""
    return name.replace("_", " ")


def fact_text(fact: Mapping[str, Any]) -> str:
    """Return what a wrong fact of the set-up is: a number of a part by its name, else the kind and what it is of."""
    return str(fact["of"]) if fact["kind"] == "parameter" else f"{mechanism_text(fact['kind'])} of {fact['of']}"


def place_text(mismatch: Mismatch) -> str:
    """Return where a mismatch is: an order, a frequency, a position, a speed or a time."""
    at, width = plain(mismatch.at, 5), mismatch.width
    if mismatch.domain == "order" and mismatch.axis in _SHAFT:
        return f"at order {at} of the {_SHAFT[mismatch.axis]}"
    if mismatch.domain == "order":
        return f"at {at} {mismatch.axis} of the motion"
    if mismatch.domain == "frequency" and width < 0.02 * mismatch.at:
        return f"at {at} Hz"
    if mismatch.domain == "frequency":
        low = max(mismatch.at - 0.5 * width, mismatch.at**2 / (mismatch.at + 0.5 * width))
        return f"from {plain(low)} to {plain(low + width)} Hz"
    return _of_the_level(mismatch, at)


def _of_the_level(mismatch: Mismatch, at: str) -> str:
    if mismatch.axis in _STROKE:
        return f"at position {at} {mismatch.axis}"
    if mismatch.axis == "m/s":
        return f"in the mean force at {at} m/s"
    if mismatch.domain == "time":
        return f"at time {at} {mismatch.axis}"
    what = "slow torque" if mismatch.domain in ("speed", "level") else "distribution of values"
    return f"in the {what} at {at} {mismatch.axis}"


def kind_text(mismatch: Mismatch) -> str:
    """Return the kind of a mismatch: what its frequency or level depends on."""
    if mismatch.domain == "order":
        return f"periodic in the {_ANGLE.get(mismatch.axis, 'position')}"
    if mismatch.domain == "frequency":
        return "line of constant frequency" if mismatch.width < 0.02 * mismatch.at else "frequency band"
    if mismatch.axis in _STROKE:
        return "repeats at a position of the stroke"
    return {"speed": "depends on the speed", "level": "mean of a recording", "time": "transient"}.get(
        mismatch.domain, "distribution of values"
    )


def p_value_text(p_value: float) -> str:
    """Return a p-value for a table, the smallest as a bound."""
    return f"< {_SMALLEST:.0e}" if p_value < _SMALLEST else f"{p_value:.1g}"
