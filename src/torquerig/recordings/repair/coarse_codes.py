"""Coarse codes: all values stand on multiples of a step wider than the converter's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import amount, fault_in_time

_COARSER = 1.7  # a lattice must be so many converter steps wide
_FEW = 6  # distinct values, of which none can be spared
_LATTICE_SCORE = 0.5  # share of the samples' phase that must agree with the lattice [1]


@dataclass(frozen=True)
class Codes:
    """All values stand on multiples of ``step`` [V], wider than the converter's own; ``score`` is 1 for exactly."""

    step: float
    score: float


def of_codes(seen: Examination) -> Examination:
    """Find codes coarser than the converter's; the detector for ``DETECTORS``."""
    if not seen.converter_step:
        return seen
    codes = coarse_codes(seen.recordings, converter_step=seen.converter_step)
    if codes is None:
        return seen
    told = [
        fault_in_time(
            each, "coarse codes", 0, each.samples, mechanism="quantization",
            seen=f"all values are multiples of {amount(each, codes.step)}, {codes.step / seen.converter_step:.3g} "
            "steps of the converter",
            repair="models were fitted with these codes",
        )
        for each in seen.recordings
    ]  # fmt: skip
    return replace(seen, coarse_code=codes.step).with_faults(*told)


def coarse_codes(recordings: Sequence[Recording], *, converter_step: float) -> Codes | None:
    """Return the lattice that all samples stand on where it is coarser than the converter's, else None.

    The distances of neighbouring values that occur give the candidates; the mean of ``exp(2 pi i V / step)`` over the
    samples is 1 on a lattice and near 0 off it (the characteristic function, Widrow & Kollar). The largest and the
    smallest value do not count: a limit at which readings stop is on no code.
    """
    values = np.concatenate([recording.torque_values()[::3] for recording in recordings])
    distinct = np.unique(np.round(values / (0.25 * converter_step)).astype(np.int64)) * 0.25 * converter_step
    distinct = distinct[1:-1] if distinct.size > _FEW else distinct
    gaps = np.diff(distinct)
    wide = gaps[gaps > _COARSER * converter_step]
    if wide.size < 3 or wide.size < 0.2 * gaps.size:
        return None
    start = float(np.mean(wide[wide < 1.6 * np.min(wide)]))  # gaps of 3 and 4 codes mean a step between
    trials = start * (1 + np.linspace(-0.08, 0.08, 641))
    score = np.array([_on_lattice(distinct, step) for step in trials])
    coarse = float(trials[int(np.argmax(score))])
    fine = coarse * (1 + np.linspace(-3e-4, 3e-4, 121))
    step = float(fine[int(np.argmax([_on_lattice(distinct, trial) for trial in fine]))])
    own = np.unique(values[np.abs(values / step - np.round(values / step)) * step < converter_step])
    multiple = np.round(own / step)
    if multiple.any():  # the candidates' values were rounded to a quarter of the converter's step
        step = float(own @ multiple / (multiple @ multiple))
    reached = _on_lattice(distinct, step)
    return Codes(step, reached) if reached > _LATTICE_SCORE else None


def _on_lattice(values: NDArray[Any], step: float) -> float:
    return float(np.abs(np.exp(2j * np.pi * values / step).mean()))
