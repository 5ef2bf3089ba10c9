"""The outputs of a run: the sensor's torque, the truth channels, and the probes of the rig."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Channel
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ForceSensor, ImposedMotion, Probe, TorqueSensor
from torquerig.rig.reading_place import reading_place
from torquerig.rig.terms import Load
from torquerig.simulation import kernel
from torquerig.simulation.arrays import Outputs
from torquerig.simulation.lower import Lowered


@dataclass(frozen=True)
class Output:
    """One row of the kernel's output and the channel that it becomes."""

    name: str
    kind: int
    row: int
    quantity: str
    unit: str
    truth: bool = True


@dataclass(frozen=True)
class Words:
    """Outputs of a shaft or of a part in a line: (quantity, ending of a name, unit) of each thing kept."""

    effort: tuple[str, str, str]
    rate: tuple[str, str, str]
    place: tuple[str, str, str]
    motor: tuple[str, str, str]  # quantities of the driven side: effort, rate, place


TURNING = Words(
    ("torque", "Nm", "N*m"), ("speed", "rad_s", "rad/s"), ("angle", "rad", "rad"),
    ("motor_torque", "motor_speed", "motor_angle"),
)  # fmt: skip
IN_A_LINE = Words(
    ("force", "N", "N"), ("velocity", "m_s", "m/s"), ("position", "m", "m"), ("force", "velocity", "position")
)
_KINDS = {"torque": kernel.SPRING_TORQUE, "speed": kernel.SPEED, "angle": kernel.ANGLE}


def outputs_of(rig: Rig, lowered: Lowered) -> tuple[Output, ...]:
    """Return the outputs: first the measured one (a spring, an imposed motion), then truth channels and probes."""
    motor, part = lowered.node(lowered.leader()), _worn(rig, lowered)
    here, driven = words(rig, reading_place(rig)), words(rig, lowered.leader())
    effort, rate = here.effort, here.rate
    kind, row = _measured(rig, lowered)
    listed = [
        Output(f"true_sensor_{effort[0]}_{effort[1]}", kind, row, effort[0], effort[2]),
        Output(f"true_load_{effort[1]}", kernel.OPPOSING_TORQUE, part, effort[0], effort[2]),
        Output(_named("motor", driven.place), kernel.ANGLE, motor, driven.motor[2], driven.place[2]),
        Output(_named("motor", driven.rate), kernel.SPEED, motor, driven.motor[1], driven.rate[2]),
        Output(_named("output", rate), kernel.SPEED, part, rate[0], rate[2]),
    ]  # fmt: skip
    if lowered.drive_terms:
        name = _named("motor", driven.effort)
        listed.append(Output(name, kernel.DRIVE_TORQUE, 0, driven.motor[0], driven.effort[2]))
    for row, term in enumerate(lowered.imposed_terms):
        taken = words(rig, term.on)
        if not term.released:
            name = _named(term.name, taken.effort)
            listed.append(Output(name, kernel.IMPOSING_TORQUE, row, taken.motor[0], taken.effort[2]))
    return (*listed, *(_probed(rig, lowered, probe) for probe in rig.parts_of(Probe)))


def _measured(rig: Rig, lowered: Lowered) -> tuple[int, int]:
    if isinstance(rig.part(rig.measured), ImposedMotion):
        return kernel.IMPOSING_TORQUE, [term.name for term in lowered.imposed_terms].index(rig.measured)
    return kernel.SPRING_TORQUE, lowered.spring_names.index(rig.measured)


def words(rig: Rig, part: str) -> Words:
    """Return the outputs at the node of a part."""
    return IN_A_LINE if any(one.in_a_line for one in rig.parts if one.name == part) else TURNING


def _named(what: str, quantity: tuple[str, str, str]) -> str:
    return f"true_{what}_{quantity[0]}_{quantity[1]}"


def _probed(rig: Rig, lowered: Lowered, probe: Probe) -> Output:
    here, spring = words(rig, probe.at), probe.quantity == "torque"
    quantity, ending, unit = {"torque": here.effort, "speed": here.rate, "angle": here.place}[probe.quantity]
    row = lowered.spring_names.index(probe.at) if spring else lowered.node(rig.node(probe.at))
    return Output(f"{probe.name}_{ending}", _KINDS[probe.quantity], row, quantity, unit, truth=False)


def as_arrays(outputs: tuple[Output, ...]) -> Outputs:
    """Return the outputs in the layout of the kernel."""
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
    sensitivity = sensor.sensitivity if isinstance(sensor, TorqueSensor | ForceSensor) else 1.0
    quantity, ending, unit = words(rig, reading_place(rig)).effort
    reading = Channel(values=kept[0] * sensitivity, quantity=quantity, unit="V", si_per_unit=1 / sensitivity)
    if isinstance(sensor, ImposedMotion):
        reading = replace(reading, unit=unit)
    else:
        ending = "V"
    return {f"{quantity}_{ending}": reading} | {
        output.name: Channel(values=values, quantity=output.quantity, unit=output.unit, truth=output.truth)
        for output, values in zip(outputs, kept, strict=True)
    }


def _worn(rig: Rig, lowered: Lowered) -> int:
    """Return the node that carries the load; without one, the output side of the measured part."""
    carrying = [term.on for term in lowered.load_terms if isinstance(term, Load)]
    carrying += [term.on for term in lowered.angle_load_terms]
    return lowered.node(carrying[0] if carrying else rig.node(reading_place(rig)))
