"""The compiled loop: any rig, lowered to flat arrays, through time by Runge-Kutta 4 with fixed substeps.

Self-contained on purpose: numba's cache on disk goes stale when a callee in another file changes.
Nodes are numbered; the last index is the ground, whose angle and speed stay zero and whose torque is thrown away.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Rows = NDArray[np.uint64]  # unsigned: a signed index costs a test for counting from the end, a sixth of the run time
Starts = NDArray[np.int64]

FAST = {"contract", "reassoc", "arcp", "nsz", "afn"}  # not nnan and ninf: a run that blows up must be seen

# what an output row holds: the torque of a spring; speed, angle of a node; torque of a drive; all that opposes a node
SPRING_TORQUE, SPEED, ANGLE, DRIVE_TORQUE, OPPOSING_TORQUE = range(5)


class Waves(NamedTuple):
    """Cosines and sines of order times angle, each made once a step: bases by sincos, the others by products."""

    base_node: Rows  # (bases,) node whose angle is taken
    base_order: Floats  # (bases,)
    first: Rows  # (products,) slot number bases + i is the product of two earlier slots
    second: Rows


class Springs(NamedTuple):
    """Springs, dampers, gaps, gears; ``e`` rows are the kinematic error's waves."""

    a: Rows
    b: Rows
    stiffness: Floats
    damping: Floats
    half_gap: Floats
    inverse_ratio: Floats
    loss_mean: Floats  # (1/eta + eta) / 2
    loss_half: Floats  # (1/eta - eta) / 2
    e_first: Starts  # (springs + 1,) where each spring's error waves start
    e_slot: Rows
    e_order: Floats
    e_cos: Floats
    e_sin: Floats


class Harmonics(NamedTuple):
    """Torques ``cos * c - sin * s`` of a slot, on a node and against another."""

    on: Rows
    against: Rows
    slot: Rows
    c: Floats
    s: Floats


class Frictions(NamedTuple):
    """Coulomb and static torque by direction: column 0 backward, column 1 forward."""

    on: Rows
    against: Rows
    coulomb: Floats  # (frictions, 2)
    excess: Floats  # (frictions, 2): static minus Coulomb
    inverse_stribeck: Floats
    viscous: Floats
    quadratic: Floats
    inverse_smoothing: Floats


class Loads(NamedTuple):
    """Sampled torques, linear between samples: they oppose a node's motion, or drive it where the smoothing is 0."""

    on: Rows
    inverse_smoothing: Floats
    samples: Floats  # (loads, settling + samples + 1)


class Blades(NamedTuple):
    """Half-wave-squared load pulses from a slot."""

    on: Rows
    slot: Rows
    c: Floats
    s: Floats
    amplitude: Floats
    inverse_smoothing: Floats


class Drives(NamedTuple):
    """Speed-controlled motors; ``reference`` holds the set-point at every sample."""

    on: Rows
    against: Rows
    kp: Floats
    ki: Floats
    limit: Floats
    inverse_lag: Floats
    r_first: Starts
    r_slot: Rows
    r_c: Floats
    r_s: Floats
    reference: Floats  # (drives, settling + samples + 1)


class Outputs(NamedTuple):
    """What to keep at every sample."""

    kind: Rows
    row: Rows


@njit(cache=True, nogil=True, fastmath=FAST, inline="always")
def _direction(speed: float, inverse_smoothing: float) -> float:
    scaled = speed * inverse_smoothing
    if scaled > 20.0:
        return 1.0
    if scaled < -20.0:
        return -1.0
    return np.tanh(scaled)


