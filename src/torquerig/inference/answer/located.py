"""Where recordings and models differ: places of the additions, and the largest residuals by kind of feature."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import exp, log, log10, pi
from typing import Any

import numpy as np

from torquerig.inference.adequacy import Excess, JudgedRun
from torquerig.inference.answer.course_axis import followed
from torquerig.inference.answer.numbers import digits
from torquerig.inference.answer.significant import significant
from torquerig.inference.engine import Outcome
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Fit, all_residuals
from torquerig.inference.likelihood import BAND, DEGREES_OF_FREEDOM, LEVEL, LINE, Residuals
from torquerig.inference.model import lacks
from torquerig.inference.places import Place
from torquerig.inference.shafts import shafts_of
from torquerig.inference.undecided_lines import column_of
from torquerig.recordings.repair.faults import Fault
from torquerig.rig.reading_place import effort_unit

_ORDER_WIDTH, _TONE_WIDTH = 0.01, 1.0  # [1/rev], [Hz] to which the place of a line is reported
_DECIBELS = 10 / log(10)
_MOST_PLACES, _MUCH_SMALLER = 3, 0.5  # of one kind that are reported, and of the largest residual: one that is not
_MOST_LINES = 6  # found ones that are reported although no addition is there; of an undecided one both places count
_PART = 0.1  # [1] of a speed or a torque, to which a course over it is located
_APART = 2.0  # [1] times the width of a feature: nearer ones are one place


def differences(outcome: Outcome) -> list[dict[str, Any]]:
    """Return where the calibrated model differs: places of additions, clear lines, and other large residuals."""
    fit = outcome.nominal
    runs = all_residuals(outcome.data, fit.expected, fit.gains, fit.off)
    lines = sorted(outcome.found, key=lambda line: line.log_p)
    clearest = [line.place for line in lines if _is_open(outcome, line.place)][:_MOST_LINES]
    places = list(dict.fromkeys((*_of_additions(outcome), *clearest)))
    found = {line.place: exp(line.log_p) for line in outcome.found}
    rows = [_of_line(outcome.data.seen, runs, place, p_value=found.get(place)) for place in places]
    if not all(each.places for each in outcome.model.additions):  # a level, a band
        excesses, tested = significant(outcome, fit)
        rows += _of_excesses(outcome, fit, [each for each in _largest(excesses) if each.kind != LINE], tested)
    return sorted(rows, key=lambda row: -row["share_of_misfit"])


def fault_place(fault: Fault) -> dict[str, Any]:
    """Return the place of a fault of samples that no mechanism makes; it is repaired, so no residual is left there."""
    place = fault.place
    return {
        "domain": place.domain, "axis": "s" if place.domain == "time" else "Hz", "at": digits(place.at),
        "width": digits(place.width), "recordings": [fault.recording], "excess_dB": digits(place.excess),
        "share_of_misfit": 0.0, "p_value": 0.0,
    }  # fmt: skip


def remaining(outcome: Outcome) -> list[dict[str, Any]]:
    """Return where the completed model still differs, also where that is too small to change the verdict."""
    excesses, tested = significant(outcome, outcome.model.fit, any_size=True)
    return _of_excesses(outcome, outcome.model.fit, list(_largest(excesses)), tested)


def _of_excesses(
    outcome: Outcome, fit: Fit, found: Sequence[Excess], tested: Sequence[JudgedRun]
) -> list[dict[str, Any]]:  # fmt: skip
    """Return the places of residuals: of an undecided line in both domains, of mean torques over what they follow."""
    rows = list[dict[str, Any]]()
    for each in found:
        axis = followed(fit, outcome.data) if each.kind == LEVEL else ""
        for one in _peaks(tested, each):
            rows.append(_of_excess(tested, one))
            seen, at = tested[one.run].seen, int(tested[one.run].residuals.at[one.row])
            if axis in ("speed", "level"):
                rows[-1] |= _over(outcome, seen, at, axis)
            elif one.kind == LINE:
                rows += [{**rows[-1], **_at(other)} for other in _undecided(outcome, seen.places[at])]
    return rows


def _over(outcome: Outcome, seen: RunFeatures, part: int, axis: str) -> dict[str, Any]:
    """Return the place of a mean torque over the speed of the last shaft or over the torque."""
    if axis == "level":
        at, unit = float(seen.level[part]), effort_unit(outcome.completed)
    else:
        turns = abs(shafts_of(outcome.completed)[-1].turns)
        at, unit = float(np.abs(seen.level_speed[part]).mean()) * turns * 30 / pi, "rpm"
    return {"domain": axis, "axis": unit, "at": digits(at), "width": digits(_PART * abs(at))}


def _of_additions(outcome: Outcome) -> Iterator[Place]:
    """Yield the places of the additions; of a nameless line also that in the other domain."""
    for each in outcome.model.additions:
        for place in each.places:
            yield place
            if not each.is_named:
                yield from _undecided(outcome, place)


def _is_open(outcome: Outcome, place: Place) -> bool:
    """Return whether the nominal model lacks a line, or no block is long enough to compare it."""
    seen = outcome.data.seen
    is_compared = any((each.lines.count[:, column_of(each, place)] > 0).any() for each in seen if place in each.places)
    return not is_compared or lacks(outcome.nominal, outcome.data, place)


def _undecided(outcome: Outcome, place: Place) -> tuple[Place, ...]:
    """Return the place of the other domain that a found line may be at as well: the runs do not say which."""
    return tuple(line.place for line in outcome.found if line.other_place == place)


def _at(place: Place) -> dict[str, Any]:
    turning = place.domain == "order"
    return {
        "domain": place.domain, "axis": "motor_shaft" if turning else "Hz", "at": digits(place.at),
        "width": _ORDER_WIDTH if turning else _TONE_WIDTH,
    }  # fmt: skip


def _largest(found: Sequence[Excess]) -> Iterator[Excess]:
    """Yield the first of each kind of feature, and of those that change."""
    kinds = set[tuple[int, bool]]()
    for each in found:
        if (each.kind, each.changes) not in kinds:
            kinds.add((each.kind, each.changes))
            yield each


def _peaks(tested: Sequence[JudgedRun], first: Excess) -> Iterator[Excess]:
    """Yield a residual, and the largest others of its kind at other places that are at least half as large.

    Of what changes, only the first is known.
    """
    rows = [
        (float(np.abs(run.residuals.standardised[row])), at, row)
        for at, run in enumerate(tested) for row in np.flatnonzero(run.residuals.kind == first.kind).tolist()
    ]  # fmt: skip
    largest = float(np.abs(tested[first.run].residuals.standardised[first.row]))
    shown = [_where(tested[first.run].seen, first.kind, int(tested[first.run].residuals.at[first.row]))]
    yield first
    if first.changes:
        return
    for size, at, row in sorted(rows, reverse=True):
        there = _where(tested[at].seen, first.kind, int(tested[at].residuals.at[row]))
        if size < _MUCH_SMALLER * largest or len(shown) == _MOST_PLACES:
            return
        if all(abs(there[2] - other[2]) > _APART * max(there[3], other[3]) for other in shown):
            shown.append(there)
            yield replace(first, run=at, row=row)


def _of_line(
    seen: Sequence[RunFeatures], runs: Sequence[Residuals], place: Place, *, p_value: float | None
) -> dict[str, Any]:
    """Return one place; ``p_value`` is that of the search for lines, which knows of all blocks."""
    excess, largest, there, names = 0.0, 0.0, 0.0, list[str]()
    for one, each in zip(seen, runs, strict=True):
        rows = np.flatnonzero((each.kind == LINE) & (each.at == column_of(one, place)))
        if rows.size:
            names.append(one.run.name)
            excess = max(excess, float(each.value[rows].max()))
            largest = max(largest, float(np.abs(each.standardised[rows]).max()))
            there += float((each.standardised[rows] ** 2).sum())
    return {
        **_at(place), "recordings": names, "excess_dB": digits(_DECIBELS * excess),
        "share_of_misfit": digits(there / _total(runs)),
        "p_value": digits(_p_value(largest, runs) if p_value is None else p_value),
    }  # fmt: skip


def _of_excess(tested: Sequence[JudgedRun], each: Excess) -> dict[str, Any]:
    one, own = tested[each.run].seen, tested[each.run].residuals
    at, square = int(own.at[each.row]), float(own.standardised[each.row] ** 2)
    domain, axis, middle, width = _where(one, each.kind, at)
    # a level has no power: the excess is its residual over its standard deviation
    decibels = 10 * log10(max(square, 1.0)) if each.kind == LEVEL else _DECIBELS * float(own.value[each.row])
    return {
        "domain": domain, "axis": axis, "at": digits(middle), "width": digits(width), "recordings": [one.run.name],
        "excess_dB": digits(decibels), "share_of_misfit": digits(square / _total([run.residuals for run in tested])),
        "p_value": digits(each.p_value),
    }  # fmt: skip


def _where(seen: RunFeatures, kind: int, at: int) -> tuple[str, str, float, float]:
    """Return domain, axis, middle and width of a feature."""
    if kind == BAND:
        return "frequency", "Hz", float(seen.bands.middle[at]), float(seen.bands.high[at] - seen.bands.low[at])
    if kind == LEVEL:
        return "time", "s", float(seen.parts[at].mean()) / seen.run.rate, float(seen.level_duration[at])
    place = seen.places[at]
    turning = place.domain == "order"
    return place.domain, "motor_shaft" if turning else "Hz", place.at, _ORDER_WIDTH if turning else _TONE_WIDTH


def _total(runs: Sequence[Residuals]) -> float:
    return max(sum(float((each.standardised**2).sum()) for each in runs), 1e-300)


def _p_value(largest: float, runs: Sequence[Residuals]) -> float:
    """Return the probability of so large a standardised residual anywhere, under the likelihood's distribution."""
    from scipy.stats import t

    count = sum(each.value.size for each in runs)
    return min(2 * count * float(t.sf(largest, DEGREES_OF_FREEDOM)), 1.0)
