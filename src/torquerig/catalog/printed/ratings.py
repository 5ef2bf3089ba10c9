"""Rated torque from power, and from an intermittent (S3) rating; inertia from the flywheel effect GD^2."""

from __future__ import annotations

from math import sqrt

from torquerig.catalog.printed.converted import Converted
from torquerig.catalog.printed.figure import Figure

DUTY_TOLERANCE = 0.05  # [1] printed ratings have two or three digits


def continuous(
    field: str, unit: str, figure: Figure, printed: tuple[float, float], *, key: str, said: str
) -> Converted:
    """Return ``rated_torque`` or ``rated_power`` (S1) from what is printed for S1 or S3.

    Copper losses go with the square of the torque: in cycles that are short against the thermal time constant, an S3
    torque T of duty d heats like T sqrt(d). In long cycles the S1 torque is nearer to T. The range is T sqrt(d)..T.
    """
    kind, share = figure.duty
    if kind == "S1":
        return Converted(field, *printed, unit, said, key)
    words = f"{said}, times sqrt({share:g}) (short cycles) to 1 (long cycles)"
    return Converted(field, printed[0] * sqrt(share), printed[1], unit, words, key)


def torque_from_power(figure: Figure, speed: tuple[float, float]) -> tuple[float, float]:
    """Return the torque [N m] of a printed power at the rated speed [rad/s]."""
    low, high = figure.quantity("W")
    return low / speed[1], high / speed[0]


def duty_contradiction(figure: Figure, continuous: tuple[float, float]) -> str:
    """Return what is wrong with an S3 torque next to the S1 torque [N m]; empty where nothing is."""
    low, high = figure.quantity("N*m")
    share = figure.duty[1]
    least, most = continuous[0], continuous[1] / sqrt(share)
    if high >= least * (1 - DUTY_TOLERANCE) and low <= most * (1 + DUTY_TOLERANCE):
        return ""
    return (
        f"{figure.text} contradicts the S1 torque {continuous[0]:.3g} N*m: a duty of {share:.0%} allows "
        f"{least:.3g}..{most:.3g} N*m (S1 torque / sqrt(duty)); correct one of them"
    )


def inertia_from_flywheel_effect(figure: Figure) -> Converted:
    """Return ``rotor_inertia`` = GD^2 / 4: D is twice the radius of gyration, G the mass (in kgf the same number)."""
    text = figure.low, figure.high
    ends = [
        Figure(figure.text, one.replace("kgf", "kg"), one.replace("kgf", "kg")).quantity("kg*m^2")[0] for one in text
    ]
    return Converted(
        "rotor_inertia", ends[0] * (1 - figure.spread) / 4, ends[1] * (1 + figure.spread) / 4, "kg*m^2",
        f"GD^2 {figure.text}, divided by 4", "flywheel_effect",
    )  # fmt: skip
