"""Terms that most rigs do not have; one test per evaluation skips them all. Add a new term here.

A term with a state of its own, such as the bristles, is also integrated in ``loop.py``, in arrays of ``work.py``.
"""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import floor, lookup, where
from torquerig.simulation.kernel.direction import direction
from torquerig.simulation.kernel.elementary import exponential
from torquerig.simulation.kernel.fast import FAST, UNCOUNTED


@njit(fastmath=FAST, inline="always")
def has_rare(terms):
    """Return whether a rig has any of these terms, or an imposed motion."""
    return terms.imposed.on.size + terms.bristles.on.size + terms.varied.spring.size + terms.angle_loads.on.size > 0


@njit(fastmath=FAST, inline="always")
def add_rare(
    terms, theta, omega, cosine, sine, twisted, spring_torque, bristle, bristle_slope, fastest, torque, opposing
):
    """Add the torques of all these terms; those of a stiffness that varies went into the springs before."""
    share_of_turning(terms.varied, terms.springs, cosine, sine, twisted, spring_torque, torque)
    bend(terms.bristles, omega, bristle, bristle_slope, fastest, torque, opposing)
    drag(terms.angle_loads, theta, omega, torque, opposing)


@njit(fastmath=FAST, **UNCOUNTED)
def vary(varied, springs, cosine, sine, stiffness, damping):
    """Set stiffness and damping of the springs that vary with the angle of their side b."""
    for i in range(varied.spring.size):
        spring, factor = varied.spring[i], 1.0
        for j in range(varied.first[i], varied.first[i + 1]):
            slot = varied.slot[j]
            factor += varied.c[j] * cosine[slot] - varied.s[j] * sine[slot]
        stiffness[spring] = springs.stiffness[spring] * factor
        if varied.damping_follows[i]:
            damping[spring] = springs.damping[spring] * factor


@njit(fastmath=FAST, **UNCOUNTED)
def share_of_turning(varied, springs, cosine, sine, twisted, spring_torque, torque):
    """Take ``k'(theta_b) twist^2 / 2`` from side b: the energy that its turning puts into a spring under load."""
    for i in range(varied.spring.size):
        spring, slope = varied.spring[i], 0.0
        beyond = abs(twisted[spring]) - springs.half_gap[spring]
        beyond = where(spring_torque[spring] == 0.0, 0.0, beyond)
        for j in range(varied.first[i], varied.first[i + 1]):
            slot = varied.slot[j]
            slope -= varied.order[j] * (varied.c[j] * sine[slot] + varied.s[j] * cosine[slot])
        torque[springs.b[spring]] -= 0.5 * springs.stiffness[spring] * slope * beyond * beyond


@njit(fastmath=FAST, **UNCOUNTED)
def bend(bristles, omega, bristle, bristle_slope, fastest, torque, opposing):
    """Add the bristle frictions and fill the rates at which they bend; none follows faster than ``fastest`` [1/s]."""
    for i in range(bristles.on.size):
        on, against = bristles.on[i], bristles.against[i]
        speed = omega[on] - omega[against]
        forward = speed > 0.0
        scaled = speed * bristles.inverse_stribeck[i]
        excess = where(forward, bristles.excess[i, 1], bristles.excess[i, 0])
        level = where(forward, bristles.coulomb[i, 1], bristles.coulomb[i, 0]) + excess * exponential(-scaled * scaled)
        rate = bristles.stiffness[i] * abs(speed) / level
        rate = where(rate < fastest, rate, fastest)
        end = level / bristles.stiffness[i]
        bristle_slope[i] = rate * (where(forward, end, -end) - bristle[i])
        value = bristles.stiffness[i] * bristle[i] + bristles.damping[i] * bristle_slope[i]
        value += bristles.viscous[i] * speed
        torque[on] -= value
        torque[against] += value
        opposing[on] += value


@njit(fastmath=FAST, **UNCOUNTED)
def drag(loads, theta, omega, torque, opposing):
    """Add the torques over the angle, linear between the points of their grids."""
    for i in range(loads.on.size):
        on, first = loads.on[i], loads.first[i]
        at = theta[on] * loads.points_per_radian[i]
        cell = floor(at)
        size = loads.first[i + 1] - first - 1
        point = cell - size * floor(cell / size)
        before, behind = lookup(loads.values, first, point), lookup(loads.values, first + 1, point)
        value = before + (behind - before) * (at - cell)
        value *= direction(omega[on], loads.inverse_smoothing[i])
        torque[on] -= value
        opposing[on] += value
