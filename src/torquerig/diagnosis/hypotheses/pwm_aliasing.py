"""A tone of fixed frequency above what the shafts pass on: switching, folded by the sampling."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.hypotheses.fixed_lines import doubtful_lines, fixed_lines
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.knobs import Knob
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.repair.mains_hum import GRIDS

_PASSED = 0.02  # share of a torque on the loaded side that still reaches the reading
_STRONGEST = 3
_START = 2e-3  # [V]
_OF_THE_GRID = 0.003  # relative; so near to 50 or 60 Hz, or a low harmonic, an alias falls once in a thousand
_HARMONICS = (1, 2, 3, 5, 7)  # that a grid has
_LOWEST = 20.0  # [Hz] a slower tone is something's that moves, and no switching
_TEETH = 3  # lines that make a comb
_APART = 1e-3  # by which a tooth may miss its multiple, relative
_BY_CHANCE = 0.02  # of all tones fall so near to a whole order of a shaft, where runs tell no speed from another


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a tone for each of the strongest fixed lines above the mechanical range, and combs of fixed lines.

    A line that stands at an order and was seen at one speed alone may be such a tone wherever it stands. So may a comb:
    no shaft has lines at the multiples of a frequency that no speed moves. A line at the frequency of a grid, or at a
    low harmonic of it, is the grid's. A tone that stands at an order by chance pays for that chance.
    """
    top = mechanical_range(case)
    doubtful, fixed = list(doubtful_lines(case)), fixed_lines(case)
    able = (peak for peak in fixed if peak.place.at > top or (peak in doubtful and peak.place.at > _LOWEST))
    lines = [peak for peak in able if not _of_the_grid(peak)]
    for peak in lines[:_STRONGEST]:
        yield _tones([peak], price=-2 * log(_BY_CHANCE) if peak in doubtful else 0.0)
    comb = _comb(fixed)
    if len(comb) >= (2 if comb and comb[0] in doubtful else _TEETH):
        yield _tones(comb)


def _of_the_grid(peak: Peak) -> bool:
    return any(abs(peak.place.at / (times * grid) - 1) < _OF_THE_GRID for grid in GRIDS for times in _HARMONICS)


def _tones(lines: Sequence[Peak], *, price: float = 0.0) -> Candidate:
    parts = tuple(
        mechanisms.PwmAliasing(
            name="pwm_aliasing" + (f"_{number}" if number > 1 else ""), frequency=peak.place.at, amplitude=_START
        )
        for number, peak in enumerate(lines, start=1)
    )
    return Candidate(
        mechanism="pwm_aliasing",
        parts=parts,
        knobs=tuple(Knob(part.name, "amplitude", 1.5) for part in parts),
        variant="comb" if len(parts) > 1 else "",
        place=lines[0].place,
        price=price,
    )


def _comb(lines: Sequence[Peak]) -> list[Peak]:
    """Return the longest comb among the fixed lines, its lowest first; beats of the mains are no comb of their own."""
    combs = []
    for base in (peak for peak in lines if peak.place.at > _LOWEST):
        ratios = [peak.place.at / base.place.at for peak in lines]
        teeth = [p for p, r in zip(lines, ratios, strict=True) if r > 0.99 and abs(r - round(r)) < _APART * r]
        if not any(abs(base.place.at / grid - round(base.place.at / grid)) < 0.01 for grid in GRIDS):
            combs.append(sorted(teeth, key=lambda peak: peak.place.at))
    return max(combs, key=len, default=[])


def mechanical_range(case: Case) -> float:
    """Return the frequency [Hz] above which the shafts pass less than a fiftieth of any torque to the reading.

    Counted are the shafts on which a motor, a load or friction acts: the sensor's own end passes on more, and nothing
    turns it but its neighbours.
    """
    twin = Twin(case.nominal)  # a model that lacks a strong line may be fitted far off
    acted = sorted(twin.turns.keys() & {getattr(term, "on", None) for term in twin.terms})
    grid = twin.shafts.frequency
    passed = np.max([np.abs(twin.torque_on(node)(grid)) for node in acted], axis=0)
    above = np.flatnonzero(passed > _PASSED)
    return float(grid[above[-1]]) if above.size else 0.0
