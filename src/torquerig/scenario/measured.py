"""The measured places of a scenario: ``measured: torque_sensor`` or ``measured: [input_sensor, tacho]``."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from torquerig.document import Document
from torquerig.errors import InputError, did_you_mean
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import ImposedMotion, Probe

NAMED = "measured"


def with_measured(rig: Rig, document: Document) -> Rig:
    """Return the rig with the measured places that the document states; the first torque or force is ``measured``.

    Raises
    ------
    InputError
        With file and line: no name, a name twice, no part of that name, or one that nothing can be read at.
    """
    if NAMED not in document.data:
        return replace(rig, measured=_checked(rig, document, "torque_sensor", (NAMED,)))
    written = document.data[NAMED]
    listed = written if isinstance(written, list) else [written]
    if not listed:
        raise InputError(f"{document.place((NAMED,))}: no place is named; name a sensor, gear or coupling")
    names = [
        _checked(rig, document, one, (NAMED, row) if isinstance(written, list) else (NAMED,))
        for row, one in enumerate(listed)
    ]
    twice = next((one for one in names if names.count(one) > 1), None)
    if twice is not None:
        raise InputError(f"{document.place((NAMED,))}: {twice!r} is named twice; name each place once")
    first = next((one for one in names if reads_effort(rig.part(one))), names[0])
    probe = rig.part(first)
    if isinstance(probe, Probe) and probe.quantity == "torque":
        raise InputError(
            f"{document.place((NAMED,))}: {first!r} is a probe, which has no measuring chain; write measured: "
            f"{probe.at}"
        )
    return replace(rig, measured=first, also_measured=tuple(one for one in names if one != first))


def reads_effort(part: Part) -> bool:
    """Whether a torque or force is read at a part: in a spring, or what an imposed motion takes."""
    return part.opens_node or isinstance(part, ImposedMotion)


def written_measured(rig: Rig) -> Any:
    """Return the measured places as a scenario states them: one name, or a list."""
    return list(rig.places) if rig.also_measured else rig.measured


def _checked(rig: Rig, document: Document, name: Any, keys: tuple[str | int, ...]) -> str:
    known = {part.name: part for part in rig.parts}
    text = str(name)
    if isinstance(name, dict | list) or text not in known:
        readable = [each for each, part in known.items() if _readable(part)]
        near = did_you_mean(text, known) if not isinstance(name, dict | list) else f"name one of {', '.join(readable)}"
        raise InputError(f"{document.place(keys)}: the rig has no part {text!r}; {near}")
    if not _readable(known[text]):
        raise InputError(
            f"{document.place(keys)}: {text!r} has no spring whose torque could be read; name a sensor, gear or "
            "coupling, an imposed_motion for what it takes, or add a speed_sensor, acceleration_sensor or "
            f"current_sensor with at: {text}"
        )
    return text


def _readable(part: Part) -> bool:
    return reads_effort(part) or part.is_sensor or isinstance(part, Probe)
