"""The compiled loop: six masses in a row and two branches, a sampled speed controller, explicit rules to step.

The state y holds angles (0-5) and speeds (6-11) of the masses in output coordinates, the motor's torque (12), the
bristle of dry friction (13), the amplifier's output and slope (14, 15) and a bearing's local mode (16, 17).
"""

from __future__ import annotations

import numpy as np
from numba import njit

STATES = 18
_FAST = {"reassoc", "contract", "nsz", "arcp"}


@njit(fastmath=_FAST, error_model="numpy", inline="always")
def _look_up(table, angle):
    """Return a table's value at an angle [rad], on the straight line between its points."""
    size = table.size
    if size == 1:
        return table[0]
    place = angle * (size / (2.0 * np.pi))
    below = np.floor(place)
    i = int(below) & (size - 1)
    return table[i] + (place - below) * (table[(i + 1) & (size - 1)] - table[i])


@njit(fastmath=_FAST, error_model="numpy", inline="always")
def _soft_sign(x):
    """Return tanh, without evaluation where it is 1 to the last bit."""
    if x > 20.0:
        return 1.0
    if x < -20.0:
        return -1.0
    return np.tanh(x)


@njit(cache=True, fastmath=_FAST, error_model="numpy")
def _flank(dent, rate, stiffness, damping, law, exponent, torque):
    """Torque of a flank that is pressed in by ``dent`` > 0 [rad]; it never pulls."""
    force = stiffness * dent if exponent == 1.0 else torque * (dent * stiffness / (exponent * torque)) ** exponent
    if law == 0:
        force += damping * rate
    elif law == 1:
        force += damping * rate * min(dent * stiffness / torque, 1.0)
    return max(force, 0.0)


