"""Writing of the outputs at every sample."""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import hand_out
from torquerig.simulation.kernel.imposed import imposing_torque

# what an output row holds: the torque of a spring; speed, angle of a node; torque of a drive; all that opposes a node;
# what an imposed motion takes
SPRING_TORQUE, SPEED, ANGLE, DRIVE_TORQUE, OPPOSING_TORQUE, IMPOSING_TORQUE = range(6)


@njit(inline="always")
def keep(kept, at, outputs, theta, omega, tau, spring_torque, opposing, torque, imposed, sample, period):
    """Put the outputs of the instant of ``sample`` into the column ``at`` of ``kept``, (rigs, outputs, samples)."""
    for i in range(outputs.kind.size):
        kind, row = outputs.kind[i], outputs.row[i]
        if kind == SPRING_TORQUE:
            hand_out(kept, i, at, spring_torque[row])
        elif kind == SPEED:
            hand_out(kept, i, at, omega[row])
        elif kind == ANGLE:
            hand_out(kept, i, at, theta[row])
        elif kind == DRIVE_TORQUE:
            hand_out(kept, i, at, tau[row])
        elif kind == OPPOSING_TORQUE:
            hand_out(kept, i, at, opposing[row])
        else:
            hand_out(kept, i, at, imposing_torque(imposed, row, sample, period, torque))
