"""What comes and goes within a steady run: all else that is judged is a mean over the run.

The spectrum of a steady run is the same all along, as far as a random load allows; what a finished rig does not do when
it is simulated, and the recording did for a while, is no physics of that rig.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.simulated import simulated
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.diagnosis.looking.observed import Observed
from torquerig.errors import SimulationError
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.repair.common_dropouts import moments_without_signal
from torquerig.recordings.repair.short_spectra import short_spectra
from torquerig.rig.assembly import Rig

_LENGTHS = (8, 16, 32)  # blocks
_ALL, _ONE_BAND = 15.0, 40.0  # spreads; without such an effect 10 are reached, and 40 where struck modes beat
_MORE = 3.0  # times as many spreads as a simulation of the finished rig shows
_SEED = 23


def passing(case: Case, completed: Rig) -> tuple[Mismatch, ...]:
    """Return the times at which the spectrum of a steady run stands elsewhere, and that of a simulation does not.

    Parameters
    ----------
    case : Case
        With the finished model.
    completed : Rig
        The finished rig, faults of the samples included.
    """
    step = max((part.step for part in completed.of_kind("quantization")), default=0.0)
    largest = [_largest(run, step) for run in case.runs]
    return tuple(each.mismatch for each in largest if each is not None and _alone(each, completed, step))


@dataclass(frozen=True)
class _Passing:
    """The time at which a run differs most from the rest of it, and by how many thresholds."""

    run: Observed
    start: float  # [s]
    length: float  # [s]
    log_power: float
    clear: float
    places: int

    @property
    def mismatch(self) -> Mismatch:
        return Mismatch(
            domain="time", axis="s", at=self.start, width=self.length, recordings=(self.run.name,),
            excess_dB=10 * self.log_power / float(np.log(10)), share_of_misfit=0.0,
            p_value=by_chance(_ALL * self.clear, self.places),
        )  # fmt: skip


def _largest(run: Observed, step: float) -> _Passing | None:
    """Return the time of a steady run whose spectrum stands out most, where it does beyond the thresholds.

    ``step`` is that of coarse codes [V], 0 without them.
    """
    if not run.steady:
        return None
    without = [*moments_without_signal(run.recording), *run.struck]
    spectra = short_spectra(_rounded_evenly(run, step), run.rate, without=without)
    if spectra is None:
        return None
    rows = [(spectra.joint(spectra.log), _ALL), *((band, _ONE_BAND) for band in spectra.log)]
    every = np.array([[spectra.over_spread(row, size) / limit for row, limit in rows] for size in _LENGTHS])
    length, row, middle = np.unravel_index(int(np.abs(every).argmax()), every.shape)
    size, clear = _LENGTHS[length], float(np.abs(every[length, row, middle]))
    if clear < 1:
        return None
    start, second = int(middle) - size // 2, run.rate / spectra.hop
    log_power = float(rows[row][0][start : start + size].mean())
    return _Passing(run, start / second, size / second, log_power, clear, every.size)


def _rounded_evenly(run: Observed, step: float) -> NDArray[np.float64]:
    """Return the torque, coarse codes spread over their steps by chance: one that rests has no spectrum at all."""
    spread = np.random.default_rng(_SEED).uniform(-0.5, 0.5, run.torque.size) if step else 0.0
    return np.asarray(run.torque + step * run.torque_unit * spread)


def _alone(found: _Passing, completed: Rig, step: float) -> bool:
    """Whether the recording shows much more of it than the finished rig, simulated."""
    try:
        copy = _largest(simulated(completed, found.run, seed=_SEED), step)
    except SimulationError:
        return False
    return copy is None or found.clear > _MORE * copy.clear
