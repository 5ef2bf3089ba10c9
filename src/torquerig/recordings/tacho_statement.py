"""The pulses of a tacho as its entry in a sidecar states them: ``pulses_per_rev: 1`` or ``teeth: 60``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.recordings.tacho_edges import PER_MOTOR_TURN, PER_OUTPUT_TURN

if TYPE_CHECKING:
    from torquerig.document import Document
    from torquerig.recordings.files.sidecar_schema import WrittenSidecar

PULSES = "pulses_per_rev"
_PER_TURN_OF = {"motor": PER_MOTOR_TURN, "output": PER_OUTPUT_TURN}


def tacho_conditions(document: Document, written: WrittenSidecar) -> dict[str, float]:
    """Return the pulses of the tacho per turn of its shaft, by their key among the run's conditions; empty without.

    Raises
    ------
    InputError
        For pulses, teeth or a shaft at a channel that is no tacho, both counts with different values, a shaft without
        a count, or a second statement of the pulses.
    """
    found: dict[str, float] = {}
    for name, entry in (written.channels or {}).items():
        stated = {PULSES: entry.pulses_per_rev, "teeth": entry.teeth, "shaft": entry.shaft}
        keys = [key for key, value in stated.items() if value is not None]
        if not keys:
            continue
        place = document.place(("channels", name, keys[0]))
        if entry.quantity != "tacho":
            raise InputError(f"{place}: belongs to a tacho, and {name} is a {entry.quantity}; remove it")
        if keys == ["shaft"]:
            raise InputError(f"{place}: the tacho states its shaft and no pulses; add {PULSES}: N")
        if entry.pulses_per_rev is not None and entry.teeth not in (None, entry.pulses_per_rev):
            raise InputError(f"{place}: {entry.pulses_per_rev:g} pulses and {entry.teeth} teeth contradict; keep one")
        key = _PER_TURN_OF[entry.shaft or "motor"]
        run = written.run
        if found or (run is not None and (run.tacho_pulses_per_motor_turn or run.tacho_pulses_per_output_turn)):
            raise InputError(f"{place}: the pulses of a tacho are stated twice; keep one statement")
        found[key] = float(entry.pulses_per_rev or entry.teeth or 0)
    return found
