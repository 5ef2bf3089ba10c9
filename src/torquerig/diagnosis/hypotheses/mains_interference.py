"""Hum of the mains: lines at multiples of 50 or 60 Hz that stay where they are when the speed changes."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.hypotheses.fixed_lines import fixed_lines
from torquerig.diagnosis.looking.hum import ALWAYS, fundamental, harmonics_of
from torquerig.inference.knobs import Knob
from torquerig.recordings.repair.mains_hum import GRIDS

_START = 2e-3  # [V]
_OFF = 0.03  # [Hz] by which two harmonics may differ in the grid's frequency


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a hum for each grid of which a fixed line is a multiple.

    Beside one that sounds all along its further harmonics are its own, however hidden among other lines.
    """
    lines = fixed_lines(case)
    for grid in GRIDS:
        found = harmonics_of(grid, lines)
        if not found:
            continue
        at = fundamental(found)
        further = harmonics_of(grid, case.left)
        found = {
            **{n: peak for n, peak in further.items() if abs(peak.place.at / n - at) < _OFF},
            **found,
        }
        listed = sorted({*found, *ALWAYS})
        part = mechanisms.MainsInterference(
            name="mains_interference",
            frequency=fundamental(found),
            amplitudes=tuple(_START if harmonic in listed else 0.0 for harmonic in range(1, max(listed) + 1)),
        )
        yield Candidate(
            mechanism="mains_interference",
            parts=(part,),
            knobs=tuple(Knob(part.name, "amplitudes", 1.5, key=harmonic - 1) for harmonic in listed),
            place=max(found.values(), key=lambda peak: peak.excess).place,
            variant=f"{grid:g} Hz",
        )
