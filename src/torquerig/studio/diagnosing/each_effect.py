"""How much each part that a diagnosis added changes the reading: the completed rig, simulated with and without it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.reading_place import effort_unit
from torquerig.simulation.simulator import simulate

LONGEST = 4.0  # [s] of a simulated reading: some tens of turns of an output shaft at usual speeds
HEAD = ("effect", "kind", "change of the reading", "largest in")


def each_effect(
    completed: Rig, nominal: Rig, recordings: Sequence[Recording], *, seed: int
) -> tuple[tuple[str, str, str, str], ...]:  # fmt: skip
    """Return one row under ``HEAD`` per part that the nominal rig lacks.

    All other parameters and random numbers are alike; of the conditions of the recordings the largest change counts.

    Parameters
    ----------
    completed, nominal : Rig
    recordings : sequence of Recording
        Whose conditions are simulated, for 4 s at most.
    """
    known = {part.name for part in nominal.parts}
    added = [part for part in completed.parts if part.name not in known]
    if not added:
        return ()
    readings = {one.name: _reading(completed, one, seed) for one in recordings}
    return tuple(_row(part, completed, recordings, readings, seed) for part in added)


def _row(
    part: Part, completed: Rig, recordings: Sequence[Recording], readings: dict[str, NDArray[np.float64]], seed: int
) -> tuple[str, str, str, str]:
    unit = effort_unit(completed).replace("*", " ")
    try:
        rms, name = max(_changes(completed.without(part.name), recordings, readings, seed))
    except TorquerigError as error:  # another part sits on it
        return (part.name, part.kind.replace("_", " "), f"not computed: {error}", "")
    return (part.name, part.kind.replace("_", " "), f"{rms:.3g} {unit} rms", name)


def _changes(
    without: Rig, recordings: Sequence[Recording], readings: dict[str, NDArray[np.float64]], seed: int
) -> Iterator[tuple[float, str]]:
    for one in recordings:
        difference = readings[one.name] - _reading(without, one, seed)
        yield float(np.sqrt(np.mean(difference**2))), one.name


def _reading(rig: Rig, recording: Recording, seed: int) -> NDArray[np.float64]:
    length = min(recording.duration, LONGEST)
    made = simulate(rig.at(recording.run), duration=length, seed=seed, sample_rate=recording.sample_rate)
    return made.torque()
