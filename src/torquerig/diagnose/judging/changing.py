"""Whether the steady runs end with another spectrum than they begin with: what warms up, wears or works loose.

``passing`` tells what comes and goes within one run; here all steady runs are taken together, from the first to the
last part of each, so that a slow change of a stiffness or a damping shows in a load's noise. Of 172 blind rigs, those
whose numbers stay reached 6.6 spreads where no run was at a limit, a coupling that softened by 72 % made 15.8.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.judging.chance import by_chance
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.sample_faults import moments_lost

Floats = NDArray[np.float64]

_PART = 0.4  # of a run, at either end
_SEGMENT = 0.4  # [s]
_RANGE, _PER_OCTAVE = (20.0, 3000.0), 8  # [Hz]; bands
_TOGETHER = 4  # neighbouring bands, the same way
_TOLERANCE = 0.05  # [1] of the density's logarithm: by so much a load of single hits is never the same
_MEDIAN = 1.57  # variance of a median over that of a mean
_APART, _OVERDISPERSED = 9.0, 2.0  # spreads; by which steady rigs' largest exceed those of normal variates


def changing(runs: Sequence[Observed]) -> tuple[tuple[str, Mismatch], ...]:
    """Return a sentence and a mismatch for the bands that end most unlike they begin; nothing where that is chance.

    Of each band the median over its bins, which no line moves. Runs with moments without signal or at a limit are left
    out: those ring through the spectrum where they happen to be.
    """
    whole = [run for run in runs if run.steady and not run.rebuilt and not moments_lost(run.recording)]
    if not whole:
        return ()
    every = np.array([_fall(run) for run in whole])
    fall, spread = every[:, 0].sum(axis=0), np.sqrt((every[:, 1] ** 2).sum(axis=0))
    together = np.convolve(fall / spread, np.ones(_TOGETHER), "valid") / np.sqrt(_TOGETHER)
    at = int(np.argmax(np.abs(together)))
    if abs(together[at]) < _APART:
        return ()
    low, high = (float(edge) for edge in _edges()[[at, at + _TOGETHER]])
    changed = 10 / np.log(10) * float(every[:, 0, at : at + _TOGETHER].mean())
    longest = max(run.recording.duration for run in whole)
    way = "below" if changed > 0 else "above"
    sentence = (
        f"between {low:.0f} and {high:.0f} Hz the steady runs end {abs(changed):.1f} dB {way} what they "
        "begin with: something changes while they run, and the numbers of a rig are constants"
    )
    mismatch = Mismatch(
        domain="time", axis="s", at=(1 - 0.5 * _PART) * longest, width=_PART * longest,
        recordings=tuple(run.name for run in whole), excess_dB=-changed, share_of_misfit=0.0,
        p_value=by_chance(abs(float(together[at])) / _OVERDISPERSED, together.size),
    )  # fmt: skip
    return ((sentence, mismatch),)


def _edges() -> Floats:
    low, high = _RANGE
    return np.geomspace(low, high, round(np.log2(high / low) * _PER_OCTAVE) + 1)


def _fall(run: Observed) -> tuple[Floats, Floats]:
    """Return by how much each band's density falls from beginning to end, and its spread, both of its logarithm.

    Shapes (bands,); 0 where the run is sampled too slowly to show the band.
    """
    from scipy.signal import welch

    size, segment = int(_PART * run.torque.size), int(_SEGMENT * run.rate)
    ends = [welch(part, run.rate, nperseg=segment) for part in (run.torque[:size], run.torque[-size:])]
    frequency, first, last = ends[0][0], ends[0][1], ends[1][1]
    edges = _edges()
    fall, spread = np.zeros(edges.size - 1), np.full(edges.size - 1, np.sqrt(2) * _TOLERANCE)
    segments = 2 * size / segment - 1  # that overlap by half, and are about independent under a Hann window
    for band, (low, high) in enumerate(pairwise(edges)):
        inside = (frequency >= low) & (frequency < high) & (first > 0) & (last > 0)
        if inside.any() and high < 0.5 * run.rate:
            fall[band] = np.median(np.log(first[inside])) - np.median(np.log(last[inside]))
            chance = 2 * _MEDIAN / (inside.sum() * segments / 2)
            spread[band] = np.sqrt(chance + 2 * _TOLERANCE**2)
    return fall, spread
