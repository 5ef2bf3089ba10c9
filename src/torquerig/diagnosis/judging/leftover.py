"""What still stands out when a model is as good as it gets, and whether chance could have left it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import log10, sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.stats import poisson

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.fitting.misfit import Misfit, robust_squares
from torquerig.diagnosis.judging.chance import beyond_chance, by_chance
from torquerig.diagnosis.judging.forgiven_bands import forgiven
from torquerig.diagnosis.judging.narrow_humps import narrow_humps
from torquerig.diagnosis.judging.one_load import load_contradictions
from torquerig.diagnosis.judging.own_lines import of_an_effect
from torquerig.diagnosis.judging.scattered_levels import scattered_levels
from torquerig.diagnosis.looking.bands import BANDS_PER_OCTAVE
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flights import BY_CHANCE, CLEARLY, UNDRIVEN
from torquerig.diagnosis.looking.flights_beyond_lines import flights_beyond_lines
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import SAME_ORDER, Place
from torquerig.recordings.repair.moments import moments_of

# thresholds on residuals in units of their spread; the spreads hold a tolerance for what nobody models
LINE, BAND, LEVEL, TURNING = 6.0, 5.0, 6.0, 4.0
_WHOLE = 0.02  # [1/rev] so near an order is whole
_CHAOTIC = 2.5  # times as much may be left where an effect beyond the twin is at work
_DETAIL = 0.05**2  # of the misfit: an effect that is modelled to 5 %
_ELSEWHERE, _BETTER = 0.5, 2.0  # of what is left: more at places that got better by less than this is no detail
_BAND_RUN, _ALONE = 2, 12.0  # neighbouring bands that must all stand out; one alone only if so far
_MEAN_SQUARE = 3.0  # of all bands of a run


def mismatches(case: Case, beyond: Sequence[Correction] = ()) -> tuple[Mismatch, ...]:
    """Return the places where the case's model is significantly wrong, largest share of the misfit first.

    ``beyond`` is what simulations of each run have and the twin has not, where the case's misfits hold it.
    """
    every = _every(case)
    total, places = _excess(every), sum(eased.all().size for eased in every)
    found = [*_lines(case, total, places)]
    for features, eased in zip(case.seen, every, strict=True):
        found += [*_bands(features, eased, total, places), *_levels(features, eased, total, places)]
        found += [*_turning(features, eased, total, places)]
    found += [*_flights(case), *load_contradictions(case, total), *narrow_humps(case, total, beyond)]
    found += [*scattered_levels(case, total)]
    return tuple(sorted(found, key=lambda mismatch: -mismatch.share_of_misfit))


def of_flights(mismatch: Mismatch) -> bool:
    """Whether it tells that flanks fly."""
    return mismatch.domain == "distribution" and mismatch.axis == "V"


def stands_at(mismatch: Mismatch, place: Place, ratio: float) -> bool:
    """Whether it is of the line at ``place`` in a rig whose motor turns ``ratio`` times as fast as its output."""
    turns = ratio if mismatch.axis == "output_shaft" else 1.0
    return mismatch.domain == place.domain and abs(mismatch.at / turns - place.at) < SAME_ORDER


def at_whole_order(mismatch: Mismatch) -> bool:
    """Whether it is of a line at a whole order of the motor's shaft."""
    motor = mismatch.domain == "order" and mismatch.axis == "motor_shaft"
    return motor and abs(mismatch.at - round(mismatch.at)) < _WHOLE


def detail_of(before: Case, after: Case, left: Sequence[Mismatch]) -> float | None:
    """Return what share of the misfit before is ``left``, where that is but the detail of a strong effect; else None.

    No model of a line or a load is right to better than some per cent, so the square of that stays, and where the
    effect is: what is left at places that it does not change is no detail of it.
    """
    if not left or any(mismatch.domain in ("distribution", "time") for mismatch in left):
        return None
    if _left_elsewhere(_every(before), _every(after)) > _ELSEWHERE:
        return None
    share = min(1.0, sum(mismatch.share_of_misfit for mismatch in left))  # places may tell of one thing twice
    rest = share * _excess(_every(after)) / _excess(_every(before))
    return rest if rest < _DETAIL else None


def _left_elsewhere(before: Sequence[Misfit], after: Sequence[Misfit]) -> float:
    """Return which share of what is left stands at features that did not get better; 0 where others are looked at."""
    old, new = (robust_squares(np.concatenate([each.all() for each in every])) for every in (before, after))
    if old.size != new.size:
        return 0.0
    return beyond_chance(new[old - new <= _BETTER]) / max(beyond_chance(new), 1e-12)


def _every(case: Case) -> list[Misfit]:
    return [_eased(case, features, misfit) for features, misfit in zip(case.seen, case.model.misfits, strict=True)]


def _excess(every: Sequence[Misfit]) -> float:
    squares = np.concatenate([robust_squares(eased.all()) for eased in every])
    return beyond_chance(squares) + 1e-12


def _eased(case: Case, features: Features, misfit: Misfit) -> Misfit:
    """Return the residuals less what a random load, or chance in an effect beyond the twin, may be forgiven."""
    eased = misfit.scaled(1 / _slack(case))
    return replace(eased, bands=forgiven(case, features, eased.bands)) if eased.bands.size else eased


