"""Hum of the supply in the effort's channel: a line at 50 or 60 Hz, whatever the motion does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate
from torquerig.diagnose.fitting.knobs import Knob
from torquerig.diagnose.motion.evidence import root_mean_square
from torquerig.diagnose.motion.fitted import FittedMotion
from torquerig.diagnose.motion.moved import BAND, Moved

Floats = NDArray[np.float64]

_MAINS = (50.0, 60.0)  # [Hz]
_NEAR = 2e-3  # of it: what grids keep, and what a run resolves
_HARMONICS = 3
_LEAST = 0.2  # of the rms residual, zero to peak: a fiftieth of its square
_PHASE_SPREAD, _FREQUENCY_SPREAD = 0.1, 5e-4  # [rad]; of the frequency


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield hum where the residual has a line at the mains' frequency.

    Of one run alone: its phase is another one in the next.
    """
    if len(runs) > 1 or not hasattr(mechanisms, "MainsInterference"):
        return
    (run,), (residual,) = runs, model.residuals
    if any(part.kind == "mains_interference" for part in model.rig.parts):
        return
    for mains in _MAINS:
        count = min(_HARMONICS, int(BAND * run.rate / mains))
        if count < 1:
            continue
        frequency = _tuned(run, residual, mains)
        found = _sizes(run, residual, frequency, count)
        if max(abs(size) for size in found) < _LEAST * root_mean_square([residual[run.seen]]):
            continue
        part = mechanisms.MainsInterference(
            name="mains_interference", frequency=frequency, amplitudes=tuple(float(abs(size)) for size in found),
            phases=tuple(float(np.angle(size)) for size in found),
        )  # fmt: skip
        knobs = [Knob(part.name, "frequency", _FREQUENCY_SPREAD)]
        knobs += [Knob(part.name, "amplitudes", 0.3, key=at) for at in range(count)]
        knobs += [Knob(part.name, "phases", _PHASE_SPREAD, key=at, factor=False) for at in range(count)]
        yield Candidate(mechanism="mains_interference", parts=(part,), knobs=tuple(knobs))


def _tuned(run: Moved, residual: Floats, mains: float) -> float:
    """Return the frequency near the mains' at which the residual has most [Hz]."""
    time, seen = run.recording.time(), run.seen
    tried = mains * (1 + np.linspace(-_NEAR, _NEAR, 81))
    sums = [abs(np.exp(-2j * np.pi * at * time[seen]) @ residual[seen]) for at in tried]
    return float(tried[int(np.argmax(sums))])


def _sizes(run: Moved, residual: Floats, frequency: float, count: int) -> list[complex]:
    """Return the complex amplitude of each harmonic by least squares [N m] or [N]."""
    phase = 2 * np.pi * frequency * run.recording.time()[run.seen]
    columns = [wave(h * phase) for h in range(1, count + 1) for wave in (np.cos, np.sin)]
    found = np.linalg.lstsq(np.column_stack([*columns, np.ones(phase.size)]), residual[run.seen], rcond=None)[0]
    return [complex(found[2 * h], -found[2 * h + 1]) for h in range(count)]
