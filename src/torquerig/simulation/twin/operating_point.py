"""The operating point of the linear model: steady speeds, torques, slopes, and the effects that are left out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import AppliedTorque, Load, Signal
from torquerig.simulation.lower import Lowered
from torquerig.simulation.term_kinds import KINDS
from torquerig.simulation.twin.friction_slope import friction_at, sliding

Floats = NDArray[np.float64]

HALF_WAVE_SQUARED_MEAN = 0.25  # mean of max(0, cos)^2


@dataclass(frozen=True)
class OperatingPoint:
    """All shafts turn steadily; rows as in the lowered rig, the ground last where a node is counted.

    Parameters
    ----------
    speeds : ndarray, shape (nodes + 1,)
        [rad/s].
    angles : ndarray, shape (nodes,)
        Angles in excess of steady turning [rad], the driven node at 0: they hold the springs' torque.
    drive_torque : float
        [N m] of the speed-controlled motor; 0 without one.
    spring_torques : ndarray, shape (springs,)
        [N m].
    spring_back : ndarray, shape (springs,)
        Torque on a per torque on b [1]: inverse ratio and the loss of the direction in which power flows.
    friction_torques, friction_slopes : ndarray, shape (frictions + bristle frictions,)
        [N m] and [N m s/rad] at the relative speed of each row of ``sliding``.
    load_directions : ndarray, shape (loads,)
        +-1 where a load opposes, -1 where a torque is applied; [1].
    blade_directions : ndarray, shape (blades,)
        [1].
    left_out : tuple of str
        What a linear twin about this point does not have, one sentence each.
    """

    speeds: Floats
    angles: Floats
    drive_torque: float
    spring_torques: Floats
    spring_back: Floats
    friction_torques: Floats
    friction_slopes: Floats
    load_directions: Floats
    blade_directions: Floats
    left_out: tuple[str, ...]


def operating_point(rig: Rig, lowered: Lowered) -> OperatingPoint:
    """Return the steady state at the set-point of the run with mean loads; standstill without speed control.

    Raises
    ------
    InputError
        With two speed controllers, or where the controller cannot hold the rig at a steady speed.
    """
    if len(lowered.drive_terms) > 1:
        names = " and ".join(lowered.drive_names)
        raise InputError(f"{names}: how two speed controllers share the torque is not determined at a steady speed; "
                         "simulate the rig, or leave one out")  # fmt: skip
    if not lowered.drive_terms:
        return _at(lowered, np.zeros(len(lowered.nodes) + 1))
    drive = lowered.drive_terms[0]
    ratios = rig.speed_ratios(lowered.leader())
    turns = np.array([ratios.get(node, 0.0) for node in lowered.nodes] + [0.0])
    wanted = rig.run.speed or 0.0
    point = _at(lowered, turns * wanted)
    if drive.ki > 0 or wanted == 0 or not drive.holds_speed:
        return point
    return _drooping(lowered, turns, wanted, drive.kp)


def mean_torques(lowered: Lowered) -> Floats:
    """Return what each sampled torque is at the operating point [N m], shape (loads,).

    A replayed signal counts as a change from 0, and so does every torque where nothing drives the rig.
    """

    def mean(term: Load | AppliedTorque) -> float:
        return 0.0 if isinstance(term.process, Signal) or not lowered.drive_terms else term.process.mean

    return np.array([mean(term) for term in lowered.load_terms], dtype=np.float64)


def _drooping(lowered: Lowered, turns: Floats, wanted: float, kp: float) -> OperatingPoint:
    """Return the state that a loop without integrator settles at: the torque is kp times the missing speed."""
    speed = wanted
    for _ in range(50):
        point, ahead = _at(lowered, turns * speed), _at(lowered, turns * speed * (1 + 1e-6))
        miss = speed + point.drive_torque / kp - wanted
        slope = 1 + (ahead.drive_torque - point.drive_torque) / (kp * speed * 1e-6)
        step = miss / slope
        speed -= step
        if abs(step) <= 1e-12 * abs(wanted):
            return _at(lowered, turns * speed)
        if not np.isfinite(speed) or speed * wanted <= 0:
            break
    raise InputError(
        f"{lowered.drive_names[0]}: with kp {kp:g} N m s/rad and no integrator the rig comes to no steady speed; "
        "raise kp or state ki"
    )


def _at(lowered: Lowered, speeds: Floats) -> OperatingPoint:
    """Return the balance at given speeds, in passes: losses and gaps take their side from the torques."""
    torques, slopes, left_out = friction_at(lowered, speeds)
    loads = lowered.arrays.loads
    direction = np.array([
        np.tanh(speeds[on] * smooth) if smooth else -1.0
        for on, smooth in zip(loads.on, loads.inverse_smoothing, strict=True)
    ])  # fmt: skip
    smooth = lowered.arrays.blades.inverse_smoothing
    blades = np.where(smooth == 0.0, 1.0, np.tanh(speeds[lowered.arrays.blades.on] * smooth))
    outside = np.zeros(speeds.size)
    frictions = sliding(lowered)
    np.subtract.at(outside, frictions.on, torques)
    np.add.at(outside, frictions.against, torques)
    np.subtract.at(outside, loads.on, direction * mean_torques(lowered))
    np.subtract.at(outside, lowered.arrays.blades.on, blades * lowered.arrays.blades.amplitude * HALF_WAVE_SQUARED_MEAN)
    for kind in KINDS:
        for on, torque in kind.steady(lowered.rows_of[kind.field], getattr(lowered.arrays, kind.field), speeds):
            outside[on] -= torque
    point = OperatingPoint(
        speeds=speeds,
        angles=np.zeros(speeds.size - 1),
        drive_torque=0.0,
        spring_torques=np.zeros(lowered.arrays.springs.a.size),
        spring_back=lowered.arrays.springs.inverse_ratio.copy(),
        friction_torques=torques,
        friction_slopes=slopes,
        load_directions=direction,
        blade_directions=blades,
        left_out=(*left_out, *_nonlinear(lowered)),
    )
    for _ in range(3):
        point = _balanced(lowered, point, outside)
    return replace(point, left_out=(*point.left_out, *_gaps(lowered, point)))


def _balanced(lowered: Lowered, point: OperatingPoint, outside: Floats) -> OperatingPoint:
    springs, n = lowered.arrays.springs, len(lowered.nodes)
    side = np.sign(point.spring_torques)
    flow = np.tanh(springs.inverse_ratio * point.speeds[springs.a] * springs.inverse_smoothing) * side
    back = springs.inverse_ratio * (1 + np.where(flow > 0, springs.loss_forward, springs.loss_backward) * flow)
    pull = np.zeros((n + 1, springs.a.size))  # torque on the nodes per torque in each spring
    twist = np.zeros((springs.a.size, n + 1))
    for row, (a, b) in enumerate(zip(springs.a, springs.b, strict=True)):
        pull[b, row] += 1.0
        pull[a, row] -= back[row]
        twist[row, a] += springs.inverse_ratio[row]
        twist[row, b] -= 1.0
    driven = np.zeros((n + 1, lowered.arrays.drives.on.size))
    for column, (on, against) in enumerate(zip(lowered.arrays.drives.on, lowered.arrays.drives.against, strict=True)):
        driven[on, column] += 1.0
        driven[against, column] -= 1.0
    stiff = springs.stiffness[:, None] * twist[:, :n]
    offset = -springs.stiffness * (side * springs.half_gap + springs.rest)
    matrix = np.hstack([pull[:n] @ stiff, driven[:n]])
    found = np.linalg.lstsq(matrix, -outside[:n] - pull[:n] @ offset, rcond=None)[0]
    angles, drive = found[:n], found[n:]
    if drive.size:  # the same torques with the driven node at 0
        on = int(lowered.arrays.drives.on[0])
        if point.speeds[on]:
            angles = angles - angles[on] / point.speeds[on] * point.speeds[:n]
    return replace(
        point,
        angles=np.asarray(angles, dtype=np.float64),
        drive_torque=float(drive[0]) if drive.size else 0.0,
        spring_torques=stiff @ angles + offset,
        spring_back=back,
    )


def _nonlinear(lowered: Lowered) -> Iterator[str]:
    if lowered.arrays.waves.base_node.size:
        yield "what the lines' own wobble of the angle does to their phase"
    for kind in KINDS:
        yield from kind.left_out(lowered.rows_of[kind.field], getattr(lowered.arrays, kind.field))


def _gaps(lowered: Lowered, point: OperatingPoint) -> tuple[str, ...]:
    notes = []
    for row in np.flatnonzero(lowered.arrays.springs.half_gap):
        name, torque = lowered.spring_names[row], point.spring_torques[row]
        if torque:
            notes.append(f"the gap of {name!r}, taken as closed: {abs(torque):.4g} N m keep it closed")
        else:
            notes.append(f"the gap of {name!r}, taken as closed, although no torque keeps it closed")
    return tuple(notes)
