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

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block
from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.twin import LineSource, Passage

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
    spread = _spread_of(seen)
    steep = np.square(steepness * spread) > (_STEEP if run.is_steady else _STEEP_IN_A_SWEEP)
    if not steep.any():
        return None
    kept, about = np.ones(gain.shape), np.zeros((*gain.shape, seen.bands.low.size))
    first = {id(lines[row].transfer): lines[row].transfer for row in np.flatnonzero(steep.any(axis=1)).tolist()}
    for each, passage in first.items():
        rows = [row for row in np.flatnonzero(steep.any(axis=1)).tolist() if id(lines[row].transfer) == each]
        pairs = [(lines[row].order, int(segment)) for row in rows for segment in np.flatnonzero(steep[row])]
        content, responses = _content(passage), cache(partial(_responses, seen, passage, tuple(dict.fromkeys(pairs))))
        for row in rows:
            for segment in np.flatnonzero(steep[row]).tolist():
                order, size = lines[row].order, float(gain[row, segment])
                make = partial(_line_behind, seen, order, segment, size, responses)
                name = f"behind, segment {segment}, order {order:.9g}"
                kept[row, segment], about[row, segment] = seen.kept.get(name, (order, size, content), make)
    return SwayedLines(kept, about)


def _content(passage: Passage) -> tuple[Hashable, ...]:
    """Return all that a transfer depends on, equal for equal ones of different twins."""
    answer = None if passage.answer is None else passage.answer.tobytes()
    twin = passage.twin
    return twin.shafts.frequency.tobytes(), passage.response.tobytes(), answer, passage.slower, twin.cutoff, twin.scale


def _responses(
    seen: RunFeatures, passage: Passage, pairs: Sequence[tuple[float, int]]
) -> dict[tuple[float, int], Complex]:  # fmt: skip
    """Return the transfer at the components of the waves of each order in each segment, in the order of the waves."""
    at = [np.concatenate([np.zeros(0), *(each.frequency.ravel() for each in _waves_of(seen, *one))]) for one in pairs]
    found = np.split(passage(np.concatenate(at)), np.cumsum([each.size for each in at])[:-1])
    return dict(zip(pairs, found, strict=True))


def _line_behind(
    seen: RunFeatures, order: float, segment: int, gain: float,
    responses: Callable[[], dict[tuple[float, int], Complex]],
) -> tuple[float, Floats]:  # fmt: skip
    """Return the relative power of a line in a segment, and the density in each band relative to it."""
    waves = _waves_of(seen, order, segment)
    if not waves:
        return 1.0, np.zeros(seen.bands.low.size)
    return _behind(waves, responses()[order, segment] / gain, seen, segment)


@dataclass(frozen=True, eq=False)
class _Wave:
    """A source that turns with the measured angle in blocks of one length and their margins, about its mean frequency.

    Its transform ``spectrum`` has the components ``frequency`` [Hz], shape (blocks, samples). Of the blocks themselves,
    ``inside``, are the wave ``source``, the ``window`` of the lines and of the bands, and the band of each component,
    ``bands.size`` where it is in none. Of all bands of the blocks ``width`` is left [Hz], shape (bands,).
    """

    spectrum: Complex
    frequency: Floats
    inside: slice
    source: Complex
    window: Floats
    band: NDArray[np.intp]
    width: Floats


def _spread_of(seen: RunFeatures) -> Floats:
    return seen.kept.get("spread", None, lambda: _spread(seen))


def _spread(seen: RunFeatures) -> Floats:
    """Return the relative standard deviation of the speed in each segment [1]."""
    answer = []
    for segment in seen.segments:
        speed = np.concatenate([seen.run.speed[block.samples] for block in segment.blocks])
        answer.append(float(speed.std() / max(abs(float(speed.mean())), 1e-12)))
    return np.array(answer)


def _waves_of(seen: RunFeatures, order: float, segment: int) -> tuple[_Wave, ...]:
    name = f"waves of segment {segment}, order {order:.9g}"
    return seen.kept.get(name, order, lambda: _waves(seen, order, segment, float(_spread_of(seen)[segment])))


def _waves(seen: RunFeatures, order: float, segment: int, spread: float) -> tuple[_Wave, ...]:
    """Return the source of an order in the blocks of a segment; none where its components reach to standstill."""
    middle, duration = order * abs(float(seen.speed[segment])) / (2 * pi), float(seen.durations[segment])
    reach = _REACH * spread * middle + 2 / duration
    every = int(seen.run.rate / (2 * reach))
    if every < 1 or middle <= reach:
        return ()
    nearest = int(np.argmin(np.abs(seen.line_frequency[segment] - middle)))
    leakage = float(seen.line_excluded[segment, nearest])
    blocks = seen.segments[segment].blocks
    made = (_wave(seen, block, order, middle=middle, every=every, leakage=leakage) for block in blocks)
    alike = dict[tuple[object, ...], list[_Wave]]()
    for wave in (each for each in made if each is not None):
        alike.setdefault((wave.frequency.shape, wave.inside.start, wave.inside.stop), []).append(wave)
    return tuple(map(_together, alike.values()))


def _together(waves: Sequence[_Wave]) -> _Wave:
    def joined(name: str) -> Any:
        return np.concatenate([getattr(each, name) for each in waves])

    return replace(
        waves[0], spectrum=joined("spectrum"), frequency=joined("frequency"), source=joined("source"),
        band=joined("band"), width=np.sum([each.width for each in waves], axis=0),
    )  # fmt: skip


def _wave(
    seen: RunFeatures, block: Block, order: float, *, middle: float, every: int, leakage: float
) -> _Wave | None:  # fmt: skip
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
    without = float(speed.min()) - leakage, float(speed.max()) + leakage  # these bins the bands leave out
    source, edges = wave[inside], np.append(seen.bands.low, seen.bands.high[-1:])
    at = middle + np.fft.fftfreq(source.size, 1 / rate)
    band = np.searchsorted(edges, at, side="right") - 1
    band[(band < 0) | ((at >= without[0]) & (at <= without[1]))] = seen.bands.low.size
    return _Wave(
        np.fft.fft(wave)[None], np.asarray(middle + np.fft.fftfreq(count, 1 / rate))[None], inside, source[None],
        np.hanning(source.size + 2)[1:-1], band[None], np.diff(edges) - np.diff(np.clip(edges, *without)),
    )  # fmt: skip


def _behind(
    waves: Sequence[_Wave], response: Complex, seen: RunFeatures, segment: int
) -> tuple[float, Floats]:  # fmt: skip
    """Return the relative power of the line, and the density in each band relative to it, behind a response."""
    count, kept, first = seen.bands.low.size, 0.0, 0
    summed, width = np.zeros(count), np.zeros(count)
    for each in waves:
        own = response[first : first + each.frequency.size].reshape(each.frequency.shape)
        first += each.frequency.size
        out = np.fft.ifft(each.spectrum * own)[:, each.inside]
        mean = (each.source.conj() * out) @ each.window / each.window.sum()
        rest = np.fft.fft(each.window * (out - mean[:, None] * each.source))
        power = (np.square(rest.real) + np.square(rest.imag)) / (each.window.size * float(each.window @ each.window))
        summed += np.bincount(each.band.ravel(), power.ravel(), minlength=count + 1)[:count]
        width += each.width
        kept += float(np.square(np.abs(mean)).sum())
    blocks = sum(len(each.frequency) for each in waves)
    bins = blocks / float(seen.durations[segment])  # less than a bin in each block shows nothing
    density = np.where(width > bins, summed / np.maximum(width, bins), 0.0)
    return kept / blocks, density / max(kept / blocks, 1e-12)
