"""The numbers of a permanent-magnet machine in the layout of the kernel."""

from __future__ import annotations

import numpy as np

from torquerig.machines import kernel
from torquerig.machines.permanent_magnet import PermanentMagnetMachine


def machine_row(machine: PermanentMagnetMachine) -> kernel.Machine:
    """Return the machine's numbers, flat."""
    return kernel.Machine(
        float(machine.pole_pairs),
        machine.phase_resistance * (1 + np.array(machine.resistance_unbalance)),
        machine.phase_inductance,
        machine.flux_linkage,
        *machine.back_emf.kernel_rows(),
    )
