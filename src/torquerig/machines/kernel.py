"""The compiled loop: machine, inverter and control on two masses, by Runge-Kutta 4 in stationary phase quantities.

Self-contained on purpose: numba's cache on disk goes stale when a callee in another file changes. In the still frame
the fastest rate is R/L, so that no step of a control's length is unstable; explicit Euler in the rotor's frame is.
State: three currents, rotor angle and speed, load angle and speed. Row of a result: see ``TORQUE`` and the following.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]

FAST = {"contract", "reassoc", "arcp", "nsz", "afn"}  # not nnan and ninf: a run that blows up must be seen

TORQUE, CURRENT_A, CURRENT_B, CURRENT_C, ANGLE, SPEED, SHAFT_TORQUE, LOAD_SPEED = range(8)

# which phase carries the current in, and which out, in the six sectors; the third one rests
POSITIVE = np.array([0, 0, 1, 1, 2, 2])
NEGATIVE = np.array([1, 2, 2, 0, 0, 1])

LAG_COSINE = np.array([1.0, -0.5, -0.5])  # of order x 120 degrees, by order modulo 3
LAG_SINE = np.array([0.0, 0.75**0.5, -(0.75**0.5)])


class Machine(NamedTuple):
    """A permanent-magnet machine; ``flat_angle`` 0 means harmonics."""

    pole_pairs: float
    resistance: Floats  # (3,)
    inductance: float
    flux: float
    flat_angle: float
    orders: Floats
    amplitudes: Floats


class Shaft(NamedTuple):
    """Two masses on a spring; both inverse inertias 0 impose the speed."""

    inverse_rotor: float
    inverse_load: float
    stiffness: float
    damping: float
    load_torque: float
    initial_speed: float


class Demand(NamedTuple):
    """A current [A], or with gains above 0 a PI on the speed."""

    current: float
    proportional: float
    integral: float
    speed: float
    limit: float


class Clock(NamedTuple):
    """The sampling period, how many of them, and Runge-Kutta steps in each."""

    period: float
    periods: int
    substeps: int


class SixStep(NamedTuple):
    """PI on the line current, and where the six sectors start."""

    dc_link: float
    proportional: float
    integral: float
    starts: Floats  # (7,)


class FieldOriented(NamedTuple):
    """PI in the rotor's frame and the errors of drive and sensors."""

    dc_link: float
    proportional: float
    integral: float
    dead_voltage: float
    offset_a: float
    offset_b: float
    gain_a: float
    gain_b: float
    angle_error: float
    fundamental_flux: float


@njit(cache=True, nogil=True, fastmath=FAST)
def _shapes(machine, angle, shape):
    """Fill the unit back-EMF of the three phases at the electrical ``angle``."""
    if machine.flat_angle > 0.0:
        for x in range(3):
            turned = angle - x * (2.0 * np.pi / 3.0) + 0.5 * np.pi
            triangle = 0.5 * np.pi - abs(turned - 2.0 * np.pi * np.floor(turned / (2.0 * np.pi)) - np.pi)
            shape[x] = min(1.0, max(-1.0, 2.0 * triangle / (np.pi - machine.flat_angle)))
        return
    shape[:] = 0.0
    for i in range(machine.orders.size):
        order = machine.orders[i]
        sine, cosine = machine.amplitudes[i] * np.sin(order * angle), machine.amplitudes[i] * np.cos(order * angle)
        lag = int(order) % 3
        shape[0] += sine
        shape[1] += sine * LAG_COSINE[lag] - cosine * LAG_SINE[lag]
        shape[2] += sine * LAG_COSINE[lag] + cosine * LAG_SINE[lag]


@njit(cache=True, nogil=True, fastmath=FAST)
def _torque(machine, state, shape):
    """Return the torque; fills ``shape``."""
    _shapes(machine, machine.pole_pairs * state[3], shape)
    product = shape[0] * state[0] + shape[1] * state[1] + shape[2] * state[2]
    return machine.pole_pairs * machine.flux * product


