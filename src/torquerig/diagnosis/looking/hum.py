"""Where a hum of the mains stands: at multiples of the grid's frequency."""

from __future__ import annotations

from collections.abc import Iterable

from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import Place, frequency
from torquerig.recordings.repair.mains_hum import GRIDS, TOLERANCE

ALWAYS = (1, 2, 3)  # a hum has its first harmonics even where other lines hide them
_HARMONICS = 8


def harmonics_of(grid: float, peaks: Iterable[Peak]) -> dict[int, Peak]:
    """Return the peaks of fixed frequency that are multiples of a grid [Hz], the first given one for each harmonic."""
    found: dict[int, Peak] = {}
    for peak in peaks:
        harmonic = round(peak.place.at / grid)
        on_grid = 1 <= harmonic <= _HARMONICS and abs(peak.place.at / (harmonic * grid) - 1) < TOLERANCE
        if peak.place.domain == "frequency" and on_grid:
            found.setdefault(harmonic, peak)
    return found


def fundamental(found: dict[int, Peak]) -> float:
    """Return the grid's frequency [Hz] by the line that tells it best.

    A line is told to within 1 / root of its excess, and divides that by its number.
    """
    best = max(found, key=lambda harmonic: found[harmonic].excess * harmonic**2)
    return found[best].place.at / best


def hum_places(peaks: Iterable[Peak]) -> list[Place]:
    """Return where a hum of which ``peaks`` shows some lines must stand as well; of two grids, that with more lines."""
    peaks = list(peaks)
    all_found = [found for grid in GRIDS if (found := harmonics_of(grid, peaks))]
    most = max((len(found) for found in all_found), default=0)
    likely = [found for found in all_found if len(found) == most]
    return [frequency(n * fundamental(found)) for found in likely for n in ALWAYS if n not in found]
