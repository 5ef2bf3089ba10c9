"""Whether all lines of a steady run grow or shrink at one moment by one factor: no shaft does that, a gain does.

Where the noise of the amplifier steps too, ``looking/gain_moments.py`` tells it from the noise. A sensor whose own
sensitivity steps leaves that noise as it was, and under a load the step is hidden by it; at idle the lines tell it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import e, log10
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_TURNS, _WINDOWS = 2, 20  # of the output shaft in a window at least; windows beside each other at most
_STRONGEST, _FEWEST = 16, 4  # lines that are looked at
_SURE = 0.15  # spread of a line's logarithm from window to window: what strays more tells nothing
_FLOOR = 0.01  # of it: no line is told better
_ENDS = 3  # windows before and after a step at least
_CLEAR, _SMALLEST, _FOLLOWING = 6.0, 0.08, 0.7  # spreads, logarithm, lines that do as all; 156 clean rigs reach 4.3
_ALIKE, _OF_THE_STEP = 3.0, 0.3  # spreads, or of the step, within which a line does as all


class _Step(NamedTuple):
    """When all lines change [s], by which logarithm, and by how many spreads with how many windows."""

    at: float
    log: float
    clear: float
    windows: int


def one_gain(case: Case) -> tuple[str, Mismatch] | None:
    """Return a sentence and the moment at which the lines of a steady run change most surely, None where none do."""
    found = [(step, seen.observed) for seen in case.seen for step in _steps(case, seen)]
    best, run = max(found, key=lambda row: abs(row[0].clear), default=(None, None))
    if best is None or run is None:
        return None
    sentence = (
        f"{run.name}: from {best.at:.1f} s on, all lines of the shafts are {np.exp(best.log):.2f} times as large as "
        "before. A gain changes. No mechanism of the library does that."
    )
    mismatch = Mismatch(
        domain="time", axis="s", at=best.at, width=run.recording.duration / best.windows, recordings=(run.name,),
        excess_dB=20 * log10(e) * best.log, share_of_misfit=0.0,
        p_value=float(2 * best.windows * student.sf(abs(best.clear), best.windows - 2)),
    )  # fmt: skip
    return sentence, mismatch


def _steps(case: Case, seen: Features) -> Iterator[_Step]:
    """Yield the step of a steady run whose signal is whole, where it is clear."""
    run, ratio = seen.observed, abs(case.nominal.run.gear_ratio or 1.0)
    if not run.steady or run.rebuilt:
        return
    turned = np.abs(run.angle - run.angle[0]) / (2 * np.pi * ratio)
    orders = _strongest(seen)
    length = max(_TURNS, float(np.ceil(turned[-1] / _WINDOWS)))
    starts = np.arange(0.0, turned[-1] - length, 0.5 * length)
    if orders.size < _FEWEST or starts.size < 3 * _ENDS:
        return
    edges = np.searchsorted(turned, np.stack([starts, starts + length]))
    courses = np.log([
        _amplitudes(seen, turned, slice(first, last), orders) for first, last in edges.T.tolist()
    ])  # fmt: skip
    spread = np.array([spread_about_zero(each) for each in (courses[2:] - courses[:-2]).T]) / np.sqrt(2)
    sure = spread < _SURE
    if sure.sum() < _FEWEST:
        return
    step = _largest(courses[:, sure], np.maximum(spread[sure], _FLOOR), edges.mean(axis=0) / run.rate)
    if step is not None:
        yield step


def _strongest(seen: Features) -> Floats:
    turning = np.array([place.domain == "order" for place in seen.places], dtype=bool)
    shown = np.where(np.isfinite(seen.amplitude), np.abs(seen.amplitude), 0.0).mean(axis=0) * turning
    first = np.argsort(-shown)[:_STRONGEST]
    return np.array([seen.places[column].at for column in first.tolist() if shown[column] > 0])


def _amplitudes(seen: Features, turned: Floats, part: slice, orders: Floats) -> Floats:
    """Return the amplitude of each order in some turns under a Hann window of the angle, above 0."""
    run = seen.observed
    share = (turned[part] - turned[part.start]) / (turned[part.stop - 1] - turned[part.start])
    window = (1 - np.cos(2 * np.pi * share)) * np.gradient(share)
    torque = (run.torque[part] - run.torque[part].mean()) * window
    lines = np.exp(-1j * orders[:, None] * run.angle[part]) @ torque
    return np.asarray(np.maximum(2 * np.abs(lines), np.finfo(float).tiny))


def _largest(courses: Floats, spread: Floats, times: Floats) -> _Step | None:
    """Return the step that leaves the least scatter of all lines' common factor on either side, None unless clear.

    Parameters
    ----------
    courses : ndarray, shape (windows, lines)
        Logarithms of amplitudes; neighbouring windows overlap by half.
    spread : ndarray, shape (lines,)
        Of a line from window to window.
    times : ndarray, shape (windows,)
        [s]
    """
    weight, number = spread**-2, len(courses)
    common = courses @ weight / weight.sum()
    scatter = {at: number * common[:at].var() * at / number + common[at:].var() * (number - at)
               for at in range(_ENDS, number - _ENDS + 1)}  # fmt: skip
    at = min(scatter, key=lambda each: scatter[each])
    log = float(common[at:].mean() - common[:at].mean())
    apart = np.sqrt(2 * (1 / at + 1 / (number - at)))
    clear = log / (max(np.sqrt(scatter[at] / (number - 2)), weight.sum() ** -0.5) * apart)
    each = np.median(courses[at:], axis=0) - np.median(courses[:at], axis=0)
    alike = np.abs(each - log) < np.maximum(_ALIKE * spread * apart, _OF_THE_STEP * abs(log))
    if abs(clear) < _CLEAR or abs(log) < _SMALLEST or alike.mean() < _FOLLOWING:
        return None
    return _Step(float(0.5 * (times[at - 1] + times[at])), log, float(clear), number)