@njit(cache=True, nogil=True, fastmath=FAST, inline="always")
def _forces(
    theta,
    omega,
    tau,
    load_now,
    waves,
    springs,
    harmonics,
    frictions,
    loads,
    blades,
    drives,
    cosine,
    sine,
    spring_torque,
    opposing,
    torque,
):
    """Fill ``torque`` (per node) and the by-products of one evaluation."""
    torque[:] = 0.0
    opposing[:] = 0.0
    for i in range(waves.base_node.size):
        angle = waves.base_order[i] * theta[waves.base_node[i]]
        cosine[i] = np.cos(angle)
        sine[i] = np.sin(angle)
    for i in range(waves.first.size):
        to, p, q = i + waves.base_node.size, waves.first[i], waves.second[i]
        cosine[to] = cosine[p] * cosine[q] - sine[p] * sine[q]
        sine[to] = sine[p] * cosine[q] + cosine[p] * sine[q]
    for i in range(harmonics.on.size):
        slot = harmonics.slot[i]
        value = harmonics.c[i] * cosine[slot] - harmonics.s[i] * sine[slot]
        torque[harmonics.on[i]] += value
        torque[harmonics.against[i]] -= value
    for i in range(springs.a.size):
        a, b, r = springs.a[i], springs.b[i], springs.inverse_ratio[i]
        twist = theta[a] * r - theta[b]
        rate = omega[a] * r - omega[b]
        for j in range(springs.e_first[i], springs.e_first[i + 1]):
            slot = springs.e_slot[j]
            twist += springs.e_cos[j] * cosine[slot] - springs.e_sin[j] * sine[slot]
            slope = springs.e_cos[j] * sine[slot] + springs.e_sin[j] * cosine[slot]
            rate -= springs.e_order[j] * slope * omega[b]
        half = springs.half_gap[i]
        if half > 0.0:
            value = 0.0
            if twist > half:
                pressed = springs.stiffness[i] * (twist - half)
                value = max(0.0, pressed + min(pressed, springs.damping[i] * rate))
            elif twist < -half:
                pressed = springs.stiffness[i] * (twist + half)
                value = min(0.0, pressed + max(pressed, springs.damping[i] * rate))
        else:
            value = springs.stiffness[i] * twist + springs.damping[i] * rate
        spring_torque[i] = value
        torque[b] += value
        back = value * r
        if springs.loss_half[i] != 0.0:
            flow = _direction(omega[b], 50.0) if value > 0.0 else -_direction(omega[b], 50.0)
            back *= springs.loss_mean[i] + springs.loss_half[i] * flow
        torque[a] -= back
    for i in range(frictions.on.size):
        speed = omega[frictions.on[i]] - omega[frictions.against[i]]
        value = frictions.viscous[i] * speed + frictions.quadratic[i] * speed * abs(speed)
        way = 1 if speed > 0.0 else 0
        grip = frictions.coulomb[i, way]
        if frictions.excess[i, way] != 0.0:
            scaled = speed * frictions.inverse_stribeck[i]
            if abs(scaled) < 6.0:
                grip += frictions.excess[i, way] * np.exp(-scaled * scaled)
        if grip != 0.0:
            value += grip * _direction(speed, frictions.inverse_smoothing[i])
        torque[frictions.on[i]] -= value
        torque[frictions.against[i]] += value
        opposing[frictions.on[i]] += value
    for i in range(loads.on.size):
        on = loads.on[i]
        if loads.inverse_smoothing[i] == 0.0:
            torque[on] += load_now[i]
            continue
        value = load_now[i] * _direction(omega[on], loads.inverse_smoothing[i])
        torque[on] -= value
        opposing[on] += value
    for i in range(blades.on.size):
        on, slot = blades.on[i], blades.slot[i]
        wave = blades.c[i] * cosine[slot] - blades.s[i] * sine[slot]
        if wave > 0.0:
            value = blades.amplitude[i] * wave * wave * _direction(omega[on], blades.inverse_smoothing[i])
            torque[on] -= value
            opposing[on] += value
    for i in range(drives.on.size):
        factor = 1.0
        for j in range(drives.r_first[i], drives.r_first[i + 1]):
            slot = drives.r_slot[j]
            factor += drives.r_c[j] * cosine[slot] - drives.r_s[j] * sine[slot]
        value = tau[i] * factor
        torque[drives.on[i]] += value
        torque[drives.against[i]] -= value


