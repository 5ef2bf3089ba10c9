"""Motions that are imposed on nodes: between samples the cubic through both angles and both speeds."""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.fast import UNCOUNTED


@njit(**UNCOUNTED)
def impose(imposed, sample, part, period, theta, omega):
    """Set angle and speed of the imposed nodes ``part`` (0..1) of a period behind ``sample``."""
    for i in range(imposed.on.size):
        if sample >= imposed.release[i]:
            continue
        first, rise = imposed.angle[i, sample], imposed.angle[i, sample + 1] - imposed.angle[i, sample]
        start, end = imposed.speed[i, sample] * period, imposed.speed[i, sample + 1] * period
        bend, twist = 3.0 * rise - 2.0 * start - end, start + end - 2.0 * rise
        theta[imposed.on[i]] = first + part * (start + part * (bend + part * twist))
        omega[imposed.on[i]] = (start + part * (2.0 * bend + part * 3.0 * twist)) / period


@njit(**UNCOUNTED)
def imposing_torque(imposed, i, sample, period, torque):
    """Return the torque that imposes the motion at the instant of ``sample`` [N m]: inertia less all other torques."""
    if sample >= imposed.release[i]:
        return 0.0
    rise = imposed.angle[i, sample + 1] - imposed.angle[i, sample]
    bend = 3.0 * rise - (2.0 * imposed.speed[i, sample] + imposed.speed[i, sample + 1]) * period
    return imposed.inertia[i] * 2.0 * bend / (period * period) - torque[imposed.on[i]]


@njit(**UNCOUNTED)
def free(imposed, sample, inverse_inertia):
    """Let the nodes go whose release is at ``sample``; hold those that are imposed from the start."""
    for i in range(imposed.on.size):
        if sample == imposed.release[i]:
            inverse_inertia[imposed.on[i]] = 1.0 / imposed.inertia[i]
        elif sample == 0:
            inverse_inertia[imposed.on[i]] = 0.0
