"""A run of an induction machine on its supply: torque and speed over time, from fluxes in the stator's frame."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from torquerig.machines.checks import check_fields
from torquerig.machines.induction import InductionMachine
from torquerig.parameter import Parameter

Floats = NDArray[np.float64]
Fluxes = tuple[complex, complex, float]


@dataclass(frozen=True, kw_only=True)
class InductionSupply:
    """The mains and the winding, in addition to the torque curve.

    ``unbalance`` is the negative-sequence share of the voltage; it makes a torque at twice the supply frequency,
    whatever the slip (Nandi, Toliyat & Li 2005, IEEE Trans. Energy Conversion 20(4)).
    """

    line_voltage: Annotated[float, Parameter("V", "rms voltage line to line", above=0)] = 400.0
    stator_resistance: Annotated[float, Parameter("ohm", "resistance of a stator phase", low=0)] = 0.0
    magnetising_inductance: Annotated[float, Parameter("H", "magnetising inductance", above=0)] = 1.0
    unbalance: Annotated[float, Parameter("1", "negative-sequence share", low=0, high=1)] = 0.0

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True, eq=False)
class InductionRun:
    """Time [s], torque [N*m] and shaft speed [rad/s] at every step."""

    time: Floats
    torque: Floats
    speed: Floats


@dataclass(frozen=True)
class _Circuit:
    """Gamma circuit: the magnetising inductance at the terminals, all leakage in the rotor; space vectors, peak."""

    pairs: int
    voltage: float
    pulse: float
    leakage: float
    rotor_resistance: float
    supply: InductionSupply
    inertia: float
    load: float

    def torque(self, state: Fluxes) -> float:
        stator, rotor, _ = state
        current = stator / self.supply.magnetising_inductance + (stator - rotor) / self.leakage
        return 1.5 * self.pairs * (stator.conjugate() * current).imag

    def slopes(self, time: float, state: Fluxes) -> Fluxes:
        stator, rotor, speed = state
        rotor_current = (rotor - stator) / self.leakage
        current = stator / self.supply.magnetising_inductance - rotor_current
        forward = complex(np.cos(self.pulse * time), np.sin(self.pulse * time))
        volts = self.voltage * (forward + self.supply.unbalance * forward.conjugate())
        return (
            volts - self.supply.stator_resistance * current,
            1j * self.pairs * speed * rotor - self.rotor_resistance * rotor_current,
            (self.torque(state) - self.load) / self.inertia,
        )


def run_induction(
    machine: InductionMachine,
    supply: InductionSupply,
    *,
    inertia: float,
    load_torque: float,
    duration: float,
    initial_speed: float = 0.0,
    step: float = 2e-4,
) -> InductionRun:
    """Return the run against a constant ``load_torque`` [N*m], from ``initial_speed`` [rad/s], already magnetised.

    Leakage and rotor resistance follow from breakdown torque and slip, ``L = 3 p psi^2 / (4 Tb)`` and
    ``R = sb w L`` with psi = U/w, so that without stator resistance the steady states lie on the Kloss curve.
    Runge-Kutta 4 in the stator's frame, for seconds and not for hours. Source: Slemon 1989, IEEE Trans. Industry
    Applications 25(6), Gamma circuit.
    """
    pulse = 2 * pi * machine.supply_frequency
    voltage = supply.line_voltage * sqrt(2 / 3)
    flux = voltage / pulse
    leakage = 0.75 * machine.pole_pairs * flux**2 / machine.breakdown_torque
    resistance = machine.breakdown_slip * pulse * leakage
    circuit = _Circuit(machine.pole_pairs, voltage, pulse, leakage, resistance, supply, inertia, load_torque)
    start = -1j * flux * (1 - supply.unbalance)
    state: Fluxes = (start, start, initial_speed)
    steps = max(1, round(duration / step))
    torque, speed = np.empty(steps), np.empty(steps)
    for k in range(steps):
        torque[k], speed[k] = circuit.torque(state), state[2]
        state = _stepped(circuit, k * step, state, step)
    return InductionRun(step * np.arange(steps, dtype=np.float64), torque, speed)


def _stepped(circuit: _Circuit, time: float, state: Fluxes, step: float) -> Fluxes:
    first = circuit.slopes(time, state)
    second = circuit.slopes(time + step / 2, _moved(state, first, step / 2))
    third = circuit.slopes(time + step / 2, _moved(state, second, step / 2))
    fourth = circuit.slopes(time + step, _moved(state, third, step))
    for slope, weight in ((first, 1), (second, 2), (third, 2), (fourth, 1)):
        state = _moved(state, slope, weight * step / 6)
    return state


def _moved(state: Fluxes, slope: Fluxes, step: float) -> Fluxes:
    return state[0] + step * slope[0], state[1] + step * slope[1], state[2] + step * slope[2]
