"""Six-step commutation: two phases, selected by three Hall sensors, carry the current for 60 degrees each."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from torquerig.machines import kernel
from torquerig.machines.checks import check_fields
from torquerig.machines.control import Control
from torquerig.machines.current_loop import check_bandwidth, current_gains
from torquerig.machines.demand import Demand
from torquerig.machines.machine_row import machine_row
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.shaft import Shaft
from torquerig.parameter import Parameter

Floats = NDArray[np.float64]
Errors = tuple[float, float, float]

FIRST_EDGE = np.array([pi / 6, 5 * pi / 6, 9 * pi / 6])  # where sensors a, b, c rise; each stays high for half a turn
HALL_LIMIT = pi / 6  # beyond it two edges may change places


@dataclass(frozen=True, kw_only=True)
class SixStep(Control):
    """The active pair is held at the demanded current by PI and a DC link that can only give so much.

    The regulated current is half the difference of the two active phases. At a Hall edge the phase that leaves
    discharges through its diode into a rail until its current is zero, and then stays open (it conducts again where its
    voltage would pass a rail). The ripple of the commutation emerges from that: see Carlson, Lajoie-Mazenc & Fagundes
    1992, IEEE Trans. Industry Applications 28(3). Edges act at once, the PI once per period, one period late.

    ``hall_shift`` [electrical rad] moves a sensor: both its edges come late by as much, which repeats every half
    electrical turn (orders 2p, 4p, 6p). ``hall_width`` lengthens its high state (unequal poles of the sensor magnet,
    switching hysteresis), which repeats only every turn (orders p, 3p as well).
    """

    dc_link: Annotated[float, Parameter("V", "DC-link voltage", above=0)]
    period: Annotated[float, Parameter("s", "sampling period", above=0)] = 40e-6
    bandwidth: Annotated[float, Parameter("Hz", "bandwidth of the current loop", above=0)] = 1000.0
    hall_shift: Annotated[Errors, Parameter("rad", "shift", low=-HALL_LIMIT, high=HALL_LIMIT)] = (0.0, 0.0, 0.0)
    hall_width: Annotated[Errors, Parameter("rad", "extra width", low=-HALL_LIMIT, high=HALL_LIMIT)] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        check_fields(self)
        check_bandwidth(self.bandwidth, period=self.period)
        if np.any(np.diff(self.sector_starts()) <= 0):
            raise ValueError("SixStep: hall_shift and hall_width let two Hall edges change places; write smaller ones")

    def sector_starts(self) -> Floats:
        """Return the electrical angles [rad] at which the six sectors begin, from a+b- on, and the first again."""
        shift, half = np.array(self.hall_shift), 0.5 * np.array(self.hall_width)
        rise, fall = FIRST_EDGE + shift - half, FIRST_EDGE + shift + half + pi
        a, b, c = range(3)
        turn = 2 * pi
        starts = (rise[a], fall[c] - turn, rise[b], fall[a], rise[c], fall[b], rise[a] + turn)
        return np.array(starts)

    def torque_per_ampere(self, machine: PermanentMagnetMachine) -> float:
        """Return the mean torque of one ampere in the right pair [N*m/A]: 2 p lambda with a trapezoid."""
        angle = pi / 6 + (np.arange(2048) + 0.5) / 2048 * pi / 3
        pair = machine.back_emf.shape(angle) - machine.back_emf.shape(angle - 2 * pi / 3)
        return machine.pole_pairs * machine.flux_linkage * float(np.mean(pair))

    def integrate(
        self, machine: PermanentMagnetMachine, *, shaft: Shaft, demand: Demand, periods: int, substeps: int
    ) -> Floats:
        """Run the compiled loop."""
        gains = current_gains(
            resistance=2 * machine.phase_resistance, inductance=2 * machine.phase_inductance, bandwidth=self.bandwidth
        )
        row = kernel.SixStep(self.dc_link, gains.proportional, gains.integral, self.sector_starts())
        reference = demand.kernel_row(self.torque_per_ampere(machine))
        clock = kernel.Clock(self.period, periods, substeps)
        return np.asarray(kernel.six_step(machine_row(machine), shaft.kernel_row(), reference, row, clock))


def ideal_six_step_currents(electrical_angle: Floats, *, current: float) -> Floats:
    """Return the blocks of 120 degrees that an infinitely fast current loop gives, shape (n, 3) [A]."""
    sector = np.floor((np.asarray(electrical_angle) - pi / 6) / (pi / 3)).astype(np.int64) % 6
    currents = np.zeros((sector.size, 3))
    rows = np.arange(sector.size)
    currents[rows, kernel.POSITIVE[sector]] = current
    currents[rows, kernel.NEGATIVE[sector]] = -current
    return currents
