"""Small effects beside a large one: what no twin has of the large one may look like them.

Dry friction bends the angle, and strong cogging turns the shaft until it shifts its own phase: both make lines of their
own, near a mode large ones, that only a simulation shows.
"""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.trial import LEAST_GAIN, Trial
from torquerig.diagnosis.judging.by_simulation import left_and_fall, left_by_simulation
from torquerig.diagnosis.judging.leftover import mismatches, stands_at
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import Place
from torquerig.rig.assembly import Part

_SMALL = 0.03  # of what an effect took that was found earlier
_WANDERS = 3e-3  # of its frequency, by which a grid's tone strays: one mode in a hundred stands as near to it
_AGAIN = 1 / 3  # of what a trial gains: it gains so much beside simulations of the rig without it, too


def small_beside(trial: Trial, earlier: Sequence[Trial]) -> bool:
    """Whether an effect takes so little beside an earlier one of the shafts that it may be a part of that.

    One of the sensor without a place of its own (what it lets pass, where its zero is) may not: shafts make lines. Nor
    may a gap be a part of a zero that drifts, which makes no flanks part.
    """
    of_shafts = [one for one in earlier if (at := one.candidate.place) is None or at.domain == "order"]
    small = any(trial.gain < _SMALL * one.gain for one in of_shafts)
    return small and not (_of_the_sensor(trial.candidate) or _gap_behind_a_sensor(trial, earlier))


def hump_of_a_tone(trial: Trial, earlier: Sequence[Trial]) -> bool:
    """Whether it is a mode that gains little where a tone of fixed frequency stands: what wanders is a hump there."""
    names = {part.name for part in trial.candidate.parts if part.kind == "torsional_mode"}
    at = [getattr(part, "frequency", 0.0) for part in trial.model.rig.parts if part.name in names]
    tones = [tone for one in earlier if trial.gain < _SMALL * one.gain for tone in _tones(one)]
    return any(abs(frequency - tone) < _WANDERS * tone for frequency in at for tone in tones)


def _tones(one: Trial) -> list[float]:
    """Return the frequencies [Hz] of what stands at fixed ones and was found: a hum's multiples, or its one line."""
    place = one.candidate.place
    if place is None or place.domain == "order":
        return []
    of_hums = [multiple for part in one.candidate.parts if part.kind == "mains_interference" for multiple in _hum(part)]
    return [place.at, *of_hums]


def _hum(part: Part) -> list[float]:
    """Return the frequencies of a hum's lines [Hz]."""
    base, volts = getattr(part, "frequency", 0.0), getattr(part, "amplitudes", ())
    return [multiple * base for multiple, size in enumerate(volts, start=1) if size]


def _gap_behind_a_sensor(trial: Trial, earlier: Sequence[Trial]) -> bool:
    """Whether it is a gap beside effects of the sensor alone."""
    gap = any(part.kind == "backlash" for part in trial.candidate.parts)
    return gap and all(_of_the_sensor(one.candidate) for one in earlier)


def _of_the_sensor(candidate: Candidate) -> bool:
    return candidate.place is None and all(part.group == "sensor" for part in candidate.parts)


def stands_in_simulations(case: Case, trial: Trial) -> bool:
    """Whether something of what the trial explains is still missing where the case's rig is simulated.

    Of an order that is its line, and the band around it in the runs where noise beside it stands out. What sets out to
    explain no line may act in many places of which none stands out: it must gain there what it gained.
    """
    place, ratio = trial.candidate.place, abs(case.nominal.run.gear_ratio or 1.0)
    left = mismatches(case)
    its = (
        left
        if place is None
        else [each for each in left if stands_at(each, place, ratio) or _around(each, place, case)]
    )
    if place is not None or trial.model.corrections:
        return bool(left_by_simulation(case, its))
    stay, fall = left_and_fall(case, its, trial.model.rig)
    return bool(stay) or fall > max(_AGAIN * trial.gain, LEAST_GAIN)


def _around(mismatch: Mismatch, place: Place, case: Case) -> bool:
    """Whether a band that stands out in some runs holds the order there."""
    shown = [run for run in case.runs if run.name in mismatch.recordings]
    apart = [abs(place.frequency(abs(run.mean_speed)) - mismatch.at) for run in shown]
    band = mismatch.domain == "frequency" and place.domain == "order"
    return band and any(each < 0.5 * mismatch.width for each in apart)
