"""Dropouts with sharp edges: the reading jumps to a level within a sample, rests there, and jumps back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.mains_hum import without_hum
from torquerig.recordings.repair.moments import moments_of
from torquerig.recordings.repair.robust_spread import spread_about_median, spread_about_zero
from torquerig.recordings.repair.strong_tone import without_tone

Floats = NDArray[np.float64]
Gap = tuple[int, int, float]  # first sample, one past the last, level

_JUMP = 12.0
_AT_ONCE = 0.6  # of the way to the level and back that one sample takes; a torque takes several
_LEAST_SAMPLES = 8  # of a signal: of fewer nobody knows what is usual
_SHORTEST, _FEWEST = 8e-4, 3  # [s] half a period of what rings is shorter; samples of which two may stand still
_ONE_LEVEL = 6.0
_MANY_CODES = 4.0  # steps of the converter in the noise: so rarely does a signal repeat a value that 0.8 ms tell
_REPEATS = 20  # samples of one value, which noise of many codes repeats once in ten
_ONE_CODE = 1.5  # codes that most steps stay below: of one code the noise is but a part
_STANDS = 0.5  # share of the steps that are none where codes are coarse
_TO_ZERO = 2.5  # of such codes within a sample, to zero and back: three do, which would not elsewhere
_REPEATED = 0.2  # share of the steps that are none
_STILL = 0.5  # of the noise may be left where nothing is measured
_AT_ZERO = 1.0  # of the steps' sigma, by which noise that goes on keeps near zero: its middle, half of that
_FLAT, _OF_PLATEAUS = 0.25, 0.2  # of the smaller jump a plateau moves by; of all plateaus, those at the level are few
_TAIL = 2.1  # times what 99 of 100 samples without signal keep within: all of them
_QUIET = 0.5  # of the noise: what keeps within so much of a level for a millisecond holds no signal
_SWAYS = 0.05  # of the way to the level, by which a hum that the cable picks up may move it


@dataclass(frozen=True)
class Dropouts:
    """Moments at ``level`` [V]: their median ``duration`` [s], how many, and per second."""

    level: float
    duration: float
    count: int
    rate: float
    runs: tuple[str, ...]

    def sentence(self, name: str, unit: str) -> str:
        """Return in one sentence how often a channel drops to which level, and for how long."""
        times = f"{self.count} time{'s' * (self.count != 1)}"
        return (
            f"{name} drops to {self.level:.4g} {unit} and comes back {times}, for {1e3 * self.duration:.3g} ms in the "
            "median"
        )


def dropouts(recordings: Sequence[Recording]) -> Dropouts | None:
    """Return the moments in which the signal stands still at a level of its own, away from its neighbourhood."""
    return dropouts_of([(each, gaps(each.torque_values(), each.sample_rate)) for each in recordings])


def dropouts_of(found: Sequence[tuple[Recording, Sequence[Gap]]]) -> Dropouts | None:
    """Return the same of the gaps of each recording, None where there are none."""
    events: list[tuple[str, float, float]] = []
    length = 0.0
    for recording, own in found:
        length += recording.duration
        events += [(recording.name, level, (stop - start) / recording.sample_rate) for start, stop, level in own]
    if not events:
        return None
    levels, durations = np.array([event[1] for event in events]), np.array([event[2] for event in events])
    runs = tuple(dict.fromkeys(event[0] for event in events))
    return Dropouts(float(np.median(levels)), float(np.median(durations)), len(events), len(events) / length, runs)


def gaps(volts: Floats, rate: float) -> list[Gap]:
    """Return (first, one past last, level) of every moment in which the signal jumps to a level and back.

    A strong alias goes on while the signal is lost, and makes jumps of its own; so does a hum, and moves the level:
    what is left without them is asked too, and believed where it shows more. Where the signal passes near the level, it
    jumps there or back by little.
    """
    found, without = _gaps(volts, rate), without_tone(volts, rate)
    if without is not None:
        volts, found = without, max(found, _gaps(without, rate), key=len)
    still = without_hum(volts, rate)
    unmoved = [] if still is None else _gaps(still, rate)
    if still is not None and len(unmoved) > len(found):
        return _with_quiet_ones(still, unmoved, rate)
    return _with_quiet_ones(volts, found, rate)


def _with_quiet_ones(volts: Floats, found: list[Gap], rate: float) -> list[Gap]:
    """Return the moments found and others at their level, as quiet and half as long, that no jump leads into.

    A converter's own noise, or what is left of a tone, keeps values from repeating exactly, but the signal's noise does
    not keep so near to a level so long.
    """
    if not found:
        return []
    level = float(np.median([each[2] for each in found]))
    inside = np.concatenate([np.abs(volts[start + 1 : stop - 1] - level) for start, stop, _ in found])
    quiet = _TAIL * float(np.quantile(inside, 0.99))
    if quiet > _QUIET * _noise_of(np.diff(volts))[0]:
        return found
    half = 0.5 * float(np.median([stop - start for start, stop, _ in found]))
    still = moments_of(np.abs(volts - level) < quiet)
    for start, stop in still:
        if stop - start >= max(half, _shortest(rate)):
            pieces = [(start, stop, level), *(each for each in found if _meet(each, (start, stop, level)))]
            whole = (min(first for first, _, _ in pieces), max(last for _, last, _ in pieces), level)
            found = [*(each for each in found if each not in pieces), whole]
    return sorted(found)


def _gaps(volts: Floats, rate: float) -> list[Gap]:
    """Return the moments of a signal that no strong tone hides.

    Both jumps are larger than noise and shafts can make within a sample (12 robust sigma of the sample-to-sample
    steps) and make most of the way, the moment lasts 0.8 to 200 ms, and within it the signal stands still: it keeps to
    its level, and at least half of the noise is gone, or the level is zero. Where the noise is gone a hum may still
    move it a little. A signal that goes on at another level is not lost. Where such moments are found, others at the
    same level count that begin and end without a jump. Where noise covers many codes, a signal that repeats one value
    twenty times and more needs no jump at all. One that goes from plateau to plateau, few of them at that level, is
    held or pulsed over and over, and not lost.
    """
    if volts.size < _LEAST_SAMPLES:
        return []
    steps = np.diff(volts)
    sigma, code = _noise_of(steps)
    fine = sigma > _MANY_CODES * code
    coarse = sigma < _ONE_CODE * code and np.mean(steps == 0) > _STANDS
    jumps = np.flatnonzero(np.abs(steps) > (_TO_ZERO if coarse else _JUMP) * sigma) + 1
    found, bends = list[Gap](), float(np.median(np.abs(np.diff(steps))))
    last, within, plateaus = 0, _ONE_LEVEL * sigma, 0
    for start, stop in zip(jumps[:-1].tolist(), jumps[1:].tolist(), strict=True):
        if start < last or not _shortest(rate) <= stop - start <= 0.2 * rate:
            continue
        inside, level = volts[start:stop], float(np.median(volts[start:stop]))
        outside = 0.5 * (volts[max(start - 2, 0)] + volts[min(stop + 1, volts.size - 1)])
        way = (level - outside) or np.inf
        jumped = min(volts[start] - volts[start - 1], volts[stop - 1] - volts[stop], key=lambda step: step / way) / way
        least = (_TO_ZERO if coarse and abs(level) < 0.5 * code else _JUMP) * sigma
        away = abs(level - outside) > least and jumped > _AT_ONCE
        plateaus += bool(np.ptp(inside) < _FLAT * np.abs(steps[[start - 1, stop - 1]]).min())
        moved = spread_about_zero(np.diff(inside))
        bent = float(np.median(np.abs(np.diff(inside, n=2))))  # a hum moves on evenly
        sway = float(np.median(np.abs(inside - level)))
        still = (sway < 3 * sigma and moved < _STILL * sigma) or (sway < _AT_ZERO * sigma and abs(level) < sigma)
        sways = sway < _SWAYS * abs(level - outside) and bent < _STILL * bends
        if away and (still or sways) and np.ptp(inside) < abs(level - outside):
            found.append((start, stop, level))
            last, within = stop, within if still else max(within, _SWAYS * abs(level - outside))
    if not found and fine:
        low, high = float(volts.min()), float(volts.max())
        still_long = _standing(volts, max(_REPEATS, _shortest(rate)))
        found = [each for each in still_long if low < each[2] < high]  # at its limit a signal is not lost
    if len(found) < _OF_PLATEAUS * plateaus or not _at_one_level([level for _, _, level in found], within=within):
        return []
    if fine:
        level = float(np.median([each[2] for each in found]))
        nearest = float(volts[np.argmin(np.abs(volts - level))])
        others = [each for each in _standing(volts, _shortest(rate)) if each[2] == nearest]
        found += [each for each in others if not any(_meet(each, other) for other in found)]
    return sorted(found)


def _shortest(rate: float) -> float:
    """Return the samples that a moment without signal lasts at least."""
    return max(_FEWEST, _SHORTEST * rate)


def _noise_of(steps: Floats) -> tuple[float, float]:
    """Return the robust sigma of the steps from sample to sample, and the smallest of them.

    A signal that stands at a limit, or on coarse codes, repeats values: then those that move tell.
    """
    size = np.abs(steps)
    moving = size[size > 0]
    if moving.size == 0:
        return np.inf, np.inf
    code, middle = float(moving.min()), float(np.median(moving))
    if moving.size > (1 - _REPEATED) * size.size:
        return spread_about_median(steps), code
    return (middle if middle < _ONE_CODE * code else spread_about_zero(moving)), code


def _standing(volts: Floats, samples: float) -> list[Gap]:
    """Return (first, one past last, level) of the moments in which at least so many samples are the same."""
    edges = np.flatnonzero(np.concatenate([[True], np.diff(volts) != 0, [True]]))
    long = np.flatnonzero(np.diff(edges) >= samples)
    return [(int(edges[at]), int(edges[at + 1]), float(volts[edges[at]])) for at in long]


def _meet(one: tuple[int, int, float], other: tuple[int, int, float]) -> bool:
    return one[0] < other[1] and other[0] < one[1]


def _at_one_level(levels: Sequence[float], *, within: float) -> bool:
    """Whether most moments, of some, stand at one level: impacts that ring end where they happen to."""
    if not levels:
        return False
    return bool(np.mean(np.abs(np.array(levels) - np.median(levels)) < within) > 0.7)


def moments_lost(recording: Recording) -> list[tuple[int, int]]:
    """Return the first sample and one past the last of every moment without signal."""
    return [(start, stop) for start, stop, _ in gaps(recording.torque_values(), recording.sample_rate)]
