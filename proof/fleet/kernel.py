"""The compiled loop: masses in a row with one optional branch, in the coordinates of the output shaft.

Explicit Runge-Kutta rule of fourth order; the controller works at its own period. Angles are those of the output shaft:
a shaft that turns r times per output turn has the angle r phi, the inertia J r^2 and the stiffness k r^2.
"""

from __future__ import annotations

import numpy as np
from numba import njit

_FAST = {"reassoc", "contract", "nsz", "arcp"}
POINTS = 16384  # of a table over the angle; order 400 has 40 points a period


@njit(fastmath=_FAST, error_model="numpy", inline="always")
def _at(table, turns):
    """Return a periodic table's value at a place [periods], on the straight line between its points."""
    place = (turns - np.floor(turns)) * POINTS
    below = int(place)
    first = table[below & (POINTS - 1)]
    return first + (place - below) * (table[(below + 1) & (POINTS - 1)] - first)


@njit(fastmath=_FAST, error_model="numpy", inline="always")
def _sign(speed, width):
    """Return the smooth sign of a speed: algebraic, other than the hyperbolic tangent."""
    return speed / np.sqrt(speed * speed + width * width)


@njit(cache=True, fastmath=_FAST, error_model="numpy")
def _contact(dent, rate, stiffness, damping, exponent, torque):
    """Return the torque of a flank that is pressed in by ``dent`` > 0; it never pulls."""
    force = stiffness * dent if exponent == 1.0 else torque * (dent * stiffness / (exponent * torque)) ** exponent
    force += damping * rate * min(dent * stiffness / torque, 1.0)
    return max(force, 0.0)


@njit(cache=True, nogil=True, fastmath=_FAST, error_model="numpy")
def run_train(m, start, courses, substeps, frame_rate):
    """Run the train ``m`` from the state ``start`` and return (frames, 4).

    Columns are the sensed torque, the angles of motor and load, and the speed of the load.

    ``courses`` are arrays over the frames: motor set-point [rad/s], resisting torque [N m], turbulence share, pushes on
    motor and load [N m, output coordinates], and the factor of the coupling's stiffness.
    """
    set_point, resist, swirl, push_motor, push_load, soft = courses
    inertia, k, c, viscous = m.inertia, m.stiffness, m.damping, m.viscous
    half_gap, loss, errors, slopes, per_turn = m.half_gap, m.loss, m.errors, m.slopes, m.error_periods
    has_error, ratio = m.has_error, m.ratio
    n = inertia.size
    last = n - 1
    size = 2 * n + 4  # branch angle and speed, motor torque, bristle
    y = start.copy()
    t = np.zeros(size)
    rates = np.zeros((4, size))
    torque = np.zeros(n)
    frames = set_point.size
    out = np.empty((frames, 4))
    h = 1.0 / (frame_rate * substeps)
    held, waiting, command = start[2 * n + 2], start[2 * n + 2], start[2 * n + 2]
    branch, bristle, drive = 2 * n, 2 * n + 3, 2 * n + 2
    jb, kb, cb = m.branch_inertia, m.branch_stiffness, m.branch_damping
    s = m.sensor_spring
    for i in range(frames):
        out[i, 0] = k[s] * (y[s] - y[s + 1]) + c[s] * (y[n + s] - y[n + s + 1])
        out[i, 1], out[i, 2], out[i, 3] = y[0] * ratio, y[last], y[n + last]
        if not m.induction and i % m.control_frames == 0:
            error = set_point[i] - y[n] * ratio
            gain = m.ki * error * m.control_frames / frame_rate
            wanted = m.kp * error + held + gain
            if abs(wanted) <= m.torque_limit:
                held += gain
            wanted = min(max(wanted, -m.torque_limit), m.torque_limit)
            command = waiting if m.control_delay == 1 else wanted
            waiting = wanted
        for _ in range(substeps):
            for stage in range(4):
                weight = 0.0 if stage == 0 else (h if stage == 3 else 0.5 * h)
                for j in range(size):
                    t[j] = y[j] + weight * rates[stage - 1, j] if stage > 0 else y[j]
                motor_angle, motor_speed = t[0] * ratio, t[n] * ratio
                if m.induction:
                    slip = (set_point[i] - motor_speed) / m.breakdown_slip
                    command = 2.0 * m.breakdown_torque * slip / (1.0 + slip * slip)
                motor = t[drive] * (1.0 + _at(m.drive_table, motor_angle * m.per_radian))
                motor += _at(m.motor_table, motor_angle * m.per_radian)
                motor -= m.motor_coulomb * _sign(motor_speed, m.motor_width)
                for j in range(n):
                    torque[j] = -viscous[j] * t[n + j]
                torque[0] += motor * ratio + push_motor[i]
                for j in range(last):
                    twist, rate = t[j] - t[j + 1], t[n + j] - t[n + j + 1]
                    if has_error[j]:
                        place = t[j + 1] * per_turn[j]
                        twist += _at(errors[j], place)
                        rate += _at(slopes[j], place) * t[n + j + 1]
                    factor = soft[i] if j == m.soft_spring else 1.0
                    if half_gap[j] == 0.0:
                        pull = factor * k[j] * twist + c[j] * rate
                    elif twist > half_gap[j]:
                        pull = _contact(
                            twist - half_gap[j],
                            m.contact_damped * rate,
                            k[j],
                            c[j],
                            m.contact_exponent,
                            m.contact_torque,
                        )
                    elif twist < -half_gap[j]:
                        pull = -_contact(
                            -twist - half_gap[j],
                            -m.contact_damped * rate,
                            k[j],
                            c[j],
                            m.contact_exponent,
                            m.contact_torque,
                        )
                    else:
                        pull = 0.0
                    torque[j] -= pull + abs(pull) * loss[j] * _sign(t[n + j], m.loss_width)
                    torque[j + 1] += pull
                w = t[n + last]
                if jb > 0.0:
                    pull = kb * (t[last] - t[branch]) + cb * (w - t[branch + 1])
                    torque[last] -= pull
                    rates[stage, branch], rates[stage, branch + 1] = t[branch + 1], pull / jb
                turn = t[last] * m.per_radian
                torque[last] += push_load[i] + _at(m.load_table, turn)
                torque[last] -= m.drag * (1.0 + swirl[i] * m.swirl_follows) * w * abs(w)
                torque[last] -= m.swirl_torque * swirl[i] * _sign(w, m.friction_width)
                dry = m.dry[0] if w >= 0.0 else m.dry[1]
                peak = m.peak[0] if w >= 0.0 else m.peak[1]
                against = resist[i] + dry + _at(m.blade_table, turn)
                if peak > 0.0:
                    against += peak * np.exp(-((w / m.stribeck_speed) ** 2))
                if m.friction == 1:
                    rates[stage, bristle] = (w - abs(w) * t[bristle]) / m.bristle_angle
                    share = min(max(t[bristle], -1.0), 1.0)
                elif m.friction == 2:
                    share = min(max(w / m.friction_width, -1.0), 1.0)
                else:
                    share = _sign(w, m.friction_width)
                torque[last] -= share * against
                for j in range(n):
                    rates[stage, j] = t[n + j]
                    rates[stage, n + j] = torque[j] / inertia[j]
                rates[stage, drive] = m.lag * (command - t[drive])
            for j in range(size):
                y[j] += h / 6.0 * (rates[0, j] + 2.0 * rates[1, j] + 2.0 * rates[2, j] + rates[3, j])
    return out