def _lines(case: Case, total: float, places: int) -> Iterator[Mismatch]:
    """Lines of the runs, one entry per place, with the runs that show it."""
    count = len(case.seen[0].places)
    ratio = abs(case.nominal.run.gear_ratio or 1.0)
    for column in range(count):
        place, worst, square, names = case.seen[0].places[column], 0.0, 0.0, []
        for features, misfit in zip(case.seen, case.model.misfits, strict=True):
            if features.turning is not None:
                continue
            residual = np.atleast_2d(misfit.lines)[:, column]
            square += beyond_chance(robust_squares(residual))
            if of_an_effect(case, features, column):
                continue
            size = float(np.abs(residual).max(initial=0.0))
            # a moving run has many stretches, of which a few may stray
            size = size if features.observed.steady else float(np.sqrt(np.mean(residual**2)) * 2)
            if size > LINE * _slack(case):
                names.append(features.observed.name)
            worst = max(worst, size)
        if not names:
            continue
        whole = abs(place.at * ratio - round(place.at * ratio)) < 0.02 and abs(place.at - round(place.at)) > 1e-6
        turned = place.domain == "order" and whole
        yield Mismatch(
            domain=place.domain,
            axis="Hz" if place.domain == "frequency" else "output_shaft" if turned else "motor_shaft",
            at=place.at * ratio if turned else place.at,
            width=0.02 * ratio if turned else 0.02,
            recordings=tuple(names),
            excess_dB=20 * log10(max(worst, 1.0)),
            share_of_misfit=square / total,
            p_value=by_chance(worst, places),
        )


def _bands(features: Features, misfit: Misfit, total: float, places: int) -> Iterator[Mismatch]:
    """Bands that stand out together, where a run's spectrum as a whole is wrong or some neighbours clearly are."""
    residual = misfit.bands
    if residual.size == 0:
        return
    out = np.abs(residual) > BAND
    if np.mean(robust_squares(residual)) > _MEAN_SQUARE:
        out |= np.abs(residual) > 0.6 * BAND
    for start, stop in moments_of(out):
        part = slice(start, stop)
        worst = float(np.abs(residual[part]).max())
        if stop - start < _BAND_RUN and worst < _ALONE:
            continue
        low, high = float(features.band[start]), float(features.band[stop - 1])
        mean = float(np.mean(residual[part] * np.sqrt(1 / features.count[part] + 0.05**2)))
        yield Mismatch(
            domain="frequency", axis="Hz", at=sqrt(low * high), width=high - low + low / BANDS_PER_OCTAVE,
            recordings=(features.observed.name,), excess_dB=10 * mean / np.log(10),
            share_of_misfit=_share(residual[part], total), p_value=by_chance(worst, places),
        )  # fmt: skip


def _levels(features: Features, misfit: Misfit, total: float, places: int) -> Iterator[Mismatch]:
    if misfit.level.size == 0 or float(np.abs(misfit.level).max()) < LEVEL:
        return
    observed, worst = features.observed, int(np.argmax(np.abs(misfit.level)))
    stretch = worst * len(features.stretches) // len(features.parts)
    speed = float(features.speed[stretch].mean()) * 30 / np.pi
    yield Mismatch(
        domain="level" if observed.steady else "speed", axis="rpm", at=speed,
        width=float(np.ptp(features.speed)) * 30 / np.pi, recordings=(observed.name,),
        excess_dB=20 * log10(float(np.abs(misfit.level).max())), share_of_misfit=_share(misfit.level, total),
        p_value=by_chance(float(np.abs(misfit.level).max()), places),
    )  # fmt: skip


def _turning(features: Features, misfit: Misfit, total: float, places: int) -> Iterator[Mismatch]:
    if misfit.turning.size == 0 or float(np.sqrt(np.mean(misfit.turning**2))) < 0.5 * TURNING:
        return
    worst = float(np.abs(misfit.turning).max())
    blocks = features.turning
    at = 0.0 if blocks is None else float(blocks.speed[int(np.argmax(np.abs(misfit.turning)))]) * 30 / np.pi
    yield Mismatch(
        domain="speed", axis="rpm", at=at, width=10.0, recordings=(features.observed.name,),
        excess_dB=20 * log10(max(worst, 1.0)), share_of_misfit=_share(misfit.turning, total),
        p_value=by_chance(worst, places),
    )  # fmt: skip


def _flights(case: Case) -> Iterator[Mismatch]:
    """Flights of flanks, which no model without a gap has."""
    shown = {features.observed.name: flights_beyond_lines(features) for features in case.from_zero}
    number = sum(shown.values())
    if number < CLEARLY or case.model.corrections:
        return
    yield Mismatch(
        domain="distribution", axis="V", at=0.0, width=UNDRIVEN,
        recordings=tuple(name for name, count in shown.items() if count), excess_dB=20 * log10(number / BY_CHANCE),
        share_of_misfit=0.0, p_value=float(poisson.sf(number - 1, BY_CHANCE)),
    )  # fmt: skip


def _slack(case: Case) -> float:
    return _CHAOTIC if case.model.corrections else 1.0


def _share(residual: NDArray[np.float64], total: float) -> float:
    return beyond_chance(robust_squares(residual)) / total