@njit(cache=True, nogil=True, fastmath=_FAST, error_model="numpy")
def run_machine(m, y, forcing, rule, steps, sample_rate):
    """Run the machine from state ``y`` (changed) and return its outputs (n, 3).

    ``forcing`` is a tuple of arrays over the samples: motor set-point [rad/s], load [Nm], push on the wear part [Nm],
    the coupling's limit [Nm] and the phase [rad] of the line of no whole order; each is held over its sample.
    ``rule`` is an explicit Runge-Kutta rule: weights of earlier stages (s, s) and of all at the end (s,); one stage is
    the semi-implicit Euler rule, which steps speeds first and angles with the new speeds.
    Outputs are the amplifier's [Nm], the motor's angle [rad] and the wear part's speed [rad/s] at each sample.
    """
    set_point, loads, pushes, caps, phases = forcing
    earlier_weights, weights = rule
    # unpacked once: access in the loop would cost more than the equations
    ratio, loss = m.ratio, m.loss
    j0, j1, j2, j3, j4, j5 = (m.inertia[0], m.inertia[1], m.inertia[2], m.inertia[3], m.inertia[4], m.inertia[5])
    motor_viscous, motor_coulomb, motor_width = m.motor_viscous, m.motor_coulomb, m.motor_coulomb_width
    gear_k, gear_c, half_gap = m.gear_stiffness, m.gear_damping, m.half_gap
    contact, exponent, contact_torque = m.contact, m.contact_exponent, m.contact_torque
    sensor_k, sensor_c, cubic = m.sensor_stiffness, m.sensor_damping, m.sensor_cubic
    joint_k, joint_c = m.coupling_stiffness, m.coupling_damping
    k4, k5, c4, c5 = m.branch_stiffness[0], m.branch_stiffness[1], m.branch_damping[0], m.branch_damping[1]
    wear_viscous, drag = m.wear_viscous, m.drag
    dry, friction, width = m.dry, m.friction, m.friction_width
    motor_table, drive_table, wear_table, blade_table = m.motor_table, m.drive_table, m.wear_table, m.blade_table
    twist_table, twist_slope = m.twist_table, m.twist_slope
    amplifier, amplifier_damping = m.amplifier, m.amplifier_damping
    ring_w, ring_damping, ring_node = m.ring, m.ring_damping, m.ring_node
    impact_travel, impact_size = m.impact_travel, m.impact_size
    line_order, line_torque = m.line_order, m.line_torque
    kp, ki, limit, lag, tustin, delay = m.kp, m.ki, m.limit, m.lag, m.tustin, m.delay

    n, stages = set_point.size, weights.size
    out = np.empty((n, 3))
    k, t = np.zeros((stages, STATES)), np.zeros(STATES)
    h = 1.0 / (sample_rate * steps)
    held, before, command, waiting = y[12], 0.0, y[12], y[12]
    slip, travel, impact = 0.0, 0.0, 0
    for i in range(n):
        out[i, 0], out[i, 1], out[i, 2] = y[14], y[0] * ratio, y[9]
        error = set_point[i] - y[6] * ratio
        gain = ki / sample_rate * (0.5 * (error + before) if tustin else error)
        before = error
        wanted = kp * error + held + gain
        if abs(wanted) <= limit:
            held += gain
        wanted = min(max(wanted, -limit), limit)
        command = waiting if delay == 1 else wanted
        waiting = wanted
        if impact_travel.size > 0:
            travel += abs(y[7]) / sample_rate
            while impact < impact_travel.size and travel >= impact_travel[impact]:
                if ring_node == 1:  # a torque that sets in at its peak: no push that would ring the whole line
                    y[16] += impact_size[impact]
                else:
                    y[17] += impact_size[impact] * ring_w
                impact += 1
        load, push, cap = loads[i], pushes[i], caps[i]
        if line_torque != 0.0:
            push += line_torque * np.cos(line_order * y[3] + phases[i])
        elastic = joint_k * (y[2] - y[3] - slip)
        if abs(elastic) > cap:
            slip = y[2] - y[3] - np.sign(elastic) * cap / joint_k
        for _ in range(steps):
            for stage in range(stages):
                for j in range(STATES):
                    t[j] = y[j]
                for earlier in range(stage):
                    weight = h * earlier_weights[stage, earlier]
                    if weight != 0.0:
                        for j in range(STATES):
                            t[j] += weight * k[earlier, j]
                motor_angle, motor_speed, w = t[0] * ratio, t[6] * ratio, t[9]
                twist = t[0] - t[1] + _look_up(twist_table, t[1])
                rate = t[6] - t[7] + _look_up(twist_slope, t[1]) * t[7]
                if half_gap == 0.0:
                    gear = gear_k * twist + gear_c * rate
                elif twist > half_gap:
                    gear = _flank(twist - half_gap, rate, gear_k, gear_c, contact, exponent, contact_torque)
                elif twist < -half_gap:
                    gear = -_flank(-twist - half_gap, -rate, gear_k, gear_c, contact, exponent, contact_torque)
                else:
                    gear = 0.0
                bend = t[1] - t[2]
                sensed = sensor_k * bend * (1.0 + cubic * bend * bend) + sensor_c * (t[7] - t[8])
                joint = joint_k * (t[2] - t[3] - slip) + joint_c * (t[8] - w)
                joint = min(max(joint, -cap), cap)
                drawn = 0.0
                if j4 > 0.0:
                    pull = k4 * (t[3] - t[4]) + c4 * (w - t[10])
                    k[stage, 4], k[stage, 10] = t[10], pull / j4
                    drawn += pull
                if j5 > 0.0:
                    pull = k5 * (t[3] - t[5]) + c5 * (w - t[11])
                    k[stage, 5], k[stage, 11] = t[11], pull / j5
                    drawn += pull
                motor = t[12] * (1.0 + _look_up(drive_table, motor_angle)) + _look_up(motor_table, motor_angle)
                motor -= motor_viscous * motor_speed + motor_coulomb * _soft_sign(motor_speed / motor_width)
                lost = abs(gear) * loss * _soft_sign(2.0 * motor_speed)
                free = joint - drawn + push + _look_up(wear_table, t[3]) - (wear_viscous + drag * abs(w)) * w
                # everything dry at the wear part, bed and friction, acts against its motion in one law
                side = 0 if w >= 0.0 else 3
                size = load + _look_up(blade_table, t[3]) + dry[side]
                if dry[side + 1] != dry[side]:
                    size += (dry[side + 1] - dry[side]) * np.exp(-((w / dry[side + 2]) ** 2))
                if friction == 0:
                    share = _soft_sign(w / width)
                elif friction == 3:
                    if abs(w) > width or size <= 0.0:
                        share = 1.0 if w > 0.0 else -1.0
                    else:
                        share = min(max((free + j3 * w * 1.0e4) / size, -1.0), 1.0)
                else:
                    bristle = (w - abs(w) * t[13]) / width
                    k[stage, 13] = bristle
                    share = min(max(t[13] + (1.0e-4 * bristle if friction == 2 else 0.0), -1.0), 1.0)
                for j in range(4):
                    k[stage, j] = t[6 + j]
                ring = t[16]
                k[stage, 6] = (motor * ratio - gear - lost) / j0
                k[stage, 7] = (gear - sensed + (ring if ring_node == 1 else 0.0)) / j1
                k[stage, 8] = (sensed - joint) / j2
                k[stage, 9] = (free - share * size) / j3
                k[stage, 12] = lag * (command - t[12])
                seen = sensed + (ring if ring_node == -1 else 0.0)
                k[stage, 14] = t[15]
                k[stage, 15] = amplifier * (amplifier * (seen - t[14]) - 2.0 * amplifier_damping * t[15])
                k[stage, 16] = t[17]
                k[stage, 17] = -ring_w * (ring_w * ring + 2.0 * ring_damping * t[17])
            if stages == 1:
                for j in range(6, 14):
                    y[j] += h * k[0, j]
                for j in range(6):
                    y[j] += h * y[6 + j]
                for j in (14, 16):
                    y[j + 1] += h * k[0, j + 1]
                    y[j] += h * y[j + 1]
                continue
            for stage in range(stages):
                weight = h * weights[stage]
                if weight != 0.0:
                    for j in range(STATES):
                        y[j] += weight * k[stage, j]
    return out
