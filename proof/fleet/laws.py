"""Laws of a fleet rig that a model can only approximate: friction at rest, contact, load shape, controller, noise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

ALGEBRAIC, DAHL, SATURATED = range(3)
PULSES = ("triangle", "half_sine", "two_exponentials")


@dataclass(frozen=True)
class FleetLaws:
    """The laws of one rig.

    Parameters
    ----------
    friction : int
        Law of dry friction near standstill: algebraic sign, bristle (Dahl) or saturated line.
    friction_width : float
        Speed [share of the rated output speed] over which friction changes its sign.
    contact_exponent : float
        Of a tooth contact: 1 is a linear spring, 1.5 a dent as Hertz has it.
    contact_damped : bool
        Whether a closing contact is damped.
    slow_steepness : float
        Power with which the load's slow variation falls above its cut-off; 2 is a Butterworth low-pass.
    pulse : str
        Course of one particle hit.
    unsteadiness : float
        Relative change of the load's slow variation over a run (0: stationary).
    turbulence_follows_speed : bool
        Whether turbulence grows with the momentary speed squared, or stays as at the set-point.
    control_rate : float
        [Hz] of the speed controller.
    control_delay : int
        Control periods by which the command is late.
    noise_colour : float
        Coefficient of the first-order recursion of the sensor noise; 0 is white.
    """

    friction: int
    friction_width: float
    contact_exponent: float
    contact_damped: bool
    slow_steepness: float
    pulse: str
    unsteadiness: float
    turbulence_follows_speed: bool
    control_rate: float
    control_delay: int
    noise_colour: float


def draw_laws(rng: np.random.Generator) -> FleetLaws:
    """Draw the laws of one rig."""
    return FleetLaws(
        friction=int(rng.integers(3)),
        friction_width=float(10.0 ** rng.uniform(-3.0, -2.2)),
        contact_exponent=float(rng.choice([1.0, rng.uniform(1.1, 1.5)])),
        contact_damped=bool(rng.random() < 0.7),
        slow_steepness=float(rng.uniform(1.7, 2.4)),
        pulse=str(rng.choice(PULSES)),
        unsteadiness=float(rng.choice([0.0, rng.uniform(0.1, 0.5)])),
        turbulence_follows_speed=bool(rng.random() < 0.5),
        control_rate=float(rng.choice([2000.0, 4000.0, 8000.0])),
        control_delay=int(rng.integers(2)),
        noise_colour=float(rng.choice([0.0, rng.uniform(-0.15, 0.25)])),
    )
