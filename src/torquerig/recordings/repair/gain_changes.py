"""Moments in which all of a signal is larger or smaller by one factor: no load and no line does that, a gain does.

The noise of the sensor above the load's band tells the factor to a per cent, and the step of the mean the sample. Such
moments may take nearly half of a run, so what is normal is told by the half of the time that is most alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import exp

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.edges import edges_over
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, fault_in_time, in_words
from torquerig.recordings.repair.moments import moments_of
from torquerig.recordings.repair.robust_spread import spread_about_zero
from torquerig.recordings.repair.short_spectra import OVERLAP, ShortSpectra, closest_half, short_spectra

Floats = NDArray[np.float64]

_CLEAR = 10.0  # spreads of a mean of so many blocks; clean runs reach 7
_CORES, _EDGE = (8, 16, 32), 3  # blocks
_STILL_APART = 4.0  # spreads of a mean of three blocks
_PASSES = 3
_TRIMMED, _FEWEST = 3, 4  # blocks at either end, which hold the edge, and between
_ALIKE, _MOST = 4.0, 0.6  # spreads or 30 % within which a band follows the factor; so many of the bands do
_OF_THE_FACTOR = 0.3
_SMALLEST = 0.15  # of the logarithm of the factor
_STEP, _LAGS = 8.0, (1, 2, 4, 8)  # robust spreads of an edge that can be seen, and samples that it may take
_REACH = 3  # blocks either way in which the edge is looked for
_BESIDE = 12  # samples either way that a straight line is put through


@dataclass(frozen=True)
class GainMoment:
    """Samples ``start`` to ``stop`` of a signal that is ``factor`` times as large as before and after."""

    start: int
    stop: int
    factor: float


def one_gain(seen: Examination) -> Examination:
    """Scale moments of another gain back."""
    answer, told = list(seen.recordings), list[Fault]()
    for index, (recording, moments) in enumerate(zip(seen.recordings, seen.lost, strict=True)):
        gains = () if recording.name in seen.standing else gain_moments(recording, without=moments)
        if gains:
            answer[index] = with_one_gain(recording, gains)
            told.append(_fault(recording, gains))
    return replace(seen, recordings=tuple(answer)).with_faults(*told)


def _fault(recording: Recording, moments: Sequence[GainMoment]) -> Fault:
    rate, factor = recording.sample_rate, float(np.median([each.factor for each in moments]))
    length = max(each.stop - each.start for each in moments) / rate
    return fault_in_time(
        recording, "gain change", moments[0].start, moments[0].stop, excess=20 * float(np.log10(factor)),
        seen=f"at {in_words([each.start / rate for each in moments])} all of the signal, noise too, is {factor:.3g} "
        f"times as large, for up to {length:.3g} s; that is a gain which changes",
        repair="no mechanism of the library does that: the rest was judged with these moments scaled back",
    )  # fmt: skip


def gain_moments(recording: Recording, *, without: Sequence[tuple[int, int]] = ()) -> tuple[GainMoment, ...]:
    """Return the moments in which the spectrum of a run stands higher or lower as a whole.

    Parameters
    ----------
    recording : Recording
    without : sequence of (int, int)
        Moments that are known to hold no signal.
    """
    volts = recording.torque_values()
    rate, moving = recording.sample_rate, recording.run.profile != "steady"
    spectra, blocks = short_spectra(volts, rate, without=without, moving=moving), list[tuple[int, int]]()
    for _ in range(_PASSES):  # what was found no longer hides what is like it
        found = [] if spectra is None else [*_apart(spectra)]
        if spectra is None or found == blocks:
            break
        blocks, apart = found, [(start * spectra.hop, stop * spectra.hop) for start, stop in found]
        spectra = short_spectra(volts, rate, without=without, apart=apart, moving=moving)
    if spectra is None:
        return ()
    moments = (_moment(volts, spectra, start, stop) for start, stop in blocks)
    return tuple(moment for moment in moments if moment is not None)


def with_one_gain(recording: Recording, moments: Sequence[GainMoment]) -> Recording:
    """Return the recording with the signal of the moments divided by their factors, joined to what is beside them.

    About which zero the gain changed is not known, so each moment is moved until its ends meet their neighbours.
    """
    name = recording.torque_name()
    volts = recording.channels[name].values.copy()
    for moment in moments:
        inside = volts[moment.start : moment.stop] / moment.factor
        first = _at_end(volts[: moment.start][::-1]) - _at_end(inside) if moment.start else None
        last = _at_end(volts[moment.stop :]) - _at_end(inside[::-1]) if moment.stop < volts.size else first
        start = last if first is None else first
        volts[moment.start : moment.stop] = inside + np.linspace(start or 0.0, last or 0.0, inside.size)
    return recording.with_values(name, volts)


def _at_end(values: Floats) -> float:
    """Return where a straight line through the first samples starts."""
    near = values[:_BESIDE]
    if near.size < _BESIDE:
        return float(near.mean())
    return float(np.polyfit(np.arange(_BESIDE) + 0.5, near, 1)[1])


def _apart(spectra: ShortSpectra) -> Iterator[tuple[int, int]]:
    """Yield first block and one past the last of each time in which the bands as a whole stand elsewhere."""
    series = spectra.joint(spectra.log)
    clear = np.array([spectra.over_spread(series, core, normal=closest_half) for core in _CORES])
    clear = np.take_along_axis(clear, np.abs(clear).argmax(axis=0)[None], axis=0)[0]
    near = spectra.over_spread(series, _EDGE, normal=closest_half)
    for sign in (1.0, -1.0):
        apart = sign * near > _STILL_APART
        for start, stop in moments_of(apart):
            if stop - start >= 2 * _TRIMMED + _FEWEST and (sign * clear[start:stop] > _CLEAR).any():
                yield start, stop


def _moment(volts: Floats, spectra: ShortSpectra, start: int, stop: int) -> GainMoment | None:
    """Return the moment in these blocks, None where the bands do not follow one factor or no step is at its ends."""
    inside = spectra.log[:, start + _TRIMMED : stop - _TRIMMED].mean(axis=1)
    log_power = float(spectra.joint(inside))
    spread = spectra.spread / np.sqrt(max((stop - start - 2 * _TRIMMED) / OVERLAP, 1.0))
    alike = np.abs(inside - log_power) < np.maximum(_ALIKE * spread, _OF_THE_FACTOR * abs(log_power))
    same_way = inside * np.sign(log_power) > 0
    if abs(log_power) < 2 * _SMALLEST or np.mean(alike & same_way) < _MOST:
        return None
    first, last = (_step(volts, spectra.hop, block) for block in (start, stop))
    if first is None and last is None:
        return None
    first, last = first or start * spectra.hop, last or min(stop * spectra.hop, volts.size)
    return GainMoment(first, last, exp(0.5 * log_power))


def _step(volts: Floats, hop: int, block: int) -> int | None:
    """Return the sample after the largest edge near a block's start, sharp or rounded; None where none is clear."""
    low = max((block - _REACH) * hop, 0)
    near = volts[low : (block + _REACH + 1) * hop]
    for lag in _LAGS:
        edges = np.abs(np.diff(near) if lag == 1 else edges_over(near, lag))
        at = int(np.argmax(edges)) if edges.size else 0
        part = 3 * lag if lag > 1 else 0  # of the edge itself, on either side
        if not part < at < edges.size - 1 - part:
            continue
        noise = max(spread_about_zero(edges[: at - part]), spread_about_zero(edges[at + 1 + part :]))
        if edges[at] > _STEP * max(noise, 1e-12):
            return low + at + 1 + lag // 2
    return None
