"""Terms that most rigs lack: one test an evaluation skips them all."""

from __future__ import annotations

import numpy as np
from numba import njit

from torquerig.simulate.kernel.direction import FAST, UNCOUNTED, direction


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
        if spring_torque[spring] == 0.0:
            continue
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
        way = 1 if speed > 0.0 else 0
        scaled = speed * bristles.inverse_stribeck[i]
        level = bristles.coulomb[i, way] + bristles.excess[i, way] * np.exp(-scaled * scaled)
        rate = min(fastest, bristles.stiffness[i] * abs(speed) / level)
        end = level / bristles.stiffness[i]
        bristle_slope[i] = rate * ((end if way else -end) - bristle[i])
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
        cell = np.floor(at)
        size = loads.first[i + 1] - first - 1
        point = first + int(cell - size * np.floor(cell / size))
        value = loads.values[point] + (loads.values[point + 1] - loads.values[point]) * (at - cell)
        value *= direction(omega[on], loads.inverse_smoothing[i])
        torque[on] -= value
        opposing[on] += value
