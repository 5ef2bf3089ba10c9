"""Laws that a model can only approximate, drawn for each case.

A proof with recordings from the model's own equations proves nothing (an inverse crime), so friction near standstill,
the contact in a gap, the shape of the load, the integrator and the sampled controller are drawn; `SAME_LAWS` are those
of the reference rig's text, with which the trials can be made as well.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from proof.rig_program import nominal


class Friction(IntEnum):
    """Law of dry friction near standstill."""

    TANH = 0
    DAHL = 1
    LUGRE = 2
    KARNOPP = 3


class Contact(IntEnum):
    """Contact law of a gap: full damping, damping proportional to the indentation, or none."""

    DAMPED = 0
    DENT_DAMPED = 1
    UNDAMPED = 2


class Integrator(IntEnum):
    """Integrator of the equations."""

    EULER = 0
    MIDPOINT = 1
    DORMAND_PRINCE = 2


class Pulse(IntEnum):
    """The course of one particle hit."""

    EXPONENTIAL = 0
    HALF_SINE = 1


class SlowFilter(IntEnum):
    """Filter that makes the slow variation of the load from white noise."""

    BUTTERWORTH = 0
    TWO_POLES = 1
    GAUSSIAN = 2


@dataclass(frozen=True)
class Laws:
    """The laws of one case.

    Parameters
    ----------
    friction_width : float
        [rad/s] of the tanh and of Karnopp's band, [rad] of presliding for Dahl and LuGre.
    contact_exponent : float
        1 for a spring, up to 1.5 for a dent as Hertz has it.
    steps : int
        Integration steps in a sample of 40 microseconds.
    tustin, delay : bool, int
        The PI controller's rule (else backward Euler), and the samples its command comes late (0 or 1).
    fourth_mass : tuple of float or None
        A weak mass that nobody modelled: share of the wear part's inertia, frequency [Hz], damping ratio.
    gain_error : float
        Of the sensor, relative.
    noise_colour : float
        Coefficient of the first-order recursion that colours the noise; 0 is white.
    """

    friction: Friction
    friction_width: float
    contact: Contact
    contact_exponent: float
    pulse: Pulse
    hit_shape: float
    slow_filter: SlowFilter
    integrator: Integrator
    steps: int
    tustin: bool
    delay: int
    fourth_mass: tuple[float, float, float] | None
    gain_error: float
    noise_colour: float


SAME_LAWS = Laws(
    friction=Friction.TANH,
    friction_width=nominal.FRICTION_WIDTH,
    contact=Contact.DAMPED,
    contact_exponent=1.0,
    pulse=Pulse.EXPONENTIAL,
    hit_shape=1.5,
    slow_filter=SlowFilter.BUTTERWORTH,
    integrator=Integrator.MIDPOINT,
    steps=6,
    tustin=False,
    delay=0,
    fourth_mass=None,
    gain_error=0.0,
    noise_colour=0.0,
)


def draw_laws(rng: np.random.Generator) -> Laws:
    """Draw the laws of one case."""
    friction = Friction(int(rng.integers(len(Friction))))
    integrator = Integrator(int(rng.integers(len(Integrator))))
    return Laws(
        friction=friction,
        friction_width=_friction_width(rng, friction),
        contact=Contact(int(rng.integers(len(Contact)))),
        contact_exponent=float(rng.choice([1.0, rng.uniform(1.1, 1.5)])),
        pulse=Pulse(int(rng.integers(len(Pulse)))),
        hit_shape=float(rng.uniform(1.0, 3.0)),
        slow_filter=SlowFilter(int(rng.integers(len(SlowFilter)))),
        integrator=integrator,
        steps=_steps(rng, integrator),
        tustin=bool(rng.integers(2)),
        delay=int(rng.integers(2)),
        fourth_mass=_fourth_mass(rng),
        gain_error=0.015 * float(rng.standard_normal()),
        noise_colour=float(rng.uniform(-0.2, 0.3)),
    )


def _friction_width(rng: np.random.Generator, friction: Friction) -> float:
    """Draw the width of the law near standstill in the law's own unit."""
    if friction in (Friction.DAHL, Friction.LUGRE):
        return float(10.0 ** rng.uniform(-3.4, -2.7))
    return float(rng.uniform(0.01, 0.05))


def _steps(rng: np.random.Generator, integrator: Integrator) -> int:
    """Draw the steps in a sample: Euler at eight, the others between 5 and 10 microseconds."""
    if integrator is Integrator.EULER:
        return 8
    if integrator is Integrator.MIDPOINT:
        return int(rng.integers(5, 9))
    return 4


def _fourth_mass(rng: np.random.Generator) -> tuple[float, float, float] | None:
    """Draw a small additional mass, or none."""
    if rng.random() < 0.5:
        return None
    return float(rng.uniform(0.002, 0.01)), float(rng.uniform(300.0, 1200.0)), float(rng.uniform(0.05, 0.15))
