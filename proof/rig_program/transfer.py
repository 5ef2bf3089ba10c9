"""Transfer from a small torque to the sensor at one frequency, and the noise floor that a line must exceed.

The same equations of motion, linear (a rig that drives and never lets go), solved at one frequency at a time; used to
draw effects in sizes from just visible upwards, and in the tests as closed forms beside the integrated rig.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.laws import SAME_LAWS
from proof.rig_program.machine import BRANCH, FOURTH, GEAR, MOTOR, SENSOR, WEAR, Machine, machine_of
from proof.rig_program.plan import Profile, Run
from proof.rig_program.true_rig import TrueRig

LINE_WIDTH = (0.1, 4.0e-4)  # [Hz] of a line recorded for 12 s, and relative: the wander of a nearly steady speed


def springs(machine: Machine) -> list[tuple[int, int, float, float]]:
    """Return every spring: its two masses, stiffness [Nm/rad] and damping [Nms/rad]."""
    rows = [
        (MOTOR, GEAR, machine.gear_stiffness, machine.gear_damping),
        (GEAR, SENSOR, machine.sensor_stiffness, machine.sensor_damping),
        (SENSOR, WEAR, machine.coupling_stiffness, machine.coupling_damping),
    ]
    for i, node in enumerate((BRANCH, FOURTH)):
        if machine.inertia[node] > 0.0:
            rows.append((WEAR, node, float(machine.branch_stiffness[i]), float(machine.branch_damping[i])))
    return rows


def mode_frequencies(machine: Machine) -> NDArray[np.float64]:
    """Frequencies of the undamped rig with a free motor [Hz], lowest first, without the rigid one."""
    present = np.flatnonzero(machine.inertia > 0.0)
    stiffness = np.zeros((6, 6))
    for one, other, k, _ in springs(machine):
        stiffness[[one, other], [one, other]] += k
        stiffness[[one, other], [other, one]] -= k
    root = 1.0 / np.sqrt(machine.inertia[present])
    values = np.linalg.eigvalsh(root[:, None] * stiffness[np.ix_(present, present)] * root)
    return np.asarray(np.sqrt(np.maximum(values[1:], 0.0)) / (2.0 * np.pi))


def to_sensor(machine: Machine, frequency: float, forces: NDArray[np.complex128], *, loop: bool = True) -> complex:
    """Return the amplifier's output [Nm] for torques (6,) [Nm] at the masses at one frequency [Hz]."""
    s = 2j * np.pi * frequency
    system = np.diag(np.where(machine.inertia > 0.0, machine.inertia * s**2, 1.0)).astype(complex)
    for one, other, k, c in springs(machine):
        pull = k + c * s
        system[[one, other], [one, other]] += pull
        system[[one, other], [other, one]] -= pull
    # the motor feels the gear's torque and its losses, while it drives
    system[MOTOR, [MOTOR, GEAR]] += machine.loss * system[MOTOR, GEAR] * np.array([-1.0, 1.0])
    system[MOTOR, MOTOR] += s * machine.motor_viscous * machine.ratio**2
    system[WEAR, WEAR] += s * machine.wear_viscous
    if loop:
        controller = (machine.kp + machine.ki / s) / (1.0 + s / machine.lag)
        system[MOTOR, MOTOR] += s * controller * machine.ratio**2
    angle = np.linalg.solve(system, forces)
    sensed = (machine.sensor_stiffness + s * machine.sensor_damping) * (angle[GEAR] - angle[SENSOR])
    w, z = machine.amplifier, machine.amplifier_damping
    return complex(sensed * w**2 / (w**2 + 2.0 * z * w * s + s**2))


def gain_of(machine: Machine, frequency: float, node: int) -> float:
    """Zero-to-peak reading [Nm] per Nm of torque at one mass, in that mass's output coordinates."""
    forces = np.zeros(6, dtype=complex)
    forces[node] = 1.0
    return abs(to_sensor(machine, frequency, forces))


def gain_of_twist(machine: Machine, frequency: float) -> float:
    """Zero-to-peak reading [Nm] per rad of kinematic error in the gear."""
    pull = machine.gear_stiffness + 2j * np.pi * frequency * machine.gear_damping
    forces = np.zeros(6, dtype=complex)
    forces[MOTOR], forces[GEAR] = -pull * (1.0 + machine.loss), pull
    return abs(to_sensor(machine, frequency, forces))


def line_floor(rig: TrueRig, run: Run, frequency: float) -> float:
    """Zero-to-peak amplitude [V] of the noise in a line's width: load spectrum through the rig, and sensor noise."""
    machine = machine_of(rig, SAME_LAWS)
    decay, mean = nominal.hit_decay(run.particle), rig.mean_load(run.occupancy)
    omega = 2.0 * np.pi * frequency
    hits = 4.0 * (nominal.HITS_SHARE * mean) ** 2 * decay / (1.0 + (omega * decay) ** 2)
    slow = (nominal.SLOW_SHARE * mean) ** 2 / nominal.SLOW_CORNER / (1.0 + (frequency / nominal.SLOW_CORNER) ** 4)
    density = (hits + slow) * gain_of(machine, frequency, WEAR) ** 2
    density += 2.0 * rig["noise"] ** 2 / nominal.SAMPLE_RATE
    return float(np.sqrt(2.0 * density * (LINE_WIDTH[0] + LINE_WIDTH[1] * frequency)))


def steady_runs(plan: tuple[Run, ...]) -> list[Run]:
    """Return the runs of a plan that hold their speed, or all of them where none does."""
    return [run for run in plan if run.profile is Profile.STEADY] or list(plan)


def resisting(rig: TrueRig, run: Run) -> float:
    """Return the mean torque [Nm] that the wear part requires at a run's speed, bed and bearings together."""
    return rig.mean_load(run.occupancy) + rig["wear_viscous"] * run.motor_speed / nominal.RATIO
