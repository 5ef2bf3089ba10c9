"""The speed loop closed about the plant: by the sampled controller, exactly, or by a continuous one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.sensing import measured, with_sensing
from torquerig.simulation.twin.system import LinearSystem, sampled

Floats = NDArray[np.float64]


def closed_loop(open_loop: LinearSystem, lowered: Lowered) -> LinearSystem:
    """Return the rig with its speed loops closed, ``command = kp e + ki integral(e)`` at every instant.

    ``set-point of CONTROLLER`` [rad/s] and ``demand of CONTROLLER`` [N m] take the place of the command. What a
    continuous controller lacks is the half sample by which a sampled one lags (0.5 x 40 us: 0.2 degrees at 30 Hz);
    ``sampled_loop`` has it.
    """
    return _closed(open_loop, lowered, gain=lowered.arrays.drives.kp, kept=0.0, counted=1.0)


def sampled_loop(open_loop: LinearSystem, lowered: Lowered, *, rate: float) -> LinearSystem:
    """Return the rig with its sampled speed loops closed, exact at the samples (``rate`` [Hz]).

    The command is held over a sample, all other inputs run straight from sample to sample; a loop that sees its speed
    through an encoder and a filter has their lag. The torque limit is not in it. The integrals are counted in [rad].
    """
    held = [f"command of {name}" for name in lowered.drive_names]
    discrete = with_sensing(sampled(open_loop, 1 / rate, held=held), lowered)
    gain = (
        lowered.arrays.drives.kp + lowered.arrays.drives.ki / rate
    )  # the integral takes the present error before it commands
    return _closed(discrete, lowered, gain=gain, kept=1.0, counted=1 / rate)


def _closed(system: LinearSystem, lowered: Lowered, *, gain: Floats, kept: float, counted: float) -> LinearSystem:
    drives, d = lowered.arrays.drives, lowered.arrays.drives.on.size
    commands = [system.input(f"command of {name}") for name in lowered.drive_names]
    others = [column for column in range(len(system.inputs)) if column not in commands]
    Cs, Ds = np.zeros((d, len(system.states))), np.zeros((d, len(system.inputs)))
    for row in range(d):
        for output, sign in measured(system, lowered, row):
            Cs[row] += sign * system.C[system.output(output)]
            Ds[row] += sign * system.D[system.output(output)]
    K, ki = np.diag(gain), np.diag(drives.ki)
    Bc, Dc, Bo, Do = system.B[:, commands], system.D[:, commands], system.B[:, others], system.D[:, others]
    # command = K (r - Cs x - Ds u) + ki I; a motor's speed does not jump with its own command
    A = np.block([[system.A - Bc @ K @ Cs, Bc @ ki], [-counted * Cs, kept * np.eye(d)]])
    none = np.zeros((d, d))
    B = np.block([[Bo - Bc @ K @ Ds[:, others], Bc @ K, Bc], [-counted * Ds[:, others], counted * np.eye(d), none]])
    C = np.block([[system.C - Dc @ K @ Cs, Dc @ ki], [-K @ Cs, ki]])
    D = np.block([[Do - Dc @ K @ Ds[:, others], Dc @ K, Dc], [-K @ Ds[:, others], K, np.eye(d)]])
    return LinearSystem(
        A, B, C, D,
        states=(*system.states, *(f"integral of {name}" for name in lowered.drive_names)),
        inputs=(*(system.inputs[column] for column in others),
                *(f"{what} of {name}" for what in ("set-point", "demand") for name in lowered.drive_names)),
        outputs=(*system.outputs, *(f"command of {name}" for name in lowered.drive_names)),
        period=system.period,
    )  # fmt: skip
