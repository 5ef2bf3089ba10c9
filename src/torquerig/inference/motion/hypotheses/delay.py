"""The time between motion and effort: a low-pass in one channel, or a logger that scans one after the other.

An effort that is late by tau is ``e(t) = N(t - tau)`` with N the needed effort. To first order its residual is

    e - N = -tau de/dt

so the delay is linear, and its likelihood weighs frequencies by the density of the residual. True for delays below a
sixth of the shortest period that is compared. Source: Knapp & Carter 1976, IEEE Trans. ASSP 24, 320.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis
from torquerig.inference.motion.imposed_run import ImposedRun

_SAMPLES = 1.0  # standard deviation of the delay: one scan of a logger

Floats = NDArray[np.float64]


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield one delay [s] for all runs."""
    if all(each.kind != "effort_delay" for each in fit.model.additions):
        yield Hypothesis(
            name="effort_delay", kind="effort_delay", label="a delay between motion and effort", columns=_later,
            scale=_SAMPLES / min(run.rate for run in fit.runs), log_odds=MECHANISM, axis="time",
        )  # fmt: skip


def _later(run: ImposedRun) -> Floats:
    return np.asarray(-run.rate * np.gradient(run.effort))[:, None]
