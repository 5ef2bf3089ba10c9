"""A line whose frequency wanders where the response of the rig is steep.

The measured angle follows the speed, and a regression on it takes a line out. Near a resonance that is narrower than
what the frequency wanders by, amplitude and phase of the response change within a block, and a part of the power stays.
About a mean frequency f, the source of order n turns as ``u = exp(i (n phi(t) - 2 pi f t))`` with the measured angle
phi. It passes the response H:

    o(t) = F^-1 [H(f + d) F[u](d)],    m = mean of o / u over the block,    r = o - m u

The line has the power ``mean |m|^2 / |H(f)|^2`` of what a constant speed makes; r stays in the bands about it. Right
for a linear rig and a measured angle, without the response to what was before the block and its margins (Oppenheim &
Willsky 1997, Signals and Systems, 4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block
from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.twin import LineSource, passed

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_STEEP, _STEEP_IN_A_SWEEP = 1e-4, 1e-2  # [1] of a line's power: where less leaves it, nothing is computed
_REACH = 6.0  # standard deviations of a line's frequency that its components reach from the mean
_MARGIN = 0.25  # of a block, before and after it


@dataclass(frozen=True, eq=False)
class SwayedLines:
    """What a wandering speed changes of the lines of a rig.

    Parameters
    ----------
    kept : ndarray, shape (lines, segments)
        Power at the place of the line, relative to that at a constant speed [1].
    about : ndarray, shape (lines, segments, bands)
        Density in each band, relative to the power at the place of the line [1/Hz].
    """

    kept: Floats
    about: Floats


def swayed_lines(
    seen: RunFeatures, lines: Sequence[LineSource], gain: Floats, steepness: Floats
) -> SwayedLines | None:  # fmt: skip
    """Return what the wander changes; None where the angle was not measured or no response is steep.

    Parameters
    ----------
    gain : ndarray, shape (lines, segments)
        Root mean square of the response over the speeds of a segment.
    steepness : ndarray, shape (lines, segments)
        Largest relative change of the response per relative change of the frequency [1].
    """
    run = seen.run
    if not (run.has_encoder and np.isinf(run.followed)):
        return None
    spread = seen.kept.get("spread", None, lambda: _spread(seen))
    steep = np.square(steepness * spread) > (_STEEP if run.is_steady else _STEEP_IN_A_SWEEP)
    if not steep.any():
        return None
    kept, about = np.ones(gain.shape), np.zeros((*gain.shape, seen.bands.low.size))
    for row, segment in zip(*np.nonzero(steep), strict=True):
        order = lines[row].order
        make = partial(_waves, seen, order, segment, float(spread[segment]))
        waves = seen.kept.get(f"waves of segment {segment}", order, make)
        if waves:
            at = np.concatenate([wave.frequency for wave in waves])
            response = passed([lines[row].transfer], at[None])[0] / gain[row, segment]
            kept[row, segment], about[row, segment] = _behind(waves, response, seen, segment)
    return SwayedLines(kept, about)


@dataclass(frozen=True, eq=False)
class _Wave:
    """A source that turns with the measured angle in a block and its margins, about its mean frequency ``middle`` [Hz].

    ``wave`` and its transform ``spectrum`` have the shape (samples,); the components are at ``frequency`` [Hz], samples
    follow at ``rate`` [Hz], and those of the block are ``inside``. Its frequency is between ``slowest`` and ``fastest``
    [Hz] there.
    """

    wave: Complex
    spectrum: Complex
    frequency: Floats
    middle: float
    rate: float
    inside: slice
    slowest: float
    fastest: float


def _spread(seen: RunFeatures) -> Floats:
    """Return the relative standard deviation of the speed in each segment [1]."""
    answer = []
    for segment in seen.segments:
        speed = np.concatenate([seen.run.speed[block.samples] for block in segment.blocks])
        answer.append(float(speed.std() / max(abs(float(speed.mean())), 1e-12)))
    return np.array(answer)


def _waves(seen: RunFeatures, order: float, segment: int, spread: float) -> tuple[_Wave, ...]:
    """Return the source of an order in each block of a segment; none where its components reach to standstill."""
    middle, duration = order * abs(float(seen.speed[segment])) / (2 * pi), float(seen.durations[segment])
    reach = _REACH * spread * middle + 2 / duration
    every = int(seen.run.rate / (2 * reach))
    if every < 1 or middle <= reach:
        return ()
    made = (_wave(seen, order, block, middle, every) for block in seen.segments[segment].blocks)
    return tuple(wave for wave in made if wave is not None)


def _wave(seen: RunFeatures, order: float, block: Block, middle: float, every: int) -> _Wave | None:
    run, margin = seen.run, int(_MARGIN * (block.stop - block.start))
    start = max(block.start - margin, 0)
    count = (min(block.stop + margin, run.angle.size) - start) // every
    inside = slice((block.start - start) // every, (block.stop - start) // every)
    if inside.stop - inside.start < 2:
        return None
    samples = slice(start, start + count * every)
    direction = 1.0 if run.angle[samples][-1] > run.angle[samples][0] else -1.0
    phase = direction * order * run.angle[samples] - 2 * pi * middle / run.rate * np.arange(count * every)
    wave: Complex = np.exp(1j * phase.reshape(count, every).mean(axis=1))
    rate = run.rate / every
    speed = order / (2 * pi) * np.abs(run.speed[block.samples])
    return _Wave(
        wave, np.fft.fft(wave), np.asarray(middle + np.fft.fftfreq(count, 1 / rate)), middle, rate, inside,
        slowest=float(speed.min()), fastest=float(speed.max()),
    )  # fmt: skip


def _behind(
    waves: Sequence[_Wave], response: Complex, seen: RunFeatures, segment: int
) -> tuple[float, Floats]:  # fmt: skip
    """Return the relative power of the line, and the density in each band relative to it, behind a response."""
    low, high = seen.bands.low, seen.bands.high
    edges, kept, first = np.append(low, high[-1:]), 0.0, 0
    summed, width = np.zeros(low.size), np.zeros(low.size)
    nearest = int(np.argmin(np.abs(seen.line_frequency[segment] - waves[0].middle)))
    leakage = float(seen.line_excluded[segment, nearest])
    for each in waves:
        own = response[first : first + each.frequency.size]
        first += each.frequency.size
        out = np.fft.ifft(each.spectrum * own)[each.inside]
        window = np.hanning(out.size + 2)[1:-1]  # that of the lines and of the bands
        mean = np.average(out * each.wave[each.inside].conj(), weights=window)
        rest = window * (out - mean * each.wave[each.inside])
        at = each.middle + np.fft.fftfreq(rest.size, 1 / each.rate)
        hole = np.clip(edges, each.slowest - leakage, each.fastest + leakage)  # these bins the bands leave out
        outside = (at < each.slowest - leakage) | (at > each.fastest + leakage)
        power = np.square(np.abs(np.fft.fft(rest))) / (rest.size * np.square(window).sum())
        summed += np.histogram(at[outside], edges, weights=power[outside])[0]
        width += np.diff(edges) - np.diff(hole)
        kept += float(abs(mean) ** 2)
    bins = len(waves) / float(seen.durations[segment])  # less than a bin in each block shows nothing
    density = np.where(width > bins, summed / np.maximum(width, bins), 0.0)
    return kept / len(waves), density / max(kept / len(waves), 1e-12)
