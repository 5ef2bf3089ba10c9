"""Whether the spectrum drifts along the steady runs: what warms up, wears or works loose.

``passing`` tells what comes and goes within one run; here all steady runs are taken together, part by part, so that a
slow change of a stiffness or a damping shows in a load's noise. The parts' own scatter is the measure: a load of single
hits is never the same. Of 268 rigs of seeds 92 and 93 and of a second program that stay what they are, none had a
probability below 0.002, bands counted; a coupling that softened by 72 % had 2e-6.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from torquerig.diagnosis.judging.along_runs import PARTS, SHORTEST, at_their_end, unbroken
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch

Floats = NDArray[np.float64]

_RANGE, _PER_OCTAVE = (20.0, 3000.0), 8  # [Hz]; bands
_TOGETHER = 4  # neighbouring bands
_CHANCE = 1e-4


def changing(runs: Sequence[Observed]) -> tuple[tuple[str, Mismatch], ...]:
    """Return a sentence and a mismatch for the bands that drift most surely; nothing where that is chance.

    Of each band the median over its bins, which no line moves. Runs with moments without signal or at a limit are left
    out: those ring through the spectrum where they happen to be; so are runs too short for parts of ``SHORTEST``.
    """
    whole = unbroken(runs)
    edges = [pair for pair in pairwise(_edges()) if whole and pair[1] < 0.5 * min(run.rate for run in whole)]
    if len(edges) < _TOGETHER:
        return ()
    slope, p_values = _drift(np.array([_course(run, edges) for run in whole]))
    at = int(np.argmin(p_values))
    p_value = min(1.0, p_values.size * float(p_values[at]))
    if p_value > _CHANCE:
        return ()
    risen = 10 / np.log(10) * float(slope[at]) * (1 - 1 / PARTS)
    way = "above" if risen > 0 else "below"
    sentence = (
        f"From {edges[at][0]:.0f} to {edges[at + _TOGETHER - 1][1]:.0f} Hz, the steady recordings end "
        f"{abs(risen):.1f} dB {way} their start. Something changes during the recordings, but the parameters of a "
        "model are constant."
    )
    mismatch = at_their_end(whole, excess_dB=risen, p_value=p_value)
    return ((sentence, mismatch),)


def _edges() -> Floats:
    low, high = _RANGE
    return np.geomspace(low, high, round(np.log2(high / low) * _PER_OCTAVE) + 1)


def _course(run: Observed, edges: Sequence[tuple[float, float]]) -> Floats:
    """Return the logarithm of the density in each part and band, neighbouring bands together, shape (parts, bands)."""
    from scipy.signal import welch

    parts = run.torque[: run.torque.size // PARTS * PARTS].reshape(PARTS, -1)
    frequency, power = welch(parts, run.rate, nperseg=int(SHORTEST * run.rate), axis=1)
    density = np.log(np.maximum(power, np.finfo(float).tiny))
    each = [np.median(density[:, (frequency >= low) & (frequency < high)], axis=1) for low, high in edges]
    return np.asarray(np.lib.stride_tricks.sliding_window_view(np.stack(each, axis=1), _TOGETHER, axis=1).mean(axis=2))


def _drift(courses: Floats) -> tuple[Floats, Floats]:
    """Return by how much each band rises along a run, and the two-sided probability that chance does it.

    One slope over all runs, each with its own mean, against what the parts scatter about it (Student's t).

    Parameters
    ----------
    courses : ndarray, shape (runs, parts, bands)
        The answers are of shape (bands,).
    """
    along = np.linspace(-0.5, 0.5, courses.shape[1])[None, :, None]
    beside = courses - courses.mean(axis=1, keepdims=True)
    weight = len(courses) * float((along**2).sum())
    slope = (beside * along).sum(axis=(0, 1)) / weight
    free = len(courses) * (courses.shape[1] - 1) - 1
    spread = np.sqrt(((beside - slope * along) ** 2).sum(axis=(0, 1)) / free / weight)
    return slope, np.asarray(2 * student.sf(np.abs(slope) / np.maximum(spread, np.finfo(float).tiny), free))
