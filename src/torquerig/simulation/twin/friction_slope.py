"""Friction about a steady speed: its torque, its slope, and the part that a linear model leaves out."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered

Floats = NDArray[np.float64]

TURNING, IN_A_LINE = ("rad/s", "N m", "N m s/rad"), ("m/s", "N", "N s/m")
STILL = 1e-9  # [rad/s] slower than this, a shaft stands


class Sliding(NamedTuple):
    """Frictions and, behind them, bristle frictions, as rows of one kind: between what they act, and how."""

    on: NDArray[np.uint64]
    against: NDArray[np.uint64]
    viscous: Floats
    backward_extra: Floats
    quadratic: Floats
    coulomb: Floats  # (rows, 2): backward, forward
    excess: Floats
    inverse_stribeck: Floats
    inverse_smoothing: Floats  # infinite for bristles: while they slide, their sign has no width


def sliding(lowered: Lowered) -> Sliding:
    """Return all dry and viscous friction of a rig."""
    frictions, bristles = lowered.arrays.frictions, lowered.arrays.bristles
    none = np.zeros(bristles.on.size)
    return Sliding(
        on=np.concatenate([frictions.on, bristles.on]),
        against=np.concatenate([frictions.against, bristles.against]),
        viscous=np.concatenate([frictions.viscous, bristles.viscous]),
        backward_extra=np.concatenate([frictions.backward_extra, none]),
        quadratic=np.concatenate([frictions.quadratic, none]),
        coulomb=np.concatenate([frictions.coulomb, bristles.coulomb]),
        excess=np.concatenate([frictions.excess, bristles.excess]),
        inverse_stribeck=np.concatenate([frictions.inverse_stribeck, bristles.inverse_stribeck]),
        inverse_smoothing=np.concatenate([frictions.inverse_smoothing, none + np.inf]),
    )


def friction_at(lowered: Lowered, speeds: Floats) -> tuple[Floats, Floats, tuple[str, ...]]:
    """Return torque and slope of each row of ``sliding`` at its relative speed, and what was left out of it."""
    frictions = sliding(lowered)
    torques, slopes, notes = np.zeros(frictions.on.size), np.zeros(frictions.on.size), []
    for row, (on, against) in enumerate(zip(frictions.on, frictions.against, strict=True)):
        speed = float(speeds[on] - speeds[against])
        viscous, quadratic = frictions.viscous[row], frictions.quadratic[row]
        viscous += frictions.backward_extra[row] if speed < 0 else 0.0
        torques[row] = viscous * speed + quadratic * speed * abs(speed)
        slopes[row] = viscous + 2 * quadratic * abs(speed)
        grip, excess = (values[row, 1 if speed > 0 else 0] for values in (frictions.coulomb, frictions.excess))
        if not (grip or excess):
            continue
        if abs(speed) < STILL:
            if on != len(lowered.nodes):
                still = "stands still" if lowered.nodes[on] in lowered.in_a_line else "does not turn"
                notes.append(f"the dry friction on {lowered.nodes[on]!r}, which {still}")
            continue
        torque, slope = dry_friction(
            speed, grip=grip, excess=excess, inverse_stribeck=frictions.inverse_stribeck[row],
            inverse_smoothing=frictions.inverse_smoothing[row],
        )  # fmt: skip
        torques[row] += torque
        slopes[row] += slope
        rate, effort, slope_unit = IN_A_LINE if lowered.nodes[on] in lowered.in_a_line else TURNING
        notes.append(f"the dry friction on {lowered.nodes[on]!r} away from {speed:.4g} {rate}: there it is "
                    f"{torques[row]:.4g} {effort} with a slope of {slopes[row]:.3g} {slope_unit}")  # fmt: skip
    if lowered.arrays.bristles.on.size:
        notes.append("the bending of bristles: they slide steadily")
    return torques, slopes, tuple(notes)


def dry_friction(
    speed: float, *, grip: float, excess: float, inverse_stribeck: float, inverse_smoothing: float
) -> tuple[float, float]:
    """Return ``(grip + excess exp(-(w/ws)^2)) tanh(w / smoothing)`` [N m] and its derivative [N m s/rad] at a speed."""
    bell = float(np.exp(-((speed * inverse_stribeck) ** 2)))
    turn = float(np.tanh(speed * inverse_smoothing))
    held = grip + excess * bell
    across = held * (1 - turn**2) * inverse_smoothing if np.isfinite(inverse_smoothing) else 0.0
    falling = -2 * excess * bell * speed * inverse_stribeck**2 * turn
    return held * turn, across + falling
