"""The true rig of a case: quantities, lines and load level, drawn around the nominal ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from proof.rig_program import nominal


@dataclass(frozen=True)
class Line:
    """One line of a whole order: ``amplitude`` [Nm] zero to peak and ``phase`` [rad] of its cosine."""

    order: int
    amplitude: float
    phase: float


@dataclass(frozen=True)
class TrueRig:
    """One real rig, drawn around the nominal or anywhere else.

    Parameters
    ----------
    quantities : dict
        Values of `nominal.QUANTITIES` [SI].
    motor_lines, wear_lines : tuple of Line
        Ripple at the motor, and at the wear part at idle.
    load_factor : float
        True mean load over nominal mean load.
    speed_error : float
        Relative error of the speed set-point, within 0.01.
    """

    quantities: dict[str, float]
    motor_lines: tuple[Line, ...]
    wear_lines: tuple[Line, ...]
    load_factor: float
    speed_error: float

    def __getitem__(self, name: str) -> float:
        """Return one quantity [SI] by its name in `nominal.QUANTITIES`."""
        return self.quantities[name]

    def mean_load(self, occupancy: float) -> float:
        """Mean torque of the bed on the wear part [Nm] at this occupancy [%], between levels on a straight line."""
        levels = np.array(nominal.LOAD_LEVELS)
        return float(np.interp(occupancy, levels[:, 0], levels[:, 1])) * self.load_factor


def draw_true_rig(rng: np.random.Generator, *, spread: float = 1.0) -> TrueRig:
    """Draw a rig around the nominal; ``spread`` 0 is the nominal itself, 2 twice as wide as the reference says."""
    quantities = {
        name: value * float(np.exp(spread * rel_sd * rng.standard_normal()))
        for name, (value, rel_sd) in nominal.QUANTITIES.items()
    }
    return TrueRig(
        quantities=quantities,
        motor_lines=_draw_lines(rng, nominal.MOTOR_LINES, spread=spread),
        wear_lines=_draw_lines(rng, nominal.WEAR_LINES, spread=spread),
        load_factor=float(np.exp(spread * nominal.MEAN_LOAD_SPREAD * rng.standard_normal())),
        speed_error=float(rng.uniform(-1.0, 1.0)) * nominal.SPEED_ERROR * min(spread, 1.0),
    )


def _draw_lines(rng: np.random.Generator, lines: dict[int, float], *, spread: float) -> tuple[Line, ...]:
    """Draw amplitudes around those given, and phases anywhere."""
    return tuple(
        Line(
            order,
            amplitude * float(np.exp(spread * nominal.LINE_SPREAD * rng.standard_normal())),
            float(rng.uniform(0.0, 2.0 * np.pi)),
        )
        for order, amplitude in lines.items()
    )
