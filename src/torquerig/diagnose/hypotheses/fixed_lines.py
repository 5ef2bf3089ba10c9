"""Left lines that keep their frequency whatever the speed, as far as the runs tell."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig.diagnose.case import Case
from torquerig.diagnose.looking.peaks import Peak
from torquerig.diagnose.looking.places import frequency
from torquerig.diagnose.looking.steady_tone import sounds_all_along, steady_frequency


def doubtful_lines(case: Case) -> Iterator[Peak]:
    """Yield the left lines of an order that may as well be fixed ones, each at its frequency."""
    for peak in case.left:
        if peak.either:
            run = next(run for run in case.runs if run.name == peak.runs[0])
            yield replace(peak, place=frequency(steady_frequency(run, peak.place.frequency(run.mean_speed))))


def fixed_lines(case: Case) -> list[Peak]:
    """Return the left lines of fixed frequency that sound all along, the doubtful ones among them, clearest first."""
    fixed = [peak for peak in case.left if peak.place.domain == "frequency"]
    known = case.seen[0].places
    steady = [peak for peak in (*fixed, *doubtful_lines(case)) if sounds_all_along(peak, case.runs, known)]
    return sorted(steady, key=lambda peak: -peak.excess)
