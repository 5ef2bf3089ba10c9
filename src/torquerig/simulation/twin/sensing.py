"""The measured speed of a speed loop: the true one, or the filtered difference of two angles."""

from __future__ import annotations

from math import exp

import numpy as np

from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.system import LinearSystem


def measured(system: LinearSystem, lowered: Lowered, controller: int) -> list[tuple[str, float]]:
    """Return the outputs, each with its sign, whose sum a controller takes as its speed."""
    seen = f"seen speed of {lowered.drive_names[controller]}"
    return [(seen, 1.0)] if seen in system.outputs else _ends(lowered, "speed", controller)


def with_sensing(system: LinearSystem, lowered: Lowered) -> LinearSystem:
    """Return a sampled system with ``seen speed of CONTROLLER`` for each loop that does not see the true speed.

    ``seen += share ((angle - angle before) / period - seen)``, ``share = 1 - exp(-period / filter time)``: the lag of
    half a sample and of the filter. Counts and the encoder's error are not linear and not in it.
    """
    for controller in np.flatnonzero(lowered.arrays.sensings.ideal == 0):
        system = _with_one(system, lowered, int(controller))
    return system


def _with_one(system: LinearSystem, lowered: Lowered, controller: int) -> LinearSystem:
    name, filtering = lowered.drive_names[controller], float(lowered.arrays.sensings.filter_time[controller])
    share = 1.0 - exp(-system.period / filtering) if filtering else 1.0
    rows = [(system.output(output), sign) for output, sign in _ends(lowered, "angle", controller)]
    C, D = (sum(sign * matrix[row] for row, sign in rows) for matrix in (system.C, system.D))
    gain, n, m = share / system.period, len(system.states), len(system.inputs)
    seen_C, seen_D = np.concatenate([gain * C, [-gain, 1 - share]]), gain * D
    return LinearSystem(
        A=np.vstack([np.hstack([system.A, np.zeros((n, 2))]), np.concatenate([C, [0.0, 0.0]]), seen_C]),
        B=np.vstack([system.B, D, seen_D]),
        C=np.vstack([np.hstack([system.C, np.zeros((len(system.outputs), 2))]), seen_C]),
        D=np.vstack([system.D, np.reshape(seen_D, (1, m))]),
        states=(*system.states, f"angle before of {name}", f"speed before of {name}"),
        inputs=system.inputs,
        outputs=(*system.outputs, f"seen speed of {name}"),
        period=system.period,
    )


def _ends(lowered: Lowered, what: str, controller: int) -> list[tuple[str, float]]:
    drives, ground = lowered.arrays.drives, len(lowered.nodes)
    ends = ((int(drives.on[controller]), 1.0), (int(drives.against[controller]), -1.0))
    return [(f"{what} of {lowered.nodes[end]}", sign) for end, sign in ends if end != ground]
