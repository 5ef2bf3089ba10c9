"""Field-oriented control: a sampled current loop in the rotor's frame, with dead time and sensor errors."""

from __future__ import annotations

from dataclasses import dataclass
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

Pair = tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class FieldOriented(Control):
    """PI on i_d = 0 and i_q, decoupled, with the fundamental EMF fed forward and one period of delay.

    The voltage vector is limited to U_dc/sqrt(3), the circle of space-vector modulation. Phases a and b are measured
    (``current_offset`` [A], ``current_gain`` relative error), c is minus their sum. ``dead_time`` takes
    U_dc t_d / period from each phase in the direction of its current (Jeong & Park 1991, IEEE Trans. Industrial
    Electronics 38(2)); one switching period per sampling period; nothing compensates it. ``angle_error`` [electrical
    rad] is what the encoder's zero is off.
    """

    dc_link: Annotated[float, Parameter("V", "DC-link voltage", above=0)]
    period: Annotated[float, Parameter("s", "sampling period", above=0)] = 40e-6
    bandwidth: Annotated[float, Parameter("Hz", "bandwidth of the current loop", above=0)] = 1000.0
    dead_time: Annotated[float, Parameter("s", "dead time of a leg", low=0)] = 0.0
    current_offset: Annotated[Pair, Parameter("A", "offsets of the sensors in a and b")] = (0.0, 0.0)
    current_gain: Annotated[Pair, Parameter("1", "gain errors of the sensors in a and b", above=-1)] = (0.0, 0.0)
    angle_error: Annotated[float, Parameter("rad", "error of the electrical angle")] = 0.0

    def __post_init__(self) -> None:
        check_fields(self)
        check_bandwidth(self.bandwidth, period=self.period)
        if self.dead_time >= 0.5 * self.period:
            raise ValueError(
                f"FieldOriented.dead_time: {self.dead_time:g} s leaves nothing of a period of {self.period:g} s"
            )

    def torque_per_ampere(self, machine: PermanentMagnetMachine) -> float:
        """Return 3/2 p lambda times the fundamental of the shape [N*m/A peak]."""
        return 1.5 * machine.pole_pairs * machine.flux_linkage * machine.back_emf.fundamental

    def integrate(
        self, machine: PermanentMagnetMachine, *, shaft: Shaft, demand: Demand, periods: int, substeps: int
    ) -> NDArray[np.float64]:
        """Run the compiled loop."""
        gains = current_gains(
            resistance=machine.phase_resistance, inductance=machine.phase_inductance, bandwidth=self.bandwidth
        )
        row = kernel.FieldOriented(
            self.dc_link,
            gains.proportional,
            gains.integral,
            self.dc_link * self.dead_time / self.period,
            *self.current_offset,
            *self.current_gain,
            self.angle_error,
            machine.flux_linkage * machine.back_emf.fundamental,
        )
        reference = demand.kernel_row(self.torque_per_ampere(machine))
        clock = kernel.Clock(self.period, periods, substeps)
        return np.asarray(kernel.field_oriented(machine_row(machine), shaft.kernel_row(), reference, row, clock))
