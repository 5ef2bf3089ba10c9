"""A rig prepared for the exact linear path: its operating point, lines and initial state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.simulation.linear_refusals import refuse_nonlinear
from torquerig.simulation.lower import Lowered, lower
from torquerig.simulation.twin.line_inputs import LineInputs, line_inputs
from torquerig.simulation.twin.loop import sampled_loop
from torquerig.simulation.twin.operating_point import OperatingPoint, operating_point
from torquerig.simulation.twin.plant import plant
from torquerig.simulation.twin.system import LinearSystem

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LinearPath:
    """A rig made ready to run: the sampled twin about its operating point, its lines and its start.

    Parameters
    ----------
    lowered : Lowered
    point : OperatingPoint
        What it is linear about; ``point.left_out`` says what it does not have.
    system : LinearSystem
        Speed loop closed, sampled.
    lines : LineInputs
    start : ndarray, shape (states,)
        The settling's start, as a deviation from the operating point.
    angles : ndarray, shape (nodes,)
        Of the operating point at time 0 [rad], with the lag that starting up leaves.
    """

    lowered: Lowered
    point: OperatingPoint
    system: LinearSystem
    lines: LineInputs
    start: Floats
    angles: Floats


def prepared(rig: Rig, seed: int, *, rate: float) -> LinearPath:
    """Return the rig ready for the exact path; the errors are those of ``simulate_linear``."""
    lowered = lower(rig, seed)
    if not lowered.drive_terms and not lowered.load_terms:
        raise InputError("nothing moves the rig; add a speed controller to the motor")
    point = operating_point(rig, lowered)
    refuse_nonlinear(rig, lowered, point)
    open_loop = plant(lowered, point)
    system = sampled_loop(open_loop, lowered, rate=rate)
    start = _start(lowered, point, system)
    angles = point.angles + _lag(lowered, point, system, start)
    start[: len(lowered.nodes)] = -angles
    lines = line_inputs(lowered, point, open_loop, start_angles=angles, period=1 / rate)
    more_states, more_outputs = len(system.states) - len(open_loop.states), len(system.outputs) - len(open_loop.outputs)
    lines = LineInputs(
        lines.angular, np.pad(lines.onto_states, ((0, more_states), (0, 0))),
        np.pad(lines.onto_outputs, ((0, more_outputs), (0, 0))),
    )  # fmt: skip
    return LinearPath(lowered, point, system, lines, start, angles)


def _start(lowered: Lowered, point: OperatingPoint, system: LinearSystem) -> Floats:
    """Return the deviation at the start: all at the set-point's speed, angles 0, springs and motor without torque."""
    start = np.zeros(len(system.states))
    n, d = len(lowered.nodes), lowered.arrays.drives.on.size
    start[:n] = -point.angles
    if d and point.speeds[int(lowered.arrays.drives.on[0])]:
        turns = point.speeds[:n] / point.speeds[int(lowered.arrays.drives.on[0])]
        start[n : 2 * n] = turns * wanted_speed(lowered, point) - point.speeds[:n]
    start[2 * n : 2 * n + d] = -point.drive_torque
    for row, ki in enumerate(lowered.arrays.drives.ki):
        start[2 * n + d + row] = -point.drive_torque / ki if ki else 0.0
    return start


def wanted_speed(lowered: Lowered, point: OperatingPoint) -> float:
    """Return the constant set-point that an operating point belongs to [rad/s]."""
    drive, speed = lowered.drive_terms[0], float(point.speeds[int(lowered.arrays.drives.on[0])])
    return speed if drive.ki else speed + point.drive_torque / drive.kp


def _lag(lowered: Lowered, point: OperatingPoint, system: LinearSystem, start: Floats) -> Floats:
    """Return how far starting up turns all shafts off their steady angles for good [rad], shape (nodes,).

    It is the part of ``start`` along free turning, by the left eigenvector of the root 1.
    """
    n = len(lowered.nodes)
    driven = point.speeds[int(lowered.arrays.drives.on[0])] if lowered.arrays.drives.on.size else 0.0
    if not driven:
        return np.zeros(n)
    # an integral that nothing reads has a root 1 of its own
    kept = np.arange(start.size - int((lowered.arrays.drives.ki == 0).sum()))
    free = np.zeros(kept.size)
    free[:n] = point.speeds[:n] / driven
    held = np.linalg.svd(system.A[np.ix_(kept, kept)].T - np.eye(kept.size))[2][-1]
    return np.asarray(free[:n] * float(held @ start[kept]) / float(held @ free))
