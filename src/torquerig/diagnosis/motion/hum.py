"""Hum of the supply in the effort's channel: a line at 50 or 60 Hz, whatever the motion does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.hum_of_a_run import hums_of, sizes_in
from torquerig.diagnosis.motion.moved import BAND, Moved
from torquerig.inference.knobs import Knob

_MAINS = (50.0, 60.0)  # [Hz]
_NEAR = 2e-3  # of it: what grids keep, and what a run resolves
_HARMONICS = 3
_LEAST = 0.2  # of the rms residual, zero to peak: a fiftieth of its square
_FREQUENCY_SPREAD = 5e-4  # of the frequency


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield hum where the residual has a line at the mains' frequency, of one size in all runs and any phase."""
    if not hasattr(mechanisms, "MainsInterference") or hums_of(model.rig):
        return
    for mains in _MAINS:
        count = min(_HARMONICS, int(BAND * min(run.rate for run in runs) / mains))
        if count < 1:
            continue
        frequency = _tuned(model, runs, mains)
        sizes = _sizes(model, runs, frequency, count)
        if max(sizes) < _LEAST * root_mean_square(model.of(runs)):
            continue
        part = mechanisms.MainsInterference(name="mains_interference", frequency=frequency, amplitudes=sizes)
        knobs = [Knob(part.name, "frequency", _FREQUENCY_SPREAD)]
        knobs += [Knob(part.name, "amplitudes", 0.3, key=at) for at in range(count)]
        yield Candidate(mechanism="mains_interference", parts=(part,), knobs=tuple(knobs))


def _tuned(model: FittedMotion, runs: Sequence[Moved], mains: float) -> float:
    """Return the frequency near the mains' at which the residuals have most [Hz]."""
    tried = mains * (1 + np.linspace(-_NEAR, _NEAR, 81))
    power = np.zeros(tried.size)
    for run, residual in zip(runs, model.residuals, strict=True):
        time, left = run.recording.time()[run.seen], residual[run.seen]
        power += [abs(np.exp(-2j * np.pi * at * time) @ left) ** 2 for at in tried]
    return float(tried[int(np.argmax(power))])


def _sizes(model: FittedMotion, runs: Sequence[Moved], frequency: float, count: int) -> tuple[float, ...]:
    """Return the amplitude of each harmonic, rms of the runs by their samples [N m] or [N]."""
    found = [
        sizes_in(residual, run.recording.time(), run.seen, frequency, count)
        for run, residual in zip(runs, model.residuals, strict=True)
        if run.seen.any()
    ]
    weights = [int(run.seen.sum()) for run in runs if run.seen.any()]
    return tuple(float(np.sqrt(np.average(np.abs(one) ** 2, weights=weights))) for one in np.array(found).T)
