"""What a run keeps: the sensor's torque, the truth beside it, and the probes of the rig."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.parts import Probe, TorqueSensor
from torquerig.rig.rig import Rig
from torquerig.rig.terms import Load
from torquerig.signals.recording import Channel
from torquerig.simulate import kernel
from torquerig.simulate.arrays import Outputs
from torquerig.simulate.lower import Lowered


@dataclass(frozen=True)
class Output:
    """One row of the kernel's output and the channel that it becomes."""

    name: str
    kind: int
    row: int
    quantity: str
    unit: str
    truth: bool = True


_PROBED = {
    "torque": (kernel.SPRING_TORQUE, "_Nm", "N*m"),
    "speed": (kernel.SPEED, "_rad_s", "rad/s"),
    "angle": (kernel.ANGLE, "_rad", "rad"),
}


def outputs_of(rig: Rig, lowered: Lowered) -> tuple[Output, ...]:
    """Return what the kernel is to keep: first the torque in the measured spring, then truth, then probes."""
    motor = lowered.node(lowered.leader())
    part = _worn(rig, lowered)
    listed = [
        Output(
            "true_sensor_torque_Nm", kernel.SPRING_TORQUE, lowered.spring_names.index(rig.measured), "torque", "N*m"
        ),
        Output("true_load_Nm", kernel.OPPOSING_TORQUE, part, "torque", "N*m"),
        Output("true_motor_angle_rad", kernel.ANGLE, motor, "motor_angle", "rad"),
        Output("true_motor_speed_rad_s", kernel.SPEED, motor, "motor_speed", "rad/s"),
        Output("true_output_speed_rad_s", kernel.SPEED, part, "speed", "rad/s"),
    ]
    if lowered.drive_terms:
        listed.append(Output("true_motor_torque_Nm", kernel.DRIVE_TORQUE, 0, "motor_torque", "N*m"))
    for row, term in enumerate(lowered.imposed_terms):
        if not term.released:
            listed.append(Output(f"true_{term.name}_torque_Nm", kernel.IMPOSING_TORQUE, row, "motor_torque", "N*m"))
    for probe in rig.parts_of(Probe):
        kind, suffix, unit = _PROBED[probe.quantity]
        spring = probe.quantity == "torque"
        row = lowered.spring_names.index(probe.at) if spring else lowered.node(rig.node(probe.at))
        listed.append(Output(probe.name + suffix, kind, row, probe.quantity, unit, truth=False))
    return tuple(listed)


def as_arrays(outputs: tuple[Output, ...]) -> Outputs:
    """Return the outputs as the kernel takes them."""
    kinds, rows = ([getattr(output, field) for output in outputs] for field in ("kind", "row"))
    return Outputs(np.array(kinds, dtype=np.uint64), np.array(rows, dtype=np.uint64))


def channels_of(rig: Rig, outputs: tuple[Output, ...], kept: NDArray[np.float64]) -> dict[str, Channel]:
    """Return the channels of a run: the sensor's voltage before its stages, and one per output.

    Parameters
    ----------
    kept : ndarray, shape (outputs, samples)
        In SI units.
    """
    sensor = rig.part(rig.measured)
    sensitivity = sensor.sensitivity if isinstance(sensor, TorqueSensor) else 1.0
    volts = Channel(values=kept[0] * sensitivity, quantity="torque", unit="V", si_per_unit=1 / sensitivity)
    return {"torque_V": volts} | {
        output.name: Channel(values=values, quantity=output.quantity, unit=output.unit, truth=output.truth)
        for output, values in zip(outputs, kept, strict=True)
    }


def _worn(rig: Rig, lowered: Lowered) -> int:
    """Return the node that carries the load; without one, the output side of the measured part."""
    carrying = [term.on for term in lowered.load_terms if isinstance(term, Load)]
    carrying += [term.on for term in lowered.angle_load_terms]
    return lowered.node(carrying[0] if carrying else rig.node(rig.measured))
