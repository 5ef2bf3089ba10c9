"""Whether runs that differ in load alone differ in their spectra as no load does: a rig that changes with its load.

A random load's spectrum is its own and forgiven (``leftover``), but particles of one size hit alike however many they
are. What the model misses in all runs of one size may be the shape of the pulses; what it misses in one of them, at
bands that the load fills, is the rig's: a shaft that hardens moves its mode from run to run. Idle runs are left out:
what little load they have comes and goes. On clean rigs of seeds 51 and 52 neighbouring bands of loaded runs lay 2.5
spreads apart at most; with a shaft that hardened much, 6.4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import log, sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.misfit import robust_squares
from torquerig.diagnosis.judging.band_excess import BandExcess, band_excesses
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.kept import kept
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.repair.common_dropouts import moments_without_signal

Floats = NDArray[np.float64]

_FILLED = 0.9  # share of a band that the load must make
_TOLERANCE = 0.12  # [1] of the density's logarithm: what else differs between two runs
_OF_A_DIP = 0.2  # of the depth of a dip, which whatever stands in it fills
_APART = 4.0  # spreads, in neighbouring bands the same way
_LOWEST = 4.0  # [Hz] below, the load's slow variation rules, and a run holds little of it


def load_contradictions(case: Case, total: float) -> Iterator[Mismatch]:
    """Yield the bands at which a run differs from those of other occupancies and the same particles.

    ``total`` is the excess misfit of which they are a share. Nothing is asked where an effect beyond the twin is in the
    model: it opens under one load and not another.
    """
    if case.model.corrections:
        return
    # what fills moments without signal rings in the dips
    whole = [each for each in band_excesses(case) if not _loses_moments(each.features)]
    every = [_of_the_load(each) for each in whole]
    places = sum(each.log.size for each in every)
    for one in every:
        others = [other for other in every if _like(one.features, other.features)]
        if not others:
            continue
        residual = _apart(one, others)
        for start, stop in _runs_of(residual):
            yield _mismatch(one, residual, slice(start, stop), total, places)


@kept
def _loses_moments(seen: Features) -> bool:
    return bool(moments_without_signal(seen.observed.recording))


def _of_the_load(run: BandExcess) -> BandExcess:
    """Return the excess less its median where the load rules, NaN elsewhere, and all that two loads may differ by."""
    rules = (run.load_share > _FILLED) & (run.features.band > _LOWEST) & np.isfinite(run.log)
    excess = np.where(rules, run.log, np.nan)
    if rules.any():
        excess -= np.nanmedian(excess)  # how many hit in a second is the level's business
    depth = np.maximum(-np.nan_to_num(excess), 0.0)
    return replace(run, log=excess, variance=run.variance + _TOLERANCE**2 + (_OF_A_DIP * depth) ** 2)


def _like(one: Features, other: Features) -> bool:
    first, second = one.observed.run, other.observed.run
    return (
        first.particle_size == second.particle_size
        and first.occupancy_percent != second.occupancy_percent
        and bool(first.occupancy_percent and second.occupancy_percent)
    )


def _apart(one: BandExcess, others: list[BandExcess]) -> Floats:
    """Return by how many spreads a run lies above the mean of the others in each band, 0 where none can be compared."""
    at = np.log(one.features.band)
    total, weight = np.zeros(at.size), np.zeros(at.size)
    for other in others:
        where = np.log(other.features.band)
        value = np.interp(at, where, other.log, left=np.nan, right=np.nan)
        own = np.where(np.isfinite(value), 1 / np.interp(at, where, other.variance), 0.0)
        total, weight = total + own * np.nan_to_num(value), weight + own
    seen = (weight > 0) & np.isfinite(one.log)
    answer = np.zeros(at.size)
    answer[seen] = (one.log[seen] - total[seen] / weight[seen]) / np.sqrt(one.variance[seen] + 1 / weight[seen])
    return answer


def _runs_of(residual: Floats) -> Iterator[tuple[int, int]]:
    """Yield first and one past last of neighbouring bands, two or more, that stand out the same way."""
    out = np.where(np.abs(residual) > _APART, np.sign(residual), 0.0)
    edges = [0, *(np.flatnonzero(np.diff(out)) + 1).tolist(), out.size]
    yield from ((start, stop) for start, stop in pairwise(edges) if out[start] != 0 and stop - start > 1)


def _mismatch(one: BandExcess, residual: Floats, part: slice, total: float, places: int) -> Mismatch:
    features = one.features
    low, high = (float(edges[part][at]) for edges, at in zip(features.band_edges, (0, -1), strict=True))
    spread, squares = np.sqrt(one.variance[part]), float(robust_squares(residual[part]).sum())
    return Mismatch(
        domain="frequency", axis="Hz", at=sqrt(low * high), width=high - low, recordings=(features.observed.name,),
        excess_dB=10 / log(10) * float(np.mean(residual[part] * spread)), share_of_misfit=min(1.0, squares / total),
        p_value=by_chance(float(np.abs(residual[part]).max()), places),
    )  # fmt: skip
