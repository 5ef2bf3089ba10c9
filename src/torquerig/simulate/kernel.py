"""The compiled loop: any rig, lowered to flat arrays, through time by Runge-Kutta 4 with fixed substeps.

Self-contained on purpose: numba's cache on disk goes stale when a callee in another file changes. The arrays are those
of ``simulate/arrays.py``.

Between two kinks of a contact law the right-hand side is smooth and the method has its fourth order; a step that would
cross a kink (flanks meet or part, damping reaches the spring's torque) is shortened until it ends just behind it.
"""

from __future__ import annotations

import numpy as np
from numba import njit

FAST = {"contract", "reassoc", "arcp", "nsz", "afn"}  # not nnan and ninf: a run that blows up must be seen

# what an output row holds: the torque of a spring; speed, angle of a node; torque of a drive; all that opposes a node
SPRING_TORQUE, SPEED, ANGLE, DRIVE_TORQUE, OPPOSING_TORQUE = range(5)

LOCATED = 2.0**-22  # [1] share of a substep within which a kink is located


@njit(cache=True, nogil=True, fastmath=FAST, inline="always")
def _direction(speed: float, inverse_smoothing: float) -> float:
    scaled = speed * inverse_smoothing
    if scaled > 20.0:
        return 1.0
    if scaled < -20.0:
        return -1.0
    return np.tanh(scaled)


@njit(cache=True, nogil=True, fastmath=FAST, inline="always")
def _forces(theta, omega, tau, load_now, terms, cosine, sine, spring_torque, contact, opposing, torque):
    """Fill ``torque`` (per node) and the by-products of one evaluation."""
    waves, springs, harmonics, frictions = terms.waves, terms.springs, terms.harmonics, terms.frictions
    loads, blades, drives = terms.loads, terms.blades, terms.drives
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
            side = 1.0 if twist > 0.0 else -1.0
            pressed = springs.stiffness[i] * (side * twist - half)
            damped = side * springs.damping[i] * rate
            if pressed <= 0.0:
                value, contact[i] = 0.0, 0.0
            elif damped > pressed:
                value, contact[i] = side * 2.0 * pressed, side
            elif damped > -pressed:
                value, contact[i] = side * (pressed + damped), 2.0 * side
            else:
                value, contact[i] = 0.0, 3.0 * side
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


@njit(cache=True, nogil=True, inline="always")
def _keep(kept, at, outputs, theta, omega, tau, spring_torque, opposing):
    for i in range(outputs.kind.size):
        kind, row = outputs.kind[i], outputs.row[i]
        if kind == SPRING_TORQUE:
            kept[i, at] = spring_torque[row]
        elif kind == SPEED:
            kept[i, at] = omega[row]
        elif kind == ANGLE:
            kept[i, at] = theta[row]
        elif kind == DRIVE_TORQUE:
            kept[i, at] = tau[row]
        else:
            kept[i, at] = opposing[row]


