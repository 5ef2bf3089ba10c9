"""What the drives command, once a sample."""

from __future__ import annotations

from numba import njit

from torquerig.simulate.kernel.forces import FAST


@njit(fastmath=FAST, inline="always")
def control(drives, sample, omega, period, integral, command):
    """Fill ``command``: the demand and the PI on the speed, limited; the integrator holds while limited.

    An induction machine has no control: its command is the torque of its slip.
    """
    for i in range(drives.on.size):
        error = drives.reference[i, sample] - omega[drives.on[i]] + omega[drives.against[i]]
        if drives.breakdown[i] > 0.0:
            slip = error / drives.breakdown[i]
            command[i] = 2.0 * drives.limit[i] * slip / (1.0 + slip * slip)
            continue
        wish = drives.demand[i, sample] + drives.kp[i] * error + drives.ki[i] * (integral[i] + error * period)
        if abs(wish) <= drives.limit[i]:
            integral[i] += error * period
            command[i] = wish
        else:
            command[i] = drives.limit[i] if wish > 0.0 else -drives.limit[i]
