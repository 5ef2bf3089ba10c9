"""The hum of one run: its phase is its own in every recording, so it is read off what the rest of the model leaves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.moved import BAND, Moved
from torquerig.recordings.sampled_motion import low_passed
from torquerig.rig.assembly import Part, Rig

Floats = NDArray[np.float64]


def hums_of(rig: Rig) -> tuple[Part, ...]:
    """Return the parts of a rig that hum."""
    return rig.of_kind("mains_interference")


def hum_in(hums: Sequence[Any], run: Moved, left: Floats) -> Floats:
    """Return the hums in a run, low-passed [N m] or [N]: sizes and frequency as the parts state, phases as in ``left``.

    The phases come of what fits may see; of a run that is held out whole, of that run.
    """
    whole, time = np.zeros(run.effort.size), run.recording.time()
    mask = run.seen if run.seen.any() else run.held
    for part in hums:
        sizes = sizes_in(left, time, mask, part.frequency, len(part.amplitudes))
        for harmonic, (size, amplitude) in enumerate(zip(sizes, part.amplitudes, strict=True), start=1):
            whole += amplitude * np.cos(2 * np.pi * harmonic * part.frequency * time + np.angle(size))
    return low_passed(whole, BAND)


def sizes_in(left: Floats, time: Floats, mask: NDArray[np.bool_], frequency: float, count: int) -> list[complex]:
    """Return the complex amplitude of each harmonic by least squares [N m] or [N]."""
    phase = 2 * np.pi * frequency * time[mask]
    columns = [wave(h * phase) for h in range(1, count + 1) for wave in (np.cos, np.sin)]
    found = np.linalg.lstsq(np.column_stack([*columns, np.ones(phase.size)]), left[mask], rcond=None)[0]
    return [complex(found[2 * h], -found[2 * h + 1]) for h in range(count)]