@njit(cache=True, nogil=True, fastmath=FAST)
def _slopes(state, slope, volts, opened, dead, machine, shaft, shape):
    """Fill the time derivatives; ``opened`` is the phase without current, or -1."""
    torque = _torque(machine, state, shape)
    emf = machine.flux * machine.pole_pairs * state[4]
    star = 0.0
    for x in range(3):
        drop = machine.resistance[x] * state[x] + dead * np.sign(state[x])
        slope[x] = volts[x] - emf * shape[x] - drop
        if x != opened:
            star += slope[x]
    star /= 3.0 if opened < 0 else 2.0
    for x in range(3):
        slope[x] = 0.0 if x == opened else (slope[x] - star) / machine.inductance
    twist = shaft.stiffness * (state[3] - state[5]) + shaft.damping * (state[4] - state[6])
    slope[3] = state[4]
    slope[4] = (torque - twist) * shaft.inverse_rotor
    slope[5] = state[6]
    slope[6] = (twist - shaft.load_torque) * shaft.inverse_load


@njit(cache=True, nogil=True, fastmath=FAST)
def _advance(state, step, volts, opened, dead, machine, shaft, work):
    """Move ``state`` on by one Runge-Kutta 4 step; ``work`` has six rows of seven, the last one for the shape."""
    first, second, third, fourth, trial, shape = work[0], work[1], work[2], work[3], work[4], work[5]
    _slopes(state, first, volts, opened, dead, machine, shaft, shape)
    for i in range(7):
        trial[i] = state[i] + 0.5 * step * first[i]
    _slopes(trial, second, volts, opened, dead, machine, shaft, shape)
    for i in range(7):
        trial[i] = state[i] + 0.5 * step * second[i]
    _slopes(trial, third, volts, opened, dead, machine, shaft, shape)
    for i in range(7):
        trial[i] = state[i] + step * third[i]
    _slopes(trial, fourth, volts, opened, dead, machine, shaft, shape)
    for i in range(7):
        state[i] += step / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i])


@njit(cache=True, nogil=True, fastmath=FAST)
def _record(row, state, machine, shaft, shape):
    """Fill one row of the result."""
    row[TORQUE] = _torque(machine, state, shape)
    row[CURRENT_A], row[CURRENT_B], row[CURRENT_C] = state[0], state[1], state[2]
    row[ANGLE], row[SPEED] = state[3], state[4]
    row[SHAFT_TORQUE] = shaft.stiffness * (state[3] - state[5]) + shaft.damping * (state[4] - state[6])
    row[LOAD_SPEED] = state[6]


@njit(cache=True, nogil=True, fastmath=FAST)
def _demanded(demand, speed, memory, period):
    """Return the demanded current and the speed loop's integrator."""
    error = demand.speed - speed
    wanted = demand.current + demand.proportional * error + memory
    current = min(demand.limit, max(-demand.limit, wanted))
    if current == wanted:
        memory += demand.integral * period * error
    return current, memory


@njit(cache=True, nogil=True, fastmath=FAST)
def field_oriented(machine, shaft, demand, control, clock):
    """Return a row per period under field-oriented control, shape (periods, 8)."""
    rows, work, state = np.empty((clock.periods, 8)), np.zeros((6, 7)), np.zeros(7)
    volts, coming = np.zeros(3), np.zeros(3)
    state[4] = state[6] = shaft.initial_speed
    step, limit, root = clock.period / clock.substeps, control.dc_link / 3.0**0.5, 0.75**0.5
    memory = direct_memory = cross_memory = 0.0
    for x in range(3):  # switched on while turning: the first period already meets the back-EMF
        angle = control.angle_error + 0.5 * clock.period * machine.pole_pairs * state[4] - x * (2.0 * np.pi / 3.0)
        coming[x] = control.fundamental_flux * machine.pole_pairs * state[4] * np.sin(angle)
    for k in range(clock.periods):
        _record(rows[k], state, machine, shaft, work[5])
        wanted, memory = _demanded(demand, state[4], memory, clock.period)
        a = (1.0 + control.gain_a) * state[0] + control.offset_a
        b = (1.0 + control.gain_b) * state[1] + control.offset_b
        angle = machine.pole_pairs * state[3] + control.angle_error
        speed = machine.pole_pairs * state[4]
        alpha, beta = a, (a + 2.0 * b) / (2.0 * root)
        sine, cosine = np.sin(angle), np.cos(angle)
        direct, cross = -(alpha * cosine + beta * sine), alpha * sine - beta * cosine
        error_d, error_q = -direct, wanted - cross
        free_d = control.proportional * error_d + direct_memory - speed * machine.inductance * cross
        free_q = control.proportional * error_q + cross_memory
        free_q += speed * (machine.inductance * direct + control.fundamental_flux)
        size = np.sqrt(free_d * free_d + free_q * free_q)
        scale = limit / size if size > limit else 1.0
        volts_d, volts_q = scale * free_d, scale * free_q
        gain = clock.period * control.integral
        direct_memory += gain * (error_d + (volts_d - free_d) / control.proportional)
        cross_memory += gain * (error_q + (volts_q - free_q) / control.proportional)
        for x in range(3):
            volts[x] = coming[x]
            ahead = angle + 1.5 * clock.period * speed - x * (2.0 * np.pi / 3.0)
            coming[x] = volts_q * np.sin(ahead) - volts_d * np.cos(ahead)
        for _ in range(clock.substeps):
            _advance(state, step, volts, -1, control.dead_voltage, machine, shaft, work)
    return rows


