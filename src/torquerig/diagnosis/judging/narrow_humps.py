"""Noise in one band that stands at one order or at one frequency, whatever the speed.

A line whose phase jumps is spread over a band and is no line, nor is a tone that wanders. A load's spectrum may be of
any shape, but that shape is wide: between one band and the next it does not rise by 4 dB and fall again.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import log, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.fitting.misfit import BAND_TOLERANCE
from torquerig.diagnosis.judging.band_excess import BandExcess, band_excesses
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.order_or_fixed import ONE_SPEED
from torquerig.inference.answer.mismatch import Mismatch

Floats = NDArray[np.float64]

_HIGH, _CLEAR = 1.0, 8.0  # of the density's logarithm above both neighbours, and in spreads, in the run that shows it
_AGAIN = 4.0  # spreads in another run, of another speed; as high there, both may be as clear together as one alone
_WITHIN = 1  # bands beside, at which it may stand there
_SMEARED = 0.05  # of a line's power an angle that was followed, not measured, may leave in bands beside it


@dataclass(frozen=True)
class _Heights:
    """How far each band's excess over the model is above that of the higher neighbour, and in spreads; 0 at ends."""

    features: Features
    height: Floats
    spreads: Floats


def narrow_humps(case: Case, total: float, beyond: Sequence[Correction] = ()) -> Iterator[Mismatch]:
    """Yield where single bands stand out of their neighbours in runs of two speeds or more.

    ``total`` is the excess misfit of which they are a share, ``beyond`` what simulations have and the twin has not.
    Blows of flanks, which some models hold, are left out.
    """
    if case.model.corrections:
        return
    every = [_heights(run) for run in band_excesses(case, beyond)]
    places, told = sum(each.height.size for each in every), list[tuple[str, float]]()
    for one, other in permutations(every, 2):
        speed, another = (abs(each.features.observed.mean_speed) for each in (one, other))
        if abs(another / speed - 1) < ONE_SPEED:
            continue
        for at in np.flatnonzero((one.spreads > _AGAIN) & (one.height > _HIGH)):
            middle, width, spreads = (float(each[at]) for each in (one.features.band, one.features.width, one.spreads))
            domain = "order" if _again(other, middle * another / speed, spreads) else "frequency"
            scale = 2 * pi / speed if domain == "order" else 1.0
            known = any(kind == domain and abs(middle * scale - where) < width * scale for kind, where in told)
            if known or (domain == "frequency" and not _again(other, middle, spreads)):
                continue
            told.append((domain, middle * scale))
            yield Mismatch(
                domain=domain, axis="motor_shaft" if domain == "order" else "Hz", at=middle * scale,
                width=width * scale, recordings=(one.features.observed.name, other.features.observed.name),
                excess_dB=10 / log(10) * float(one.height[at]),
                share_of_misfit=min(1.0, spreads**2 / total), p_value=by_chance(spreads, places),
            )  # fmt: skip


def _heights(run: BandExcess) -> _Heights:
    shown = np.flatnonzero(np.isfinite(run.log))
    excess, variance = run.log[shown], run.variance[shown] + run.doubt[shown] ** 2 + BAND_TOLERANCE**2
    height, spreads = np.zeros(run.log.size), np.zeros(run.log.size)
    if shown.size > 2:
        above = excess[1:-1] - np.maximum(excess[:-2], excess[2:])
        above = np.where(_smeared_lines(run.features)[shown[1:-1]], 0.0, above)
        height[shown[1:-1]] = above
        spreads[shown[1:-1]] = above / np.sqrt(variance[1:-1] + np.maximum(variance[:-2], variance[2:]))
    return _Heights(run.features, height, spreads)


def _smeared_lines(features: Features) -> NDArray[np.bool_]:
    """Whether a band holds no more than what strays of the lines in it and at its edges, shape (bands,)."""
    if features.observed.angle_measured:
        return np.zeros(features.band.size, dtype=bool)
    at = features.line_frequency.mean(axis=(0, 2))
    shown = np.isfinite(features.amplitude)
    squares = np.where(shown, np.abs(features.amplitude) ** 2, 0.0).sum(axis=0)
    power = 0.5 * squares / np.maximum(shown.sum(axis=0), 1)
    reach = features.width[:, None]  # half a band's width beyond its edges
    beside = np.abs(at[None, :] - features.band[:, None]) < reach
    lines = np.where(beside, power[None, :], 0.0).sum(axis=1)
    return np.asarray(features.power * features.width < _SMEARED * lines)


def _again(other: _Heights, frequency: float, spreads: float) -> bool:
    """Whether a band that stands out by ``spreads`` in one run does so in another at a frequency."""
    band = other.features.band
    if not band[0] < frequency < band[-1]:
        return False
    at = int(np.argmin(np.abs(np.log(band / frequency))))
    near = slice(max(at - _WITHIN, 0), at + _WITHIN + 1)
    again = other.spreads[near] > _AGAIN
    if spreads <= _CLEAR:
        again &= (other.height[near] > _HIGH) & (np.hypot(spreads, other.spreads[near]) > _CLEAR)
    return bool(again.any())
