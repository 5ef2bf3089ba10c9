"""A line that sweeps from one frequency to another while the shaft keeps its speed: whatever makes it, it is no order.

The line is found by summing the spectrogram along straight paths (a Hough transform of the log power over its median in
time, as for the chirps of gravitational waves: Krishnan et al. 2004, Phys. Rev. D 70, 082001), and taken out as its own
slow envelope times its carrier.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, fault_in_frequency
from torquerig.recordings.repair.path_sum import largest_path_sum
from torquerig.recordings.repair.short_spectra import OVERLAP, spectrogram
from torquerig.recordings.repair.sweep_course import Sweep, refined, without_sweep

Floats = NDArray[np.float64]

# spreads, in one run or by the sum over all: a struck mode has reached 10 in one run, faint sweeps 10 in each of two
CLEAR = 14.0
_SUPPORTING = 4.0  # spreads, in a run of a path that all runs tell together
_BLOCK = 0.16  # [s], every half of which a new one begins: 6 Hz
_LOWEST, _HIGHEST = 60.0, 4000.0  # [Hz]
_FEWEST = 40  # blocks
_FAR, _NO_ORDER = 6, 0.08  # bins, and logarithm, that a line must move by: with the speed an order wanders by less
_AROUND = 17  # bins whose median is taken off: 100 Hz that get loud together are no line
_CAPPED = (-3.0, 8.0)  # of the log power: one loud block is no path
_ALL_ALONG = 0.65  # share of its blocks in which a line stands above the mean; 0.45 for modes that are struck


def without_sweeps(seen: Examination) -> Examination:
    """Remove lines that sweep while the speed is steady, and the same from runs whose speed changes."""
    answer, told = list(seen.recordings), list[Fault]()
    volts = [(each.torque_values(), each.sample_rate) for each in answer]
    steady = [index for index, each in enumerate(answer) if each.run.profile == "steady"]
    sweeps = dict(zip(steady, sweeps_in([volts[index] for index in steady]), strict=True))
    known = [sweep for sweep in sweeps.values() if sweep is not None]
    swept = tuple((min(sweep.start, sweep.stop), max(sweep.start, sweep.stop)) for sweep in known)
    for index, recording in enumerate(answer):
        sweep = sweeps[index] if index in sweeps else sweep_along(*volts[index], known)
        if sweep is not None:
            answer[index] = recording.with_values(recording.torque_name(), without_sweep(*volts[index], sweep))
            told.append(_fault(recording, sweep))
    return replace(seen, recordings=tuple(answer), swept=swept).with_faults(*told)


def _fault(recording: Recording, sweep: Sweep) -> Fault:
    return fault_in_frequency(
        recording, "sweep", 0.5 * (sweep.start + sweep.stop), width=abs(sweep.stop - sweep.start),
        excess=20 * float(np.log10(sweep.clear)),
        seen=f"a line sweeps from {sweep.start:.5g} to {sweep.stop:.5g} Hz over the run, and nothing of a rig does "
        "that at a steady speed",
        repair="no mechanism of the library does it either: the rest was judged without it",
    )  # fmt: skip


def sweeps_in(runs: Sequence[tuple[Floats, float]]) -> list[Sweep | None]:
    """Return the clearest sweep of each steady run, None where no path stands out, in it or in all of them together.

    Parameters
    ----------
    runs : sequence of (ndarray, shape (samples,), float)
        Samples, and their rate [Hz].
    """
    maps = [_log_power(values, rate) for values, rate in runs]
    own = [None if each is None else _clearest(*each) for each in maps]
    answer = [
        refined(*run, path.sweep) if path is not None and _stands_out(path.clear, path.share) else None
        for run, path in zip(runs, own, strict=True)
    ]
    shared = _shared([each for each in maps if each is not None], [each for each in own if each is not None])
    if shared is None:
        return answer
    there = [None if each is None else _path(*each, shared.start, shared.stop) for each in maps]
    first = int(np.argmax([-np.inf if path is None else path.clear for path in there]))
    leading = refined(*runs[first], shared.sweep)  # its ends are told best where it is clearest
    return [
        replace(leading, clear=path.clear) if told is None and path is not None and path.clear > _SUPPORTING else told
        for told, path in zip(answer, there, strict=True)
    ]


@dataclass(frozen=True)
class _Path:
    """A straight path through a map: its ends [Hz], its sum in spreads, the share of its blocks above the mean."""

    start: float
    stop: float
    clear: float
    share: float

    @property
    def sweep(self) -> Sweep:
        return Sweep(self.start, self.stop, self.clear)


def _clearest(log: Floats, frequency: Floats) -> _Path | None:
    """Return the path of the largest sum, None where it keeps its order."""
    _, start, stop = largest_path_sum(log, _FAR)
    moves = abs(float(np.log(frequency[stop] / frequency[start])))
    return None if moves < _NO_ORDER else _path(log, frequency, float(frequency[start]), float(frequency[stop]))


def _path(log: Floats, frequency: Floats, start: float, stop: float) -> _Path:
    first, last = np.interp([start, stop], frequency, np.arange(frequency.size))
    rows = np.arange(log.shape[0])
    met = log[rows, np.linspace(first + 0.5, last + 0.5, rows.size).astype(np.intp)]
    return _Path(start, stop, float(met.sum() / np.sqrt(met.size * OVERLAP)), float(np.mean(met > 0)))


def _shared(maps: Sequence[tuple[Floats, Floats]], own: Sequence[_Path]) -> _Path | None:
    """Return the path of one run that stands out in all of them together, or None."""
    for path in own:
        each = [_path(*found, path.start, path.stop) for found in maps]
        clear = sum(one.clear for one in each) / len(each) ** 0.5
        share = sum(one.share for one in each) / len(each)
        if _stands_out(clear, share):
            return path
    return None


def _stands_out(clear: float, share: float) -> bool:
    return clear >= CLEAR and share >= _ALL_ALONG


def sweep_along(values: Floats, rate: float, sweeps: Sequence[Sweep]) -> Sweep | None:
    """Return the sweep of a run whose orders sweep too, where one of the ``sweeps`` of other runs is clear there."""
    found = _log_power(values, rate)
    if found is None:
        return None
    for sweep in sweeps:
        path = _path(*found, sweep.start, sweep.stop)
        if path.clear > CLEAR:
            return refined(values, rate, path.sweep)
    return None


def _log_power(values: Floats, rate: float) -> tuple[Floats, Floats] | None:
    """Return the log power over its medians in time and frequency, in units of its spread, and its frequencies."""
    from scipy.ndimage import median_filter

    hop = round(0.5 * _BLOCK * rate)
    if not hop or values.size < (_FEWEST + 1) * hop:
        return None
    power, frequency = spectrogram(values, rate, hop)
    used = (frequency >= _LOWEST) & (frequency < min(_HIGHEST, 0.45 * rate))
    if np.count_nonzero(used) < _AROUND:
        return None
    middle = np.median(power[:, used], axis=0)
    log = np.log(np.maximum(power[:, used] / np.maximum(middle, 1e-300), 1e-9))
    log = np.clip(log - median_filter(log, size=(1, _AROUND), mode="nearest"), *_CAPPED)
    return np.asarray((log - log.mean()) / max(float(log.std()), 1e-9)), frequency[used]
