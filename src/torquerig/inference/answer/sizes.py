"""How large an addition is in the reading, in N m (N on a rig that moves in a line)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from torquerig.inference.addition import Addition
from torquerig.inference.engine import Outcome
from torquerig.inference.knobs import turned
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.own_features import difference
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.rig.assembly import Rig

RELEVANCE = 0.03  # [1] of the signal's standard deviation: a smaller nameless effect changes no verdict


def relevance(outcome: Outcome) -> float:
    """Return the rms below which a residual is minor in all runs [N m]."""
    return max(_relevance(outcome, run) for run in outcome.runs)


def _relevance(outcome: Outcome, run: MeasuredRun) -> float:
    """Return the rms below which an effect is minor in a run [N m]: a share of the signal, or the sensor's accuracy."""
    signal = float(np.std(run.torque))
    sensor = outcome.nominal.nominal.part(outcome.nominal.nominal.measured)
    accuracy = getattr(sensor, "accuracy", None)
    return min(RELEVANCE * signal, accuracy) if accuracy else RELEVANCE * signal


def is_minor(outcome: Outcome, each: Addition) -> bool:
    """Return whether a nameless effect is too small in every run to change the verdict.

    What is large in a quiet run is no minor effect, however loud another run is.
    """
    least = [_relevance(outcome, seen.run) for seen in outcome.data.seen]
    return all(size < limit for size, limit in zip(_sizes(outcome, each), least, strict=True))


def without(rig: Rig, additions: Sequence[Addition]) -> Rig:
    """Return a rig without the parts of some additions."""
    for each in additions:
        for part in each.parts:
            rig = rig.without(part.name)
    return rig


def _with_stated(outcome: Outcome, each: Addition) -> Rig:
    """Return the completed rig with a number of the scenario at its stated value."""
    knob, rig = each.knobs[0], outcome.completed
    stated, here = knob.value(outcome.nominal.nominal), knob.value(rig)
    one = replace(knob, spread=1.0)
    position = float(np.log(stated / here)) if knob.factor else stated - here
    return turned(rig, [one], np.array([position]))


def size(outcome: Outcome, each: Addition) -> float:
    """Return the rms by which an addition changes the reading [N m], the largest one of the runs.

    Of lines, of the spectrum between them and of mean torques, also of waves too slow for both that move these; all are
    uncorrelated. Of a number of the scenario it is the change of lines, spectrum and means from the stated value.
    """
    return max(_sizes(outcome, each), default=0.0)


def _sizes(outcome: Outcome, each: Addition) -> Iterator[float]:
    fit = outcome.model.fit
    other = without(outcome.completed, [each]) if each.parts else _with_stated(outcome, each)
    for seen, full in zip(outcome.data.seen, fit.expected, strict=True):
        less = expected_run(other, seen)
        waves = np.diag(full.level_covariance - less.level_covariance) if each.parts else np.zeros(0)
        slow = float(np.abs(waves).mean()) if waves.size else 0.0
        yield float(np.hypot(difference(seen, full, less), np.sqrt(slow)))
