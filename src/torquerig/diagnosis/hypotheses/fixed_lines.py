"""Left lines that keep their frequency whatever the speed, as far as the runs tell."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.own_lines import of_impacts
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.steady_tone import sounds_all_along, steady_frequency
from torquerig.inference.places import frequency


def doubtful_lines(case: Case) -> Iterator[Peak]:
    """Yield the left lines of an order that may as well be fixed ones, each at its frequency."""
    for peak in case.left:
        if peak.either and not _of_impacts(case, peak):
            run = next(run for run in case.runs if run.name == peak.runs[0])
            yield replace(peak, place=frequency(steady_frequency(run, peak.place.frequency(run.mean_speed))))


def fixed_lines(case: Case) -> list[Peak]:
    """Return the left lines of fixed frequency that sound all along, the doubtful ones among them, clearest first.

    Lines that the impacts of a bearing in the model make in the runs that show them are none.
    """
    fixed = [peak for peak in case.left if peak.place.domain == "frequency" and not _of_impacts(case, peak)]
    known = case.seen[0].places
    steady = [peak for peak in (*fixed, *doubtful_lines(case)) if sounds_all_along(peak, case.runs, known)]
    return sorted(steady, key=lambda peak: -peak.excess)


def _of_impacts(case: Case, peak: Peak) -> bool:
    return all(of_impacts(case, peak.place, run) for run in case.runs if run.name in peak.runs)