@njit(cache=True, nogil=True, fastmath=FAST)
def integrate(theta, omega, terms, outputs, rate, settling, substeps, kept):
    """Step the rig through ``settling`` samples that are not kept and ``kept.shape[1]`` that are.

    Parameters
    ----------
    theta, omega : ndarray, shape (nodes + 1,)
        Start angles [rad] and speeds [rad/s]; changed in place to the end state; the ground is last.
    terms : Terms
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
    drives, loads = terms.drives, terms.loads
    nodes, n_drives, n_springs = theta.size, drives.on.size, terms.springs.a.size
    moving = nodes - 1  # all but the ground
    slots = terms.waves.base_node.size + terms.waves.first.size
    cosine, sine = np.zeros(slots), np.zeros(slots)
    spring_torque, contact, contact_before = np.zeros(n_springs), np.zeros(n_springs), np.zeros(n_springs)
    opposing, torque, torque_before = np.zeros(nodes), np.zeros(nodes), np.zeros(nodes)
    tau, integral, command = np.zeros(n_drives), np.zeros(n_drives), np.zeros(n_drives)
    theta_k, omega_k, tau_k = np.zeros(nodes), np.zeros(nodes), np.zeros(n_drives)
    theta_sum, omega_sum, tau_sum = np.zeros(nodes), np.zeros(nodes), np.zeros(n_drives)
    load_now = np.zeros(loads.on.size)
    gaps = np.flatnonzero(terms.springs.half_gap > 0.0)
    period = 1.0 / rate
    h = period / substeps
    for sample in range(settling + kept.shape[1]):
        for i in range(n_drives):
            error = drives.reference[i, sample] - omega[drives.on[i]] + omega[drives.against[i]]
            wish = drives.kp[i] * error + drives.ki[i] * (integral[i] + error * period)
            if abs(wish) <= drives.limit[i]:
                integral[i] += error * period
                command[i] = wish
            else:
                command[i] = drives.limit[i] if wish > 0.0 else -drives.limit[i]
        # the very first pass has no length: it makes the forces at the start; later ones are left by the step before
        for step in range(-1 if sample == 0 else 0, substeps):
            if step == 0 and sample >= settling:
                _keep(kept, sample - settling, outputs, theta, omega, tau, spring_torque, opposing)
            start, remaining = max(0, step) * h, 0.0 if step < 0 else h
            unfinished = True
            while unfinished:
                low, high, length, accepted = 0.0, remaining, remaining, step < 0
                whole = True
                while True:
                    for i in range(moving):
                        slope = torque_before[i] * terms.inverse_inertia[i]
                        theta_sum[i], omega_sum[i] = length / 6.0 * omega[i], length / 6.0 * slope
                        theta_k[i] = theta[i] + 0.5 * length * omega[i]
                        omega_k[i] = omega[i] + 0.5 * length * slope
                    for i in range(n_drives):
                        slope = (command[i] - tau[i]) * drives.inverse_lag[i]
                        tau_sum[i], tau_k[i] = length / 6.0 * slope, tau[i] + 0.5 * length * slope
                    for stage in range(3 if step < 0 else 0, 4):
                        ahead = 0.5 * length if stage < 2 else length
                        if stage == 3:
                            for i in range(moving):
                                theta_k[i], omega_k[i] = theta[i] + theta_sum[i], omega[i] + omega_sum[i]
                            for i in range(n_drives):
                                tau_k[i] = tau[i] + tau_sum[i]
                        part = (start + ahead) * rate
                        for i in range(loads.on.size):
                            u = loads.samples[i, sample]
                            load_now[i] = u + (loads.samples[i, sample + 1] - u) * part
                        _forces(theta_k, omega_k, tau_k, load_now, terms, cosine, sine, spring_torque, contact,
                                opposing, torque)  # fmt: skip
                        if stage == 3:
                            break
                        weight = length / 6.0 if stage == 2 else length / 3.0
                        ahead = 0.5 * length if stage == 0 else length
                        for i in range(moving):
                            slope = torque[i] * terms.inverse_inertia[i]
                            theta_sum[i] += weight * omega_k[i]
                            omega_sum[i] += weight * slope
                            theta_k[i] = theta[i] + ahead * omega_k[i]
                            omega_k[i] = omega[i] + ahead * slope
                        for i in range(n_drives):
                            slope = (command[i] - tau_k[i]) * drives.inverse_lag[i]
                            tau_sum[i] += weight * slope
                            tau_k[i] = tau[i] + ahead * slope
                    if accepted:
                        break
                    kinked = False
                    for gap in gaps:
                        kinked = kinked or contact[gap] != contact_before[gap]
                    if whole and not kinked:
                        break
                    whole = False
                    if kinked:
                        high = length
                    else:
                        low = length
                    accepted = high - low <= LOCATED * h
                    length = high if accepted else 0.5 * (low + high)
                for i in range(moving):
                    theta[i], omega[i], torque_before[i] = theta_k[i], omega_k[i], torque[i]
                for i in range(n_drives):
                    tau[i] = tau_k[i]
                for gap in gaps:
                    contact_before[gap] = contact[gap]
                start += length
                remaining -= length
                unfinished = remaining > LOCATED * h
        for i in range(moving):
            if not np.isfinite(omega[i]):
                return sample, i
    return -1, -1
