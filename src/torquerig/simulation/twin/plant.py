"""The rig without its speed loop as a named linear system: the arrays of the kernel about an operating point."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.terms import Load
from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.friction_slope import sliding
from torquerig.simulation.twin.operating_point import OperatingPoint
from torquerig.simulation.twin.system import LinearSystem

Floats = NDArray[np.float64]


def plant(lowered: Lowered, point: OperatingPoint) -> LinearSystem:
    """Return the open-loop rig for small changes about ``point``.

    Inputs: ``torque on NODE``; ``load NAME`` (opposing the motion as it stands at the point) and ``applied NAME``
    [N m]; ``command of CONTROLLER`` [N m]; ``error of SPRING`` [rad] and ``error rate of SPRING`` [rad/s], of which the
    second is the first's derivative: two inputs, because a damper turns the rate into torque at once.
    A node whose motion is imposed stands still but for it.
    Outputs: ``torque in SPRING``, ``speed of NODE``, ``angle of NODE``, ``torque of CONTROLLER``, ``opposing torque on
    NODE``. States: angles, speeds, motor torques behind their current lag.
    """
    n, d = len(lowered.nodes), lowered.arrays.drives.on.size
    inputs, onto = _torque_inputs(lowered, point)
    springs, torques = _springs(lowered, point), len(inputs)
    errors = torques + d
    m = springs.pull.shape[1]
    drag, opposing = _drag(lowered, point)
    inverse = (1 / lowered.inertia)[:, None]
    inverse[[int(on) for on in lowered.arrays.imposed.on]] = 0.0  # what is imposed does not give way
    A, B = np.zeros((2 * n + d, 2 * n + d)), np.zeros((2 * n + d, errors + 2 * m))
    A[:n, n : 2 * n] = np.eye(n)
    A[n : 2 * n, :n] = inverse * (springs.pull @ springs.stiff)
    A[n : 2 * n, n : 2 * n] = inverse * (springs.pull @ springs.damped - drag)
    A[n : 2 * n, 2 * n :] = inverse * _driven(lowered)
    A[2 * n :, 2 * n :] = -np.diag(lowered.arrays.drives.inverse_lag)
    B[n : 2 * n, :torques] = inverse * onto
    B[2 * n :, torques:errors] = np.diag(lowered.arrays.drives.inverse_lag)
    B[n : 2 * n, errors : errors + m] = inverse * (springs.pull * lowered.arrays.springs.stiffness)
    B[n : 2 * n, errors + m :] = inverse * (springs.pull * lowered.arrays.springs.damping)
    zero = np.zeros
    C = np.vstack([
        np.hstack([springs.stiff, springs.damped, zero((m, d))]),
        np.hstack([zero((n, n)), np.eye(n), zero((n, d))]),
        np.hstack([np.eye(n), zero((n, n + d))]),
        np.hstack([zero((d, 2 * n)), np.eye(d)]),
        np.hstack([zero((n, n)), opposing, zero((n, d))]),
    ])  # fmt: skip
    D = np.zeros((C.shape[0], B.shape[1]))
    D[:m, errors : errors + m], D[:m, errors + m :] = (
        np.diag(lowered.arrays.springs.stiffness),
        np.diag(lowered.arrays.springs.damping),
    )
    D[-n:, n:torques] = np.where(_opposes(lowered), -onto[:, n:], 0.0)
    return LinearSystem(
        A, B, C, D,
        states=(*(f"{what} of {node}" for what in ("angle", "speed") for node in lowered.nodes),
                *(f"torque of {name}" for name in lowered.drive_names)),
        inputs=(*inputs, *(f"command of {name}" for name in lowered.drive_names),
                *(f"{what} of {name}" for what in ("error", "error rate") for name in lowered.spring_names)),
        outputs=(*(f"torque in {name}" for name in lowered.spring_names),
                 *(f"{what} of {node}" for what in ("speed", "angle") for node in lowered.nodes),
                 *(f"torque of {name}" for name in lowered.drive_names),
                 *(f"opposing torque on {node}" for node in lowered.nodes)),
    )  # fmt: skip


def load_input(lowered: Lowered, row: int) -> str:
    """Return the name of the input that the sampled torque number ``row`` enters by."""
    term = lowered.load_terms[row]
    return f"{'load' if isinstance(term, Load) else 'applied'} {term.name}"


def blade_input(lowered: Lowered, row: int) -> str:
    """Return the name of the input that the blade pulses number ``row`` enter by."""
    return f"blades {row + 1} on {lowered.nodes[int(lowered.arrays.blades.on[row])]}"


class _Springs(NamedTuple):
    """``pull``: torque on the nodes per torque in each spring; ``stiff``, ``damped``: torque in it per angle, speed."""

    pull: Floats  # (nodes, springs)
    stiff: Floats  # (springs, nodes)
    damped: Floats


def _springs(lowered: Lowered, point: OperatingPoint) -> _Springs:
    springs, n = lowered.arrays.springs, len(lowered.nodes)
    pull, twist = np.zeros((n + 1, springs.a.size)), np.zeros((springs.a.size, n + 1))
    for row, (a, b) in enumerate(zip(springs.a, springs.b, strict=True)):
        pull[b, row] += 1.0
        pull[a, row] -= point.spring_back[row]
        twist[row, a] += springs.inverse_ratio[row]
        twist[row, b] -= 1.0
    twist = twist[:, :n]
    return _Springs(pull[:n], springs.stiffness[:, None] * twist, springs.damping[:, None] * twist)


def _drag(lowered: Lowered, point: OperatingPoint) -> tuple[Floats, Floats]:
    """Return the torque against each node per speed of each, and the part of it that counts as opposing."""
    n, frictions = len(lowered.nodes), sliding(lowered)
    drag, opposing = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1))
    for on, against, slope in zip(frictions.on, frictions.against, point.friction_slopes, strict=True):
        slide = np.zeros(n + 1)
        slide[on] += 1.0
        slide[against] -= 1.0
        drag += slope * np.outer(slide, slide)
        opposing[on] += slope * slide
    return drag[:n, :n], opposing[:n, :n]


def _driven(lowered: Lowered) -> Floats:
    """Return the torque on the nodes per torque of each motor."""
    driven = np.zeros((len(lowered.nodes) + 1, lowered.arrays.drives.on.size))
    for column, (on, against) in enumerate(zip(lowered.arrays.drives.on, lowered.arrays.drives.against, strict=True)):
        driven[on, column] += 1.0
        driven[against, column] -= 1.0
    return driven[:-1]


def _torque_inputs(lowered: Lowered, point: OperatingPoint) -> tuple[tuple[str, ...], Floats]:
    """Return the names of all torque inputs, the nodes' first, and the torque on each node per unit of them."""
    n, loads, blades = len(lowered.nodes), lowered.arrays.loads, lowered.arrays.blades
    columns = np.zeros((n + 1, n + loads.on.size + blades.on.size))
    columns[:n, :n] = np.eye(n)
    for row, on in enumerate(loads.on):
        columns[on, n + row] = -point.load_directions[row]
    for row, on in enumerate(blades.on):
        columns[on, n + loads.on.size + row] = -point.blade_directions[row]
    return (
        *(f"torque on {node}" for node in lowered.nodes),
        *(load_input(lowered, row) for row in range(loads.on.size)),
        *(blade_input(lowered, row) for row in range(blades.on.size)),
    ), columns[:n]


def _opposes(lowered: Lowered) -> NDArray[np.bool_]:
    """Return which of the sampled torques and blade pulses count as opposing; those that push one way do not."""
    return np.concatenate([each.inverse_smoothing != 0.0 for each in (lowered.arrays.loads, lowered.arrays.blades)])