@njit(cache=True, nogil=True, fastmath=FAST)
def _resting_rail(state, volts, machine, dc_link, resting, shape):
    """Return the rail that the resting phase conducts into: 0 lower (current positive), 1 upper, -1 none."""
    if state[resting] != 0.0:
        return 0 if state[resting] > 0.0 else 1
    _shapes(machine, machine.pole_pairs * state[3], shape)
    emf = machine.flux * machine.pole_pairs * state[4]
    others = volts.sum() - volts[resting] - emf * (shape.sum() - shape[resting])
    floating = 0.5 * others + emf * shape[resting]
    if floating < 0.0:
        return 0
    return 1 if floating > dc_link else -1


@njit(cache=True, nogil=True, fastmath=FAST)
def _two_phases(state, before, step, volts, sector, dc_link, machine, shaft, work):
    """Move on by ``step`` or to where the resting phase's current ends; return the time moved."""
    resting = 3 - POSITIVE[sector] - NEGATIVE[sector]
    rail = _resting_rail(state, volts, machine, dc_link, resting, work[5][:3])
    if rail < 0:
        _advance(state, step, volts, resting, 0.0, machine, shaft, work)
        return step
    volts[resting] = rail * dc_link
    before[:] = state
    _advance(state, step, volts, -1, 0.0, machine, shaft, work)
    if state[resting] * (1.0 - 2.0 * rail) >= 0.0:
        return step
    if before[resting] == 0.0:
        state[:] = before
        _advance(state, step, volts, resting, 0.0, machine, shaft, work)
        return step
    for _ in range(3):
        step *= before[resting] / (before[resting] - state[resting])
        state[:] = before
        _advance(state, step, volts, -1, 0.0, machine, shaft, work)
    rest = state[resting]
    state[POSITIVE[sector]] += 0.5 * rest
    state[NEGATIVE[sector]] += 0.5 * rest
    state[resting] = 0.0
    return step


@njit(cache=True, nogil=True, fastmath=FAST)
def six_step(machine, shaft, demand, control, clock):
    """Return a row per period under six-step commutation, shape (periods, 8); Hall edges are met, not stepped over."""
    rows, work, state = np.empty((clock.periods, 8)), np.zeros((6, 7)), np.zeros(7)
    before, volts = np.zeros(7), np.zeros(3)
    state[4] = state[6] = shaft.initial_speed
    sector, turns, memory, line_memory, line, coming = 5, -2.0 * np.pi, 0.0, 0.0, 0.0, 0.0
    for k in range(clock.periods):
        _record(rows[k], state, machine, shaft, work[5])
        wanted, memory = _demanded(demand, state[4], memory, clock.period)
        error = wanted - 0.5 * (state[POSITIVE[sector]] - state[NEGATIVE[sector]])
        free = control.proportional * error + line_memory
        line, coming = coming, min(control.dc_link, max(-control.dc_link, free))
        if coming == free or (free > coming) != (error > 0.0):
            line_memory += control.integral * clock.period * error
        for _ in range(clock.substeps):
            left = clock.period / clock.substeps
            while left > 0.0:
                speed, angle, way = machine.pole_pairs * state[4], machine.pole_pairs * state[3], 0
                step = left
                if speed != 0.0:
                    to = 1 if speed > 0.0 else 0
                    until = (control.starts[sector + to] + turns - angle) / speed
                    if until < left:
                        step, way = max(0.0, until), 2 * to - 1
                if step > 0.0:
                    volts[POSITIVE[sector]] = 0.5 * (control.dc_link + line)
                    volts[NEGATIVE[sector]] = 0.5 * (control.dc_link - line)
                    moved = _two_phases(state, before, step, volts, sector, control.dc_link, machine, shaft, work)
                    way = way if moved == step else 0
                    left -= moved
                sector += way
                if not 0 <= sector < 6:
                    sector, turns = sector - 6 * way, turns + 2.0 * np.pi * way
    return rows
