"""Which column of a recording is which measured place of a scenario, by ``of: PART`` in its sidecar."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from torquerig.errors import InputError, did_you_mean
from torquerig.recordings.files.sidecar_choice import place_in_sidecar
from torquerig.recordings.recording import EFFORTS, Channel, Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import ImposedMotion
from torquerig.rig.reading_place import reading_place
from torquerig.rig.sensor_reading import mounting_sign
from torquerig.scenario.measured import reads_effort

_TAKEN = (None, "compared")  # roles of a channel that may be the compared one


def as_measured(recordings: Sequence[Recording], rig: Rig) -> list[Recording]:
    """Return the recordings with the channel of ``rig.measured`` as the compared one, and other torques as context.

    The compared channel is corrected by what the scenario states of its sensor: mounted the other way round, a true
    scale, a zero.

    Raises
    ------
    InputError
        With the sidecar's file, line and key: an ``of:`` that names no part of the rig; several columns of which none
        is stated to be of the measured part; columns that are all of other parts.
    """
    return [_as_measured(one, rig) for one in recordings]


def what_is_compared(recording: Recording, rig: Rig) -> str | None:
    """Return in a sentence which of several measured channels is compared; None where there is no choice."""
    known = _efforts(recording, rig)
    others = [f"{name} of {one.of}" if one.of else name for name, one in known.items() if one.role == "context"]
    if not (others or rig.also_measured):
        return None
    compared = next((name for name, one in known.items() if one.role == "compared"), "none")
    aside = f"; context: {', '.join(others)}" if others else ""
    return f"{recording.name}: compared: {compared} of {rig.measured}{aside}"


def _as_measured(recording: Recording, rig: Rig) -> Recording:
    check_parts(recording, rig)
    known = _efforts(recording, rig)
    name = _compared(recording, rig, known)
    if name is None:
        return recording
    channels = {
        key: replace(one, role="context") if key in known and one.role in _TAKEN else one
        for key, one in recording.channels.items()
    }
    corrected = _corrected(recording.channels[name], rig.part(rig.measured))
    return replace(recording, channels={**channels, name: replace(corrected, role="compared")})


def check_parts(recording: Recording, rig: Rig) -> None:
    """Raise InputError, with the sidecar's file and line, for an ``of:`` that names no part of the rig."""
    names = [part.name for part in rig.parts]
    for key, one in recording.channels.items():
        if one.of is not None and not one.truth and one.of not in names:
            raise InputError(
                f"{place_in_sidecar(recording, 'channels', key, 'of')}: the scenario's rig has no part {one.of!r}; "
                f"{did_you_mean(one.of, names)}"
            )


def _efforts(recording: Recording, rig: Rig) -> dict[str, Channel]:
    """Return the channels that may be what ``rig.measured`` reads."""
    kinds = (*EFFORTS, "motor_torque") if isinstance(rig.part(rig.measured), ImposedMotion) else EFFORTS
    return {
        name: one for name, one in recording.channels.items()
        if one.quantity in kinds and not one.truth and one.role != "input"
    }  # fmt: skip


def _compared(recording: Recording, rig: Rig, known: dict[str, Channel]) -> str | None:
    """Return the name of the compared channel; None where the recording has none that may be."""
    free = {name: one for name, one in known.items() if one.role in _TAKEN}
    here = (rig.measured, reading_place(rig))
    named = [name for name, one in free.items() if one.of in here]
    if len(named) > 1:
        named = [name for name in named if free[name].role == "compared"] or named
    if len(named) == 1:
        return named[0]
    unnamed = {name: one for name, one in free.items() if one.of is None}
    chosen = [name for name, one in unnamed.items() if one.role == "compared"] or _first_kind(unnamed)
    if not named and len(chosen) == 1 and (free[chosen[0]].role == "compared" or _one_effort(rig)):
        return chosen[0]
    several = named or chosen
    if several:
        raise InputError(
            f"{place_in_sidecar(recording, 'channels', several[0])}: nothing states whether {' or '.join(several)} is "
            f"what the scenario measures at {rig.measured!r}; write of: {rig.measured} into the entry of that one, and "
            "of: with the part, or role: context, into every other one"
        )
    if free:
        raise InputError(_of_other_parts(recording, rig, free))
    return None


def _one_effort(rig: Rig) -> bool:
    """Whether the scenario measures a torque or force at one place only."""
    return sum(reads_effort(rig.part(place)) for place in rig.places) == 1


def _first_kind(channels: dict[str, Channel]) -> list[str]:
    """Return the channels of the first quantity that any has: a torque before a force before a torque of the motor."""
    for quantity in (*EFFORTS, "motor_torque"):
        named = [name for name, one in channels.items() if one.quantity == quantity]
        if named:
            return named
    return []


def _of_other_parts(recording: Recording, rig: Rig, free: dict[str, Channel]) -> str:
    first = next(iter(free))
    read = " and ".join(f"{name} of {one.of}" for name, one in free.items())
    return (
        f"{place_in_sidecar(recording, 'channels', first, 'of')}: the scenario measures {rig.measured!r} first, and "
        f"the recording has {read}; write measured: {free[first].of} into the scenario, or correct of:"
    )


def _corrected(channel: Channel, part: Part) -> Channel:
    """Return the channel as an ideal sensor of the scenario's sense reads it.

    A sensor that is mounted the other way round and a negative scale in the sidecar state the same, and count once.
    """
    if not part.is_sensor:
        return channel
    scale, zero = float(getattr(part, "scale", 1.0)), float(getattr(part, "zero", 0.0))
    per_unit = channel.si_per_unit
    values = channel.values if zero == 0.0 else channel.values - zero / abs(per_unit)
    if mounting_sign(part) < 0:
        per_unit = -abs(per_unit)
    return replace(channel, values=values, si_per_unit=per_unit if scale == 1.0 else per_unit / scale)


def without_sensor_errors(rig: Rig) -> Rig:
    """Return the rig whose compared sensor reads as its data sheet states, to compare with corrected recordings."""
    part = rig.part(rig.measured)
    changes: dict[str, Any] = {key: _IDEAL[key] for key in _errors(part)}
    return rig.changed(replace(part, **changes)) if changes else rig


def with_sensor_errors(rig: Rig, stated: Rig) -> Rig:
    """Return a rig that was compared as ``without_sensor_errors`` with the sensor's stated errors in it again."""
    part, own = rig.part(stated.measured), stated.part(stated.measured)
    changes = _errors(own)
    if "scale" in changes:
        changes["scale"] *= getattr(part, "scale", 1.0)
    return rig.changed(replace(part, **changes)) if changes else rig


_IDEAL = {"scale": 1.0, "zero": 0.0, "mounting": "forward"}


def _errors(part: Part) -> dict[str, Any]:
    """Return what is stated of a sensor that does not read as its data sheet states."""
    stated = {key: getattr(part, key, ideal) for key, ideal in _IDEAL.items()} if part.is_sensor else {}
    return {key: value for key, value in stated.items() if value != _IDEAL[key]}
