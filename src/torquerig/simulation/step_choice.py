"""The number of integration steps per sample, from the fastest mode or the stiffest event, and its reason."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import Lowered
from torquerig.simulation.term_kinds import KINDS, Terms
from torquerig.simulation.twin.shapes import STRAINED, strain_shares

Floats = NDArray[np.float64]

STEP_ANGLE = 0.6  # [rad] largest angle that the fastest mode may turn in one Runge-Kutta step
CONTACT_ANGLE = (
    0.3  # [rad] the same where the twist is in a gap: it bounces in half a period, and 0.6 costs 1 % a bounce
)
EVENT_ANGLE = 1.5  # [rad] the same for what is over within milliseconds; at 2.3 the wear rig chatters by 6 mN m
# [rad] the same for a decay in a gap whose flanks stay together; at 1.3 one step in place of 64 changes the torque of
# the shipped study's drives by 4e-5 of its standard deviation
DECAY_ANGLE = 1.5
NO_PEAK = 0.5**0.5  # [1] damping ratio from which on a motion has no resonance: it follows its torque and does not ring
STABLE_ANGLE = 2.6  # [rad] Runge-Kutta 4 is stable to 2.785 (decay) and 2.828 (oscillation); a little is kept back
CREEPS = 3.0  # [1] speed over the smoothing of a sign, below which friction may change its direction


@dataclass(frozen=True)
class Rate:
    """How fast something in a rig can change [1/s], in words, its limit in one step [rad], and the spring it is in.

    ``together`` is the limit [rad] while the flanks of all gaps stay as they are; None: the same.
    """

    rate: float
    what: str
    allowed: float = STEP_ANGLE
    spring: str | None = None
    together: float | None = None


_NOTHING = Rate(0.0, "nothing, as the motion of every part is imposed")


@dataclass(frozen=True)
class StepChoice:
    """The steps of a run.

    Parameters
    ----------
    steps : int
        Runge-Kutta steps per sample.
    step : float
        Their length [s].
    fixed_by : Rate
        What was the fastest.
    """

    steps: int
    step: float
    fixed_by: Rate

    @property
    def angle(self) -> float:
        """What the fastest thing turns (or decays by, in time constants) in one step [rad]."""
        return self.fixed_by.rate * self.step


def step_choice(lowered: Lowered, terms: Terms, sample_rate: float) -> StepChoice:
    """Return the fewest steps per sample at which every mode and event stays within its allowed step.

    Runge-Kutta 4 is stable to 2.8 rad; at 0.6 rad its phase error is 6e-4 rad a step (x^5/120) and shrinks with the
    fourth power. Contacts of a gap are located within the step and need no shorter one. The direction of dry friction
    and of loads counts where the run's own set-point lets their shaft stand or creep, ``torque / (smoothing J)``, and
    may turn by ``EVENT_ANGLE``.
    """
    return _choice(rates(lowered, terms), sample_rate)


def step_without_impacts(lowered: Lowered, terms: Terms, sample_rate: float) -> StepChoice:
    """Return the fewest steps per sample where the flanks of a gap neither meet nor part.

    ``CONTACT_ANGLE`` is for the moment of an impact. A twist that stays on one flank is as smooth as in a spring
    without a gap: what rings may turn by ``STEP_ANGLE``, what follows its torque (``NO_PEAK``) by ``DECAY_ANGLE``.
    """
    return step_choices(lowered, terms, sample_rate)[1]


def step_choices(lowered: Lowered, terms: Terms, sample_rate: float) -> tuple[StepChoice, StepChoice]:
    """Return both: ``step_choice`` and ``step_without_impacts``."""
    found = rates(lowered, terms)
    together = [one if one.together is None else replace(one, allowed=one.together) for one in found]
    return _choice(found, sample_rate), _choice(together, sample_rate)


def _choice(found: Sequence[Rate], sample_rate: float) -> StepChoice:
    fastest = max(found, key=lambda one: one.rate / one.allowed, default=_NOTHING)
    steps = max(1, ceil(fastest.rate / sample_rate / fastest.allowed))
    return StepChoice(steps, 1 / sample_rate / steps, fastest)


def rates(lowered: Lowered, terms: Terms) -> tuple[Rate, ...]:
    """Return all modes and events that limit the step."""
    drives = [
        Rate(float(rate), f"the current lag of {name!r}")
        for name, rate in zip(lowered.drive_names, lowered.arrays.drives.inverse_lag, strict=True)
    ]
    return (*_modes(lowered), *drives, *_events(lowered, terms))


def _modes(lowered: Lowered) -> list[Rate]:
    """Return the modes of the nodes that move by their torques; an imposed node is clamped."""
    free = np.setdiff1d(np.arange(len(lowered.nodes)), _held(lowered))
    system = matrices(lowered, stiffest=True).held_at(_held(lowered)).state_matrix()
    values, vectors = np.linalg.eig(system)
    found = []
    for row in np.flatnonzero(values.imag >= 0):
        shape = np.zeros(len(lowered.nodes), dtype=np.complex128)
        shape[free] = vectors[: free.size, row]
        shares = strain_shares(
            np.abs(shape) * np.cos(np.angle(shape) - np.angle(shape[np.abs(shape).argmax()])), lowered
        )
        spring = lowered.spring_names[int(shares.argmax())] if shares.any() else None
        place = "" if spring is None else f" (twist in {spring!r})"
        rate, frequency = float(abs(values[row])), float(values[row].imag / (2 * pi))
        what = f"the mode at {frequency:.4g} Hz{place}" if frequency else f"a damped motion{place}"
        bounces = bool(shares[lowered.arrays.springs.half_gap > 0].sum() >= STRAINED)
        allowed = CONTACT_ANGLE if bounces else STEP_ANGLE
        rings = -values[row].real < NO_PEAK * rate
        together = None if not bounces else STEP_ANGLE if rings else DECAY_ANGLE
        found.append(Rate(rate, what, allowed, spring=spring if frequency else None, together=together))
    return found


def _events(lowered: Lowered, terms: Terms) -> list[Rate]:
    """Return how fast dry friction and loads stop the shafts that may stand or creep in this run.

    An imposed shaft is not stopped by what acts on it.
    """
    slowest, light = _slowest(lowered, terms), np.append(1 / lowered.inertia, 0.0)
    light[_held(lowered)] = 0.0
    found = []
    for kind in KINDS:
        for each in kind.reversals(lowered.rows_of[kind.field], getattr(terms, kind.field)):
            if max(slowest[each.on], slowest[each.against]) * each.inverse_smoothing < CREEPS:
                rate = each.torque * each.inverse_smoothing * (light[each.on] + light[each.against])
                found.append(Rate(float(rate), f"{each.what} as it changes direction", EVENT_ANGLE))
    return found


def _held(lowered: Lowered) -> NDArray[np.int64]:
    """Return the numbers of the nodes that follow an imposed motion for the whole run."""
    on = [lowered.node(term.on) for term in lowered.imposed_terms if not term.released]
    return np.array(on, dtype=np.int64)


def _slowest(lowered: Lowered, terms: Terms) -> Floats:
    """Return the least speed of each node by the set-points [rad/s]; 0 where the speed is not controlled."""
    found = np.zeros(len(lowered.nodes) + 1)
    if not lowered.drive_terms or not lowered.drive_terms[0].holds_speed:
        return found
    turns = turns_of_nodes(lowered, int(lowered.arrays.drives.on[0]))
    reference = terms.drives.reference[0]
    crosses = bool(reference.min() <= 0.0 <= reference.max())
    return found if crosses else np.abs(turns) * float(np.abs(reference).min())


def turns_of_nodes(lowered: Lowered, leader: int) -> Floats:
    """Return how fast each node turns per turn of the leader, by the springs between; 0 where none leads there."""
    turns = np.zeros(len(lowered.nodes) + 1)
    turns[leader] = 1.0
    springs = lowered.arrays.springs
    for _ in range(springs.a.size):
        for a, b, r in zip(springs.a, springs.b, springs.inverse_ratio, strict=True):
            turns[b] = turns[b] or turns[a] * r
            turns[a] = turns[a] or turns[b] / r
    return turns