@njit(cache=True, nogil=True, fastmath=FAST)
def integrate(
    theta,
    omega,
    inverse_inertia,
    waves,
    springs,
    harmonics,
    frictions,
    loads,
    blades,
    drives,
    outputs,
    rate,
    settling,
    substeps,
    kept,
):
    """Step the rig through ``settling`` samples that are not kept and ``kept.shape[1]`` that are.

    Parameters
    ----------
    theta, omega : ndarray, shape (nodes + 1,)
        Start angles [rad] and speeds [rad/s]; changed in place to the end state; the ground is last.
    inverse_inertia : ndarray, shape (nodes + 1,)
        [1/(kg m^2)], zero for the ground.
    rate : float
        Samples and control steps per second [Hz].
    kept : ndarray, shape (outputs, samples)
        Filled with the outputs at the instant of each sample.

    Returns
    -------
    failed_sample, failed_node : int
        -1, -1 when the run went through; else where a speed ceased to be finite (sample counted from the start of
        settling).
    """
    nodes = theta.size
    n_drives = drives.on.size
    tau = np.zeros(n_drives)
    integral = np.zeros(n_drives)
    command = np.zeros(n_drives)
    slots = waves.base_node.size + waves.first.size
    cosine, sine = np.zeros(slots), np.zeros(slots)
    spring_torque = np.zeros(springs.a.size)
    opposing, torque = np.zeros(nodes), np.zeros(nodes)
    load_now = np.zeros(loads.on.size)
    theta_k, omega_k, tau_k = np.zeros(nodes), np.zeros(nodes), np.zeros(n_drives)
    theta_sum, omega_sum, tau_sum = np.zeros(nodes), np.zeros(nodes), np.zeros(n_drives)
    period = 1.0 / rate
    h = period / substeps
    fraction = 1.0 / substeps
    moving = nodes - 1  # all but the ground
    samples = kept.shape[1]
    for sample in range(settling + samples):
        for i in range(n_drives):
            error = drives.reference[i, sample] - omega[drives.on[i]] + omega[drives.against[i]]
            wish = drives.kp[i] * error + drives.ki[i] * (integral[i] + error * period)
            if abs(wish) <= drives.limit[i]:
                integral[i] += error * period
                command[i] = wish
            else:
                command[i] = drives.limit[i] if wish > 0.0 else -drives.limit[i]
        for step in range(substeps):
            for i in range(moving):
                theta_k[i], omega_k[i] = theta[i], omega[i]
                theta_sum[i], omega_sum[i] = 0.0, 0.0
            for i in range(n_drives):
                tau_k[i], tau_sum[i] = tau[i], 0.0
            for stage in range(4):
                part = (step + (0.0 if stage == 0 else (1.0 if stage == 3 else 0.5))) * fraction
                for i in range(loads.on.size):
                    u = loads.samples[i, sample]
                    load_now[i] = u + (loads.samples[i, sample + 1] - u) * part
                _forces(
                    theta_k, omega_k, tau_k, load_now, waves, springs, harmonics, frictions, loads, blades, drives,
                    cosine, sine, spring_torque, opposing, torque,
                )  # fmt: skip
                if stage == 0 and step == 0 and sample >= settling:
                    for i in range(outputs.kind.size):
                        kind, row = outputs.kind[i], outputs.row[i]
                        if kind == SPRING_TORQUE:
                            kept[i, sample - settling] = spring_torque[row]
                        elif kind == SPEED:
                            kept[i, sample - settling] = omega[row]
                        elif kind == ANGLE:
                            kept[i, sample - settling] = theta[row]
                        elif kind == DRIVE_TORQUE:
                            kept[i, sample - settling] = tau[row]
                        else:
                            kept[i, sample - settling] = opposing[row]
                weight = h / 3.0 if 0 < stage < 3 else h / 6.0
                ahead = h if stage == 2 else 0.5 * h
                for i in range(moving):
                    slope = torque[i] * inverse_inertia[i]
                    theta_sum[i] += weight * omega_k[i]
                    omega_sum[i] += weight * slope
                    theta_k[i] = theta[i] + ahead * omega_k[i]
                    omega_k[i] = omega[i] + ahead * slope
                for i in range(n_drives):
                    slope = (command[i] - tau_k[i]) * drives.inverse_lag[i]
                    tau_sum[i] += weight * slope
                    tau_k[i] = tau[i] + ahead * slope
            for i in range(moving):
                theta[i] += theta_sum[i]
                omega[i] += omega_sum[i]
            for i in range(n_drives):
                tau[i] += tau_sum[i]
        for i in range(moving):
            if not np.isfinite(omega[i]):
                return sample, i
    return -1, -1
