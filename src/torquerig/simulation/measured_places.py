"""The measured places of a rig: what each reads, its channel, and its measuring chain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import isclose

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import EFFORTS, Channel, Recording, random_for
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.leading_part import leading_part
from torquerig.rig.parts import (
    AccelerationSensor,
    CurrentSensor,
    ForceSensor,
    ImposedMotion,
    Probe,
    SpeedSensor,
)
from torquerig.rig.reading_place import reading_place
from torquerig.rig.sensor_reading import mounting_sign
from torquerig.simulation import kernel
from torquerig.simulation.lower import Lowered


@dataclass(frozen=True)
class Output:
    """One row of the kernel's output and the channel that it becomes.

    ``factor`` multiplies the row; where ``derived``, its derivative over time is the channel.
    """

    name: str
    kind: int
    row: int
    quantity: str
    unit: str
    truth: bool = True
    of: str | None = None
    role: str | None = None
    factor: float = 1.0
    derived: bool = False

    def values(self, kept: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
        """Return the channel's samples from the kernel's row, both in SI, shape (samples,)."""
        if self.derived:
            from scipy.interpolate import CubicSpline

            kept = CubicSpline(np.arange(kept.size) / rate, kept).derivative()(np.arange(kept.size) / rate)
        return kept if self.factor == 1.0 else self.factor * kept


@dataclass(frozen=True)
class Words:
    """Outputs of a shaft or of a part in a line: (quantity, ending of a name, unit) of each thing kept."""

    effort: tuple[str, str, str]
    rate: tuple[str, str, str]
    place: tuple[str, str, str]
    gain_of_rate: tuple[str, str, str]
    motor: tuple[str, str, str]  # quantities of the driven side: effort, rate, place


TURNING = Words(
    ("torque", "Nm", "N*m"), ("speed", "rad_s", "rad/s"), ("angle", "rad", "rad"),
    ("acceleration", "rad_s2", "rad/s^2"),
    ("motor_torque", "motor_speed", "motor_angle"),
)  # fmt: skip
IN_A_LINE = Words(
    ("force", "N", "N"), ("velocity", "m_s", "m/s"), ("position", "m", "m"), ("acceleration", "m_s2", "m/s^2"),
    ("force", "velocity", "position"),
)  # fmt: skip
CURRENT = ("current", "A", "A")


def words(rig: Rig, part: str) -> Words:
    """Return the outputs at the node of a part."""
    return IN_A_LINE if any(one.in_a_line for one in rig.parts if one.name == part) else TURNING


def what_is_read(rig: Rig, place: str) -> tuple[str, str, str]:
    """Return quantity, ending of a name and SI unit of what a measured place reads."""
    part, here = rig.part(place), words(rig, reading_place(rig, place))
    if isinstance(part, Probe):
        return {"torque": here.effort, "speed": here.rate, "angle": here.place, "acceleration": here.gain_of_rate}[
            part.quantity
        ]
    if isinstance(part, SpeedSensor):
        return here.rate
    if isinstance(part, AccelerationSensor):
        return here.gain_of_rate
    return CURRENT if isinstance(part, CurrentSensor) else here.effort


def on_shaft(rig: Rig, place: str) -> tuple[str, str | None]:
    """Return the quantity and the role of what a place reads, by the shaft that it is on.

    A speed or angle of the shaft that the set-point belongs to is that of the motor. One of another shaft than the
    compared torque's is context: no command may take it for the speed of the output.
    """
    quantity, part = what_is_read(rig, place)[0], reading_place(rig, place)
    leader = leading_part(rig)
    if quantity not in ("speed", "angle") or leader is None or leader not in {one.name for one in rig.parts}:
        return quantity, None
    ratios = rig.speed_ratios(rig.node(leader))
    turns, read = ratios.get(rig.node(part)), ratios.get(rig.node(reading_place(rig)))
    if turns is not None and isclose(turns, 1.0, rel_tol=1e-9):
        return f"motor_{quantity}", None
    alike = turns is not None and read is not None and isclose(abs(turns), abs(read), rel_tol=1e-9)
    return quantity, None if alike else "context"


def place_output(rig: Rig, lowered: Lowered, place: str, *, name: str, truth: bool = True) -> Output:
    """Return the output of what a measured place reads, true and in SI."""
    part = rig.part(place)
    quantity, _, unit = what_is_read(rig, place)
    made = Output(name, kernel.SPRING_TORQUE, 0, quantity, unit, truth=truth, of=place)
    if isinstance(part, ImposedMotion):
        row = [term.name for term in lowered.imposed_terms].index(place)
        return replace(made, kind=kernel.IMPOSING_TORQUE, row=row)
    if isinstance(part, CurrentSensor):
        row = [lowered.node(term.on) for term in lowered.drive_terms].index(lowered.node(rig.node(part.at)))
        return replace(made, kind=kernel.DRIVE_TORQUE, row=row, factor=1 / part.newton_metres_per_ampere(rig))
    if isinstance(part, Probe | SpeedSensor | AccelerationSensor) and quantity not in EFFORTS:
        turned = quantity in ("angle", "position")
        return replace(
            made, kind=kernel.ANGLE if turned else kernel.SPEED, row=lowered.node(rig.node(part.at)),
            derived=quantity == "acceleration",
        )  # fmt: skip
    return replace(made, row=lowered.spring(part.at if isinstance(part, Probe) else place))


def channel_name(rig: Rig, place: str) -> str:
    """Return the name of the channel of a place: ``torque_V`` where only one is measured, else by the place."""
    quantity, ending, _ = what_is_read(rig, place)
    if _in_volts(rig, rig.part(place)):
        ending = "V"
    return f"{place if rig.also_measured or isinstance(rig.part(place), Probe) else quantity}_{ending}"


def reading_channel(rig: Rig, place: str, values: NDArray[np.float64]) -> Channel:
    """Return the channel of a place before its measuring chain.

    A sensor mounted the other way round writes the negative, and its scale is negative, so that the channel in SI has
    the sense of the rig.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        What it reads, in SI.
    """
    part, (_, _, unit) = rig.part(place), what_is_read(rig, place)
    sensitivity = part.sensitivity if isinstance(part, AmplifiedTorqueSensor | ForceSensor) else 1.0
    scale = mounting_sign(part) * sensitivity
    quantity, aside = on_shaft(rig, place)
    return Channel(
        values=values * scale, quantity=quantity, unit="V" if _in_volts(rig, part) else unit, si_per_unit=1 / scale,
        of=place, role=aside or role_of(rig, place),
    )  # fmt: skip


def _in_volts(rig: Rig, part: Part) -> bool:
    if isinstance(part, AmplifiedTorqueSensor | ForceSensor):
        return True
    return part.opens_node and not rig.also_measured


def role_of(rig: Rig, place: str) -> str | None:
    """Return ``compared`` for the first of several channels that could be taken for the measured one."""
    if place != rig.measured:
        return None
    read = [what_is_read(rig, one)[0] for one in rig.also_measured]
    read += [what_is_read(rig, probe.name)[0] for probe in rig.parts_of(Probe) if probe.name != place]
    return "compared" if any(one in EFFORTS for one in read) else None


def through_chains(rig: Rig, recording: Recording) -> Recording:
    """Return the recording with the channel of every measured place through its measuring chain."""
    if what_is_read(rig, rig.measured)[0] in EFFORTS:
        for stage in rig.stages():
            recording = stage.apply(recording)
    else:
        recording = _through_chain(rig, recording, rig.measured)
    for place in rig.also_measured:
        recording = _through_chain(rig, recording, place)
    return recording


def _through_chain(rig: Rig, recording: Recording, place: str) -> Recording:
    """Return the recording with one channel through its chain, which takes it for the only torque; with noise alone."""
    stages, name = rig.stages(place), channel_name(rig, place)
    if not stages:
        return recording
    given = recording.channels[name]
    alone: Mapping[str, Channel] = {key: one for key, one in recording.channels.items() if one.truth}
    seed = int(random_for(int(recording.origin.get("seed", 0)), f"sensor {place}").integers(2**62))
    read = replace(
        recording, channels={**alone, name: replace(given, quantity="torque", role=None)},
        origin={**recording.origin, "seed": seed},
    )  # fmt: skip
    for stage in stages:
        read = stage.apply(read)
    done = {**read.channels, name: replace(read.channels[name], quantity=given.quantity, role=given.role)}
    return replace(recording, channels={**recording.channels, **done})
