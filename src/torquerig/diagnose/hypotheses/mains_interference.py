"""Hum of the mains: lines at multiples of 50 or 60 Hz that stay where they are when the speed changes."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.knobs import Knob
from torquerig.diagnose.order_or_fixed import fixed_lines
from torquerig.diagnose.peaks import Peak

_GRIDS = (50.0, 60.0)
_GRID_TOLERANCE = 0.006  # grids keep within some tenths of a per cent
_HARMONICS = 8
_ODD = (1, 3)  # a hum has its fundamental and third even where other lines hide them
_START = 2e-3  # [V]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a hum for each grid of which a fixed line is a multiple."""
    for grid in _GRIDS:
        found: dict[int, Peak] = {}
        for peak in fixed_lines(case):
            harmonic = round(peak.place.at / grid)
            if 1 <= harmonic <= _HARMONICS and abs(peak.place.at / (harmonic * grid) - 1) < _GRID_TOLERANCE:
                found.setdefault(harmonic, peak)
        if not found:
            continue
        strongest = max(found, key=lambda harmonic: found[harmonic].excess)
        listed = sorted({*found, *_ODD} if 1 in found else set(found))
        part = mechanisms.MainsInterference(
            name="mains_interference",
            frequency=found[strongest].place.at / strongest,
            amplitudes=tuple(_START if harmonic in listed else 0.0 for harmonic in range(1, max(listed) + 1)),
        )
        yield Candidate(
            mechanism="mains_interference",
            parts=(part,),
            knobs=tuple(Knob(part.name, "amplitudes", 1.5, key=harmonic - 1) for harmonic in listed),
            place=found[strongest].place,
        )
