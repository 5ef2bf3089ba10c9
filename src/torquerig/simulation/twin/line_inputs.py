"""The lines of a rig at constant speed as phasors: what each adds to the states and outputs of the sampled twin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.operating_point import OperatingPoint
from torquerig.simulation.twin.plant import blade_input
from torquerig.simulation.twin.system import LinearSystem
from torquerig.simulation.waves import orders_of

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]

BLADE_HARMONICS = 41  # what is left out of max(0, cos)^2 is below 2e-5 of its amplitude (coefficients fall as 4/pi/k^3)


@dataclass(frozen=True)
class LineInputs:
    """Lines ``Re(phasor exp(i angular t))``, those of one frequency joined.

    Parameters
    ----------
    angular : ndarray, shape (lines,)
        [rad/s], may be negative.
    onto_states : ndarray, shape (states, lines)
        What a line adds to the states over one sample, per its phasor at the sample's start.
    onto_outputs : ndarray, shape (outputs, lines)
    """

    angular: Floats
    onto_states: Complexes
    onto_outputs: Complexes


def line_inputs(
    lowered: Lowered, point: OperatingPoint, open_loop: LinearSystem, *, start_angles: Floats, period: float
) -> LineInputs:
    """Return the lines at the constant speeds of ``point``, the nodes at ``start_angles`` [rad] at time 0.

    Each is integrated over a sample in closed form: ``int exp(A (T - s)) b exp(i w s) ds``.
    """
    entering: dict[float, Complexes] = {}
    for name, node, order, phasor in _phasors(lowered, point):
        turning = float(order * point.speeds[node])
        value = phasor * np.exp(1j * order * start_angles[node])
        column = entering.setdefault(turning, np.zeros(len(open_loop.inputs), dtype=np.complex128))
        for at, share in _columns(name, open_loop, turning, lowered, point):
            column[at] += share * value
    angular = np.array(list(entering), dtype=np.float64)
    columns = np.array(list(entering.values()), dtype=np.complex128).reshape(-1, len(open_loop.inputs)).T
    states = [_over_a_sample(open_loop.A, open_loop.B @ columns[:, row], w, period) for row, w in enumerate(angular)]
    return LineInputs(
        angular=angular,
        onto_states=np.array(states, dtype=np.complex128).reshape(-1, len(open_loop.states)).T,
        onto_outputs=open_loop.D @ columns,
    )


def _phasors(lowered: Lowered, point: OperatingPoint) -> Iterator[tuple[tuple[str, int], int, float, complex]]:
    """Yield (kind and row, node of the angle, order, phasor at angle 0) of every wave."""
    nodes, orders = (
        zip(*orders_of(lowered.arrays.waves), strict=True) if lowered.arrays.waves.base_node.size else ((), ())
    )
    harmonics, springs, drives, blades = (
        lowered.arrays.harmonics,
        lowered.arrays.springs,
        lowered.arrays.drives,
        lowered.arrays.blades,
    )
    for pair in range(harmonics.on.size):
        for row in range(harmonics.first[pair], harmonics.first[pair + 1]):
            slot = harmonics.slot[row]
            yield ("harmonic", pair), nodes[slot], orders[slot], complex(harmonics.c[row], harmonics.s[row])
    for spring in range(springs.a.size):
        for row in range(springs.e_first[spring], springs.e_first[spring + 1]):
            slot = springs.e_slot[row]
            yield ("error", spring), nodes[slot], orders[slot], complex(springs.e_cos[row], springs.e_sin[row])
    for drive in range(drives.on.size):
        for row in range(drives.r_first[drive], drives.r_first[drive + 1]):
            slot, torque = drives.r_slot[row], point.drive_torque
            yield ("ripple", drive), nodes[slot], orders[slot], torque * complex(drives.r_c[row], drives.r_s[row])
    for row, slot in enumerate(blades.slot):
        phase = complex(blades.c[row], blades.s[row])
        for harmonic in range(1, BLADE_HARMONICS + 1):
            share = half_wave_squared(harmonic)
            if share:
                yield (
                    ("blade", row),
                    nodes[slot],
                    harmonic * orders[slot],
                    blades.amplitude[row] * share * phase**harmonic,
                )


def half_wave_squared(harmonic: int) -> float:
    """Return the Fourier coefficient of ``max(0, cos x)^2`` at ``cos(harmonic x)``; its mean is 1/4."""
    if harmonic == 2:
        return 0.25
    if harmonic % 2 == 0:
        return 0.0
    sign = -1.0 if (harmonic - 1) // 2 % 2 else 1.0
    return -4 / pi * sign / (harmonic * (harmonic**2 - 4))


def _columns(
    name: tuple[str, int], system: LinearSystem, angular: float, lowered: Lowered, point: OperatingPoint
) -> list[tuple[int, complex]]:
    """Return by which inputs of the twin a wave enters, and with what factor."""
    kind, row = name
    if kind == "error":
        spring, b = lowered.spring_names[row], int(lowered.arrays.springs.b[row])
        order = angular / point.speeds[b] if point.speeds[b] else 0.0
        lever = -point.spring_torques[row] * 1j * order  # b gets T (1 - de/dtheta)
        return [
            (system.input(f"error of {spring}"), 1.0),
            (system.input(f"error rate of {spring}"), 1j * angular),
            (system.input(f"torque on {lowered.nodes[b]}"), lever),
        ]
    if kind == "blade":
        return [(system.input(blade_input(lowered, row)), 1.0)]
    ends = lowered.arrays.harmonics if kind == "harmonic" else lowered.arrays.drives
    return [
        (system.input(f"torque on {lowered.nodes[end]}"), sign)
        for end, sign in ((int(ends.on[row]), 1.0), (int(ends.against[row]), -1.0))
        if end < len(lowered.nodes)
    ]


def _over_a_sample(A: Floats, b: Complexes, angular: float, period: float) -> Complexes:
    from scipy.linalg import expm

    n = A.shape[0]
    block = np.zeros((n + 1, n + 1), dtype=np.complex128)
    block[:n, :n], block[:n, n], block[n, n] = A * period, b * period, 1j * angular * period
    return np.asarray(expm(block)[:n, n])
