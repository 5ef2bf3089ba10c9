"""The sampling that a column of times shows: even, with coarse or late stamps, or with gaps."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.gaps import has_pauses
from torquerig.recordings.files.rate_changes import stretches_of_rates
from torquerig.recordings.files.time_band import narrowest_band
from torquerig.recordings.files.time_ticks import are_whole, rate_of_ticks

Floats = NDArray[np.float64]

# largest deviation of a time from the even grid [samples]; one lost sample makes half a sample or more
_UNEVEN = 0.25
# limit of a regular step [samples]: one lost sample makes a step of two
_JUMP = 0.5
# lost samples at random are as regular as coarse stamps once in k**k / k! files: in 400 for eight
_REGULAR_STEPS = 8
# samples of which the middle lateness is taken at least; below eight of these, late stamps are not judged [1]
_MEDIAN_OF = 25
# steps scatter by less than this where the times themselves are sound [samples]; then few of them may be late [1]
_SOUND, _FEW = 0.02, 0.01
# a clock that drifts by less than this share of the time is still one rate [1]
_DRIFT = 1e-4
# blocks whose earliest times are compared at least; a lost sample shifts those of later ones by 0.8 samples or more
_BLOCKS = 16
# short steps make up for so much of the long ones where times catch up; after lost samples there are none [1]
_CAUGHT_UP = 0.5
# rounded times have at most so many sizes of steps, and the second most frequent has more than this share [1]
_SIZES, _USUAL = 12, 0.1
# gaps named in a message
_NAMED = 3
CHANGES = "changes its rate"
"""How the problem of times with two rates or more begins."""


@dataclass(frozen=True, kw_only=True)
class Timing:
    """The sampling that times show.

    Parameters
    ----------
    rate : float
        [Hz].
    uncertainty : float
        Of the rate, relative.
    scatter : float
        The largest deviation of a step from one sample that comes from coarse or late stamps [s]; 0 for sound times.
    note : str
        How the rate was found, where the stamps are coarse or late.
    problem : str
        Why the samples are not even, with counts and places; empty where they are.
    """

    rate: float
    uncertainty: float = 1e-6
    scatter: float = 0.0
    note: str = ""
    problem: str = ""


def timing_of(times: Floats, *, name: str, stated: float | None = None) -> Timing:
    """Return the sampling of ``times`` [s], shape (samples,); fewer than two are a problem.

    Even times deviate from an even grid by less than a quarter of a sample. Coarse stamps (whole milliseconds at
    2.5 kHz) all lie within one grain of an even grid. Late stamps (of a computer's clock) come back to it. A lost or
    doubled sample shifts all that follow; it is a problem, which nothing hides.

    Parameters
    ----------
    times : ndarray, shape (samples,)
    name : str
        Of the column, for the note.
    stated : float, optional
        A rate that is known otherwise [Hz].
    """
    if times.size < 2:
        return Timing(rate=float("nan"), problem=f"has {times.size} time{'s' * (times.size != 1)}, and 2 are needed")
    steps = np.diff(times)
    sound = np.isfinite(steps) & (steps >= 0)
    if not sound.all() or not steps.any():
        broken = int(np.argmin(sound & (steps > 0))) + 1
        before, after = f"{times[broken - 1]:.9g} s", f"{times[broken]:.9g}"
        return Timing(rate=_usual_rate(steps), problem=f"does not rise at sample {broken} ({before}, then {after})")
    rate = (times.size - 1) / float(times[-1] - times[0])
    off = (times - times[0]) * rate - np.arange(times.size)
    worst = float(np.abs(off).max())
    if worst <= _UNEVEN and steps.all():
        tolerance = max(1e-11, 2 * worst / (times.size - 1))
        return Timing(rate=shortest_rate(rate, tolerance=tolerance), uncertainty=tolerance)
    if has_pauses(steps):
        return _uneven(times, steps, worst)
    return (
        _in_ticks(times, name, stated)
        or _coarse(times, steps, name, stated)
        or _late(times, steps, name)
        or _late_with_pauses(times, steps, name)
        or _uneven(times, steps, worst)
    )


def shortest_rate(rate: float, *, tolerance: float) -> float:
    """Return the shortest decimal within the relative ``tolerance`` of ``rate``: 25000, not 24999.9999999987."""
    for digits in range(1, 17):
        candidate = float(f"{rate:.{digits}g}")
        if abs(candidate - rate) <= tolerance * rate:
            return candidate
    return rate


def _in_ticks(times: Floats, name: str, stated: float | None) -> Timing | None:
    """Return the sampling where each tick of the clock has as many samples, else None."""
    found = rate_of_ticks(times)
    if found is None:
        return None
    rate, uncertainty, tick = found
    is_stated = stated is not None and abs(stated / rate - 1) <= uncertainty
    rate = stated if stated is not None and is_stated else shortest_rate(rate, tolerance=uncertainty / 2)
    note = (
        f"the times of {name} are in steps of {tick:.3g} s, {rate * tick:.3g} samples; they fit an even "
        f"{rate:.6g} Hz (+- {100 * uncertainty:.2g} %)"
    )
    return Timing(rate=rate, uncertainty=uncertainty, scatter=tick, note=note)


def _coarse(times: Floats, steps: Floats, name: str, stated: float | None) -> Timing | None:
    """Return the sampling where all times lie within one grain of an even grid, else None."""
    scale = float(np.median(steps[steps > 0]))
    distinct, counts = np.unique(np.round(steps / scale, 3), return_counts=True)
    if distinct.size < 2:
        return None
    unit = float(np.diff(distinct).min())
    if not are_whole(distinct / unit):
        return None
    grain = unit * scale
    width, step = narrowest_band(times)
    fits = width <= 1.01 * grain
    fits_stated = False
    if fits and stated is not None:
        fits_stated = float(np.ptp(times - np.arange(times.size) / stated)) <= 1.01 * grain
        step = 1 / stated if fits_stated else step
    # a few doubled or lost samples fit as well; at a stated rate rounding makes a known number of other steps
    others = int(counts.sum() - counts.max())
    rounded = steps.size * _share_of_other_steps(step / grain) if fits_stated else 0.0
    if not fits or (others < _REGULAR_STEPS and others > 2 * rounded):
        return None
    uncertainty = grain / float(times[-1] - times[0])
    rate = shortest_rate(1 / step, tolerance=uncertainty)
    note = (
        f"the times of {name} are in steps of {grain:.3g} s, {grain / step:.3g} samples; they fit an even "
        f"{rate:.6g} Hz (+- {100 * uncertainty:.2g} %)"
    )
    return Timing(rate=rate, uncertainty=uncertainty, scatter=grain, note=note)


def _share_of_other_steps(grains: float) -> float:
    """Return the share of steps that are not the usual one, where each sample is ``grains`` long and times rounded."""
    share = grains % 1
    return min(share, 1 - share)


def _late(times: Floats, steps: Floats, name: str) -> Timing | None:
    """Return the sampling where late times come back to an even grid, else None."""
    samples = times.size
    step = float(times[-1] - times[0]) / (samples - 1)
    lateness = times - times[0] - step * np.arange(samples)
    spread = 1.4826 * float(np.median(np.abs(np.diff(lateness) - np.median(np.diff(lateness))))) / 2**0.5
    if spread < _SOUND * step:
        return _few_late(times, steps, name)
    if samples < 8 * _MEDIAN_OF:
        return None
    # enough samples that the middle lateness of two blocks differs by half a sample only in one of 10**6
    block = min(max(_MEDIAN_OF, ceil((18 * spread / step) ** 2)), samples // 4)
    blocks = samples // block
    middles = np.median(lateness[: blocks * block].reshape(blocks, block), axis=1)
    places = (np.arange(blocks) + 0.5) * block
    slope, start = np.polyfit(places, middles, 1)
    residual = middles - start - slope * places
    shifts = np.abs(residual[min(2, blocks - 1) :] - residual[: -min(2, blocks - 1)])
    drift = float(np.abs(residual).max())
    if shifts.max() >= 1.2 * _JUMP * step or drift > max(_JUMP * step, _DRIFT * samples * step):
        return None
    step += float(slope)
    lateness = times - times[0] - start - step * np.arange(samples)
    uncertainty = max(1e-6, 4 * spread / (step * samples), drift / (step * samples))
    rate = shortest_rate(1 / step, tolerance=uncertainty)
    repeated = int(np.count_nonzero(steps == 0))
    same = f", {repeated} are the same as the one before" if repeated else ""
    seen = "" if block >= (18 * spread / step) ** 2 else "; a single lost sample would not be seen"
    note = (
        f"the times of {name} scatter by {np.std(lateness):.3g} s and are up to {np.abs(lateness).max():.3g} s off"
        f"{same}; they come back to an even {rate:.6g} Hz (+- {100 * uncertainty:.2g} %){seen}"
    )
    return Timing(rate=rate, uncertainty=uncertainty, scatter=3 * float(np.abs(steps - step).max()), note=note)


def _late_with_pauses(times: Floats, steps: Floats, name: str) -> Timing | None:
    """Return the sampling where the earliest time of every block is on one even grid, else None.

    A pause of the computer delays many samples in a row, so that the middle of a block is late; the times after it
    catch up, and the earliest ones are as before. The blocks are as short as that allows.
    """
    step = float(times[-1] - times[0]) / (times.size - 1)
    short, long = steps[steps < (1 - _JUMP) * step], steps[steps > (1 + _JUMP) * step]
    caught_up = float(np.sum(step - short)) >= _CAUGHT_UP * float(np.sum(long - step))
    if not caught_up or _are_rounded(steps):
        return None
    block = _MEDIAN_OF
    while times.size // block >= _BLOCKS:
        places, earliest = _earliest(times, block)
        slope, start = np.polyfit(places, earliest, 1)
        off = float(np.abs(earliest - start - slope * places).max())
        if off < 0.5 * _JUMP * slope:
            uncertainty = max(1e-6, 4 * off / (slope * times.size))
            rate = shortest_rate(1 / float(slope), tolerance=uncertainty)
            latest = float(np.max(times - start - slope * np.arange(times.size)))
            note = (
                f"the times of {name} are up to {latest:.3g} s late; at least one of {block} comes back to an even "
                f"{rate:.6g} Hz (+- {100 * uncertainty:.2g} %); a sample lost among the last {block} would not be seen"
            )
            scatter = 3 * float(np.abs(steps - slope).max())
            return Timing(rate=rate, uncertainty=uncertainty, scatter=scatter, note=note)
        block *= 2
    return None


def _are_rounded(steps: Floats) -> bool:
    """Return whether the steps have few sizes, of which several are usual: a lost sample is not seen among them."""
    sizes, counts = np.unique(np.round(steps / np.median(steps[steps > 0]), 3), return_counts=True)
    return sizes.size <= _SIZES and int(np.sort(counts)[-2:].min()) > _USUAL * steps.size


def _earliest(times: Floats, block: int) -> tuple[NDArray[np.intp], Floats]:
    """Return the sample and the time of the earliest of each block and of the last ones, against an even grid."""
    samples = times.size
    off = times - np.linspace(times[0], times[-1], samples)
    whole = off[: samples // block * block].reshape(-1, block)
    places = np.append(whole.argmin(axis=1) + block * np.arange(whole.shape[0]),
                       samples - block + int(np.argmin(off[-block:])))  # fmt: skip
    return places, times[places]


def _few_late(times: Floats, steps: Floats, name: str) -> Timing | None:
    """Return the sampling of sound times of which a few are late, and which then go on as before, else None."""
    step = 1 / _usual_rate(steps)
    lateness = np.abs(times - times[0] - step * np.arange(times.size)) / step
    late = np.flatnonzero(lateness > _UNEVEN)
    if late.size > _FEW * times.size or lateness[-1] > _UNEVEN:
        return None
    rate = shortest_rate(1 / step, tolerance=1e-6)
    most = float(lateness.max())
    note = f"{_counted(lateness > _UNEVEN, 'time')} of {name} off an even {rate:.6g} Hz, by up to {most:.3g} samples"
    return Timing(rate=rate, uncertainty=1e-6, scatter=2 * most * step, note=note)


def _uneven(times: Floats, steps: Floats, worst: float) -> Timing:
    """Return the sampling of uneven times, with what is lost and doubled, or where the rate changes."""
    stretches = stretches_of_rates(times)
    if stretches:
        named = ", ".join(f"{one.rate:.6g} Hz from sample {one.first} on" for one in stretches)
        fastest = max(one.rate for one in stretches)
        return Timing(rate=shortest_rate(fastest, tolerance=1e-6), uncertainty=1e-3,
                      problem=f"{CHANGES}: {named}")  # fmt: skip
    usual = 1 / _usual_rate(steps)
    long, short = steps > (1 + _JUMP) * usual, steps < (1 - _JUMP) * usual
    lost = int(np.sum(np.round(steps[long] / usual) - 1))
    parts = []
    if long.any():
        parts.append(f"{lost} sample{'s' * (lost > 1)} lost in {_counted(long, 'gap')}")
    if short.any():
        parts.append(f"{_counted(np.concatenate([[False], short]), 'time')} too close to the one before")
    mean = (times[-1] - times[0]) / (times.size - 1)
    step = int(np.argmax(np.abs(steps / usual - 1)))
    counts = f" ({'; '.join(parts)})" if parts else ""
    problem = (
        f"is not evenly spaced{counts}: it is up to {worst:.3g} samples off an even {1 / mean:.6g} Hz, and the "
        f"step after sample {step} is {steps[step]:.6g} s instead of {usual:.6g} s"
    )
    return Timing(rate=shortest_rate(1 / usual, tolerance=1e-6), uncertainty=1e-3, problem=problem)


def _usual_rate(steps: Floats) -> float:
    """Return the rate [Hz] of the steps that are one sample long; NaN where no time rises."""
    rising = steps[steps > 0]
    if rising.size == 0:
        return float("nan")
    middle = float(np.median(rising))
    return 1 / float(np.mean(rising[np.abs(rising - middle) < _JUMP * middle]))


def _counted(places: NDArray[np.bool_], what: str) -> str:
    found = np.flatnonzero(places)
    named = ", ".join(str(place) for place in found[:_NAMED]) + (", ..." if found.size > _NAMED else "")
    word = "after sample" if what == "gap" else "sample"
    return f"{found.size} {what}{'s' if found.size > 1 else ''} ({word} {named})"
