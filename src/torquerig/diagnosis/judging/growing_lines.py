"""Whether the rig's own lines grow or fade together along the steady runs, as a gain does that warms up.

What makes them is a constant of the rig, and the speed is held: only what passes all of them on can change them alike.
A load that wanders changes what a ripple in proportion to torque makes, but no more at the end than at the beginning.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.stats import norm
from scipy.stats import t as student

from torquerig.diagnosis.judging.along_runs import PARTS, at_their_end, unbroken
from torquerig.diagnosis.looking.observed import Observed, Stretch
from torquerig.diagnosis.looking.stretch_lines import shown_places
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import RESOLVED_WELL, Place

Floats = NDArray[np.float64]

_KNOWN = 0.002  # of a line: no part tells it better, whatever its own scatter is by luck
_CHANCE = 1e-5
_LEAST = 0.02  # of the lines, from the first part to the last: less no gain is known to


def growing_lines(runs: Sequence[Observed], places: Sequence[Place]) -> tuple[tuple[str, Mismatch], ...]:
    """Return a sentence and a mismatch where the lines at ``places`` grow or fade together; nothing where they do not.

    Of each run one slope of all lines' common size, against what its parts scatter about it (Student's t); the runs
    together by their normal scores, each with the weight of its accuracy (Stouffer 1949; Liptak 1958). Runs with
    moments without signal are left out.
    """
    courses = [(run, course) for run in unbroken(runs) if (course := _course(run, places)) is not None]
    if not courses:
        return ()
    slopes, scores, weights = np.array([_slope(course) for _, course in courses]).T
    score = float(scores @ weights / np.sqrt(weights @ weights))
    grown = float(slopes @ weights**2 / (weights @ weights)) * (1 - 1 / PARTS)
    p_value = float(2 * norm.sf(abs(score)))
    if p_value > _CHANCE or abs(grown) < _LEAST:
        return ()
    way = "grow" if grown > 0 else "fade"
    sentence = (
        f"All lines of the rig {way} together by {abs(grown):.1%} along the steady recordings. A gain changes during "
        "the recordings, but the parameters of a model are constant."
    )
    asked = [run for run, _ in courses]
    return ((sentence, at_their_end(asked, excess_dB=20 * float(np.log10(1 + grown)), p_value=p_value)),)


def _course(run: Observed, places: Sequence[Place]) -> Floats | None:
    """Return the logarithm of the size that all lines have in common in each part, shape (parts,); None without lines.

    Each line counts by how little it scatters about its own straight line.
    """
    size = run.torque.size // PARTS
    turning = [place for place in places if place.domain == "order"]
    shown = [turning[row] for row in shown_places(run, Stretch(0, size, False), turning, apart=2 * RESOLVED_WELL)]
    if not shown:
        return None
    window, sizes = np.hanning(size), []
    for part in range(PARTS):
        span = slice(part * size, (part + 1) * size)
        waves = Waves(shown, run.angle[span], np.arange(span.start, span.stop) / run.rate)
        sizes.append(np.abs(regressed(run.torque[span], waves, window=window).amplitude))
    relative = np.array(sizes) / np.mean(sizes, axis=0)
    along = _along()[:, None]
    beside = relative - 1 - along * (relative * along).sum(axis=0) / (along**2).sum()
    spread = np.maximum(np.sqrt((beside**2).sum(axis=0) / (PARTS - 2)), _KNOWN)
    weight = 1 / spread**2
    return np.asarray(np.log(np.maximum(relative, 1e-3)) @ weight / weight.sum())


def _slope(course: Floats) -> tuple[float, float, float]:
    """Return by how much a course rises along the run, its normal score, and one over its standard error."""
    along, free = _along(), PARTS - 2
    square = float(along @ along)
    slope = float(course @ along) / square
    error = float(np.sqrt(((course - course.mean() - slope * along) ** 2).sum() / free / square))
    error = max(error, _KNOWN / PARTS)
    score = float(norm.isf(student.sf(abs(slope) / error, free)))
    return slope, float(np.copysign(score, slope)), 1 / error


def _along() -> Floats:
    return np.linspace(-0.5, 0.5, PARTS)
