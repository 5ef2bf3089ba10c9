"""Tuning of a sampled current loop from resistance, inductance and bandwidth."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

LARGEST_SHARE = 0.1  # of the sampling frequency: 1.5 periods of delay then leave 36 degrees of phase margin


class Gains(NamedTuple):
    """PI gains of a current loop: proportional [V/A], integral [V/(A s)]."""

    proportional: float
    integral: float


def current_gains(*, resistance: float, inductance: float, bandwidth: float) -> Gains:
    """Return PI gains that cancel the winding's pole and leave a first-order lag of ``bandwidth`` [Hz].

    ``kp = a L``, ``ki = a R`` with a = 2 pi bandwidth; a disturbing voltage still decays with L/R.
    Source: Harnefors & Nee 1998, IEEE Trans. Industry Applications 34(1), internal model control.
    """
    return Gains(2 * pi * bandwidth * inductance, 2 * pi * bandwidth * resistance)


def check_bandwidth(bandwidth: float, *, period: float) -> None:
    """Raise ValueError where the bandwidth is too high for a stable loop at this sampling rate."""
    if bandwidth * period > LARGEST_SHARE * (1 + 1e-12):
        raise ValueError(
            f"bandwidth: {bandwidth:g} Hz is more than a tenth of the sampling rate {1 / period:g} Hz, the loop would "
            f"ring; write at most {LARGEST_SHARE / period:g} Hz or shorten the period"
        )


def loop_admittance(*, resistance: float, inductance: float, bandwidth: float, frequency: float) -> complex:
    """Return the current per volt [A/V] that a disturbing voltage of ``frequency`` [Hz] drives through the loop.

    ``s / ((L s + R)(s + a))`` with the gains of ``current_gains``: no current at 0 Hz, 1/(2 a L) and more around the
    bandwidth. The delay of computing and modulation, 1.5 periods, is left out: true below a fifth of the bandwidth
    within 5 %, and within a third at the bandwidth.
    """
    s, pole = 2j * pi * frequency, 2 * pi * bandwidth
    return s / ((inductance * s + resistance) * (s + pole))
