"""All lines that the model lacks, found in passes: a strong line hides weaker ones beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig.diagnosis.looking.common_tones import common_tones, tone_of
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.order_or_fixed import (
    DECIDED,
    ONE_SPEED,
    evidence,
    followed_by,
    may_be_fixed,
    rather_fixed,
)
from torquerig.diagnosis.looking.peaks import LEADING, SHIFTED, TOP_ORDER, Peak, peaks
from torquerig.diagnosis.looking.side_lines import without_side_lines
from torquerig.diagnosis.looking.smeared_orders import smeared_orders
from torquerig.diagnosis.looking.tone_frequency import told_frequency
from torquerig.inference.places import SAME_ORDER, WHOLE_ORDER, Place, frequency, order
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of

_PASSES = 3
_STRONG = 0.02  # of the strongest new peak: what is weaker may be its skirt and waits for the next pass
_ASKED = 5  # of the clearest: whether they may keep their frequency
_HARMONICS = 6  # of a line, up to which others are taken for its own
SET_POINT_OFF = 0.013  # [1] by more no drive is off its set-point
_ONE_FACTOR, _TELLING = 2e-4, 250  # [1] to which several lines tell one factor; beyond, any order is nearly whole
_AMONG_MANY = 3.0  # whole orders of the output either way: which of them is meant nobody could tell


def known_places(runs: Sequence[Observed], rig: Rig) -> list[Place]:
    """Return where the lines of ``rig`` stand in these runs."""
    return sorted({order(line.order) for run in runs for line in Twin(rig.at(run.run)).lines()})


@dataclass(frozen=True)
class Strong:
    """Strong lines that a rig lacks: orders of its motor [1/rev], and tones of fixed frequency [Hz]."""

    orders: tuple[float, ...] = ()
    tones: tuple[float, ...] = ()


def strong_lines(runs: Sequence[Observed], rig: Rig) -> Strong:
    """Return the strong lines that ``rig`` lacks, where an angle was followed without knowing of them.

    An angle that is followed by the weaker lines alone would smear strong orders, and a tone of fixed frequency beside
    an order that is followed makes the angle swing with their beat. Only lines that stand in runs of several speeds
    count, and orders that the wander of one speed tells, or one of a kind could be taken for the other; and what is
    smeared so far that no peak is left of it.
    """
    if all(run.angle_measured for run in runs if run.steady):
        return Strong()
    known = known_places(runs, rig)
    left = lines_left(runs, known, rig=rig)
    speeds = [abs(run.mean_speed) for run in runs if run.steady]
    asked = left[:_ASKED] if max(speeds, default=0.0) < (1 + ONE_SPEED) * min(speeds, default=0.0) else ()
    told = [peak.place.at for peak in asked if peak.place.domain == "order" and not peak.either]
    leading = [
        peak.place
        for peak in left
        if peak.excess > LEADING and (peak.speeds > 1 or (peak in asked and _turns(peak.place, told)))
    ]
    orders, tones = ([place.at for place in leading if place.domain == domain] for domain in ("order", "frequency"))
    ratio = kinematics_of(rig).ratio
    if not known:
        orders = whole_by_one_factor(orders, ratio)
    peaked = [place.at for place in (*known, *(peak.place for peak in left)) if place.domain == "order"]
    smeared = smeared_orders(runs, peaked, ratio=ratio)
    return Strong((*orders, *smeared), tuple(tones))


def whole_by_one_factor(orders: Sequence[float], ratio: float) -> list[float]:
    """Return the whole orders of the output shaft that several lines stand on but for one error of the set-points.

    Where the rig has no line of its own to be followed by, its angle is what the sheets say, and all that turns with
    it stands off its order by the same share. Other lines are returned as they are.
    """
    at = [abs(each) * ratio for each in orders]
    for first in at:
        near = round(first)
        factor = first / near if near else 0.0
        if not 0 < abs(factor - 1) < SET_POINT_OFF:
            continue
        whole = [max(1, round(each / factor)) for each in at]
        off = [abs(each / factor / one - 1) for each, one in zip(at, whole, strict=True)]
        if len(at) > 1 and max(off) < _ONE_FACTOR and max(whole) < _TELLING:
            return [one / ratio for one in whole]
    return list(orders)


def _turns(place: Place, told: Sequence[float]) -> bool:
    """Whether a line is one of the orders that are told, or one that a told order is a multiple of."""
    if place.domain != "order":
        return False
    multiples = [round(at / place.at) for at in told]
    return any(most > 0 and abs(at - most * place.at) < SAME_ORDER for at, most in zip(told, multiples, strict=True))


def lines_left(runs: Sequence[Observed], known: Sequence[Place], *, rig: Rig) -> tuple[Peak, ...]:
    """Return the peaks beside ``known``, clearest first, each found with the stronger ones taken out.

    Orders that are whole on the output shaft of ``rig`` are stated as such.
    """
    ratio, found, beside = kinematics_of(rig).ratio, list[Peak](), list[Place]()
    for _ in range(_PASSES):
        carriers = [*known, *(peak.place for peak in found)]
        seen = peaks(runs, [*carriers, *beside])
        if not seen:
            break
        strong = [peak for peak in seen if peak.excess >= _STRONG * seen[0].excess]
        new = without_side_lines(strong, runs, carriers, rig=rig)
        beside += [peak.place for peak in strong if peak not in new]
        for peak in new:
            place = _whole(peak, runs, ratio, _series(found, ratio, least=peak.excess))
            place = _of_all_runs(replace(peak, place=place), runs, [*carriers, *(other.place for other in new)])
            if place not in {*carriers, *(other.place for other in found)}:
                found.append(replace(peak, place=place))
    found.sort(key=lambda peak: -peak.excess)
    asked = [_where_a_tone_stands(peak, runs, known, rig) for peak in found[:_ASKED]]
    asked = [replace(peak, either=may_be_fixed(runs, peak, known, rig)) for peak in asked]
    return (*asked, *found[_ASKED:])


def _where_a_tone_stands(peak: Peak, runs: Sequence[Observed], known: Sequence[Place], rig: Rig) -> Peak:
    """Return a peak as the tone that it is, where all runs of one speed share one and the wander shows that it stays.

    An angle that such a tone led astray spreads it over orders at which, in other runs, nothing is: asked are the runs
    in which the peak stands at the tone.
    """
    if peak.place.domain == "frequency" or peak.excess < LEADING or peak.speeds > 1:
        return peak
    shown = [run for run in runs if run.name in peak.runs and run.steady]
    for tone in common_tones(runs):
        near = [
            run for run in shown if abs(peak.place.frequency(run.mean_speed) - tone) < SHIFTED * run.smearing * tone
        ]
        if near and evidence([followed_by(known, run, rig) for run in near], peak.place) < -DECIDED:
            return replace(peak, place=frequency(tone), runs=tuple(run.name for run in runs if run.steady))
    return peak


def _of_all_runs(peak: Peak, runs: Sequence[Observed], lines: Sequence[Place]) -> Place:
    """Return where all runs that show a clear tone tell it: one alone may have a line of the shaft beside it."""
    if peak.place.domain == "order" or peak.excess < LEADING:
        return peak.place
    shown = [run for run in runs if run.steady and run.name in peak.runs]
    return frequency(told_frequency(peak.place.at, shown, lines))


def _series(found: Sequence[Peak], ratio: float, *, least: float) -> list[int]:
    """Return the whole output orders of lines at least so clear, whose harmonics may be left as well."""
    turning = [peak.place.at * ratio for peak in found if peak.place.domain == "order" and peak.excess >= least]
    return [round(at) for at in turning if abs(at - round(at)) < WHOLE_ORDER * ratio and round(at) > 1]


def _whole(peak: Peak, runs: Sequence[Observed], ratio: float, series: Sequence[int]) -> Place:
    """Return the whole output order that a peak stands on, else its own place.

    At one speed a whole order wins, unless the speed's wander or the shaft's own lines show that the line keeps its
    frequency, or it stands where no order can be seen, or so high that it stands among many. Of whole orders among
    which an unmeasured angle leaves the choice, a harmonic of a line of the ``series`` wins.
    """
    at, shown = peak.place.at, [run for run in runs if run.name in peak.runs]
    told = tone_of(shown, peak.place)
    if told is not None:
        return told
    if peak.place.domain == "frequency":
        if peak.speeds > 1 or any(peak.place.at > TOP_ORDER * run.rate / 2 for run in shown):
            return peak.place
        at = peak.place.at / Place("order", 1.0).frequency(shown[0].mean_speed)
    reach = max(WHOLE_ORDER, SHIFTED * min((run.smearing for run in shown), default=0.0) * at)
    if peak.place.domain == "frequency" and reach * ratio > _AMONG_MANY:
        return peak.place
    whole = min(_wholes(at * ratio, reach * ratio), key=lambda one: _preferred(one, at * ratio, series), default=0)
    if whole <= 0:
        return peak.place
    place = order(whole / ratio)
    stays = peak.place.domain == "frequency" and rather_fixed(shown, place)
    return peak.place if stays else place


def _wholes(at: float, reach: float) -> range:
    """Return the whole numbers nearer to ``at`` than ``reach``."""
    return range(int(np.floor(at - reach)) + 1, int(np.ceil(at + reach)))


def _preferred(whole: int, at: float, series: Sequence[int]) -> tuple[bool, float]:
    """Return by what a whole order is chosen, least first."""
    harmonic = any(whole % first == 0 and whole <= _HARMONICS * first for first in series)
    return not harmonic, abs(whole - at)
