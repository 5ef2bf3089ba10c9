"""Impacts that ring: orders of a shaft at which the squared envelope of a band beats, in all runs together.

Squared envelope spectrum over the angle (Randall & Antoni 2011, MSSP 25(2)). Where nothing beats, each of its bins over
the median of its neighbours is an exponential variate, and the sum over harmonics and blocks a gamma variate.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import log, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block
from torquerig.inference.features.line_powers import line_powers
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.measured_run import MeasuredRun

Floats = NDArray[np.float64]

LEVEL = 1e-4  # p-value of the whole search below which a beat is real
_HIGHEST = 0.42  # of the sample rate: upper end of the bands that are searched
_OCTAVES, _BANDS = 0.5, 15  # width of a band, and how many: in those that are slower a block has too few bins to beat
_ORDERS = (1.8, 15.0)  # [1/rev] of the shaft: races and balls of bearings have 2 to 12 (Harris & Kotzalas)
_HARMONICS = 3
_OVERSAMPLED = 2  # points of the grid of orders for each bin
_MOST = 12.0  # [1] times the noise that one bin counts
_NEIGHBOURS = 50  # bins either way whose median is the noise of a bin
_LARGEST_PART = 9  # of a beat: a lower order whose other multiples beat too
_BEATS = 4.0  # [1] times the noise, in the mean of all pieces
_MAIN_LOBE = 2.0  # [bins] half the width of a line under a Hann window
_SIDES = 2  # orders of the shaft on either side of a multiple at which impacts beat too, as the load turns
_TURNS = 6.0  # of the shaft in a piece of a run at least
_SEARCHES = 2  # one in blocks, one in whole runs


@dataclass(frozen=True)
class Impact:
    """A band around ``frequency`` [Hz] that beats ``order`` times per turn of a shaft.

    ``log_p`` has the logarithm of the p-value of that beat in each searched band, by the middle of the band [Hz].
    ``step`` is a bin of the longest piece [1/rev]: orders that are nearer are one.
    """

    order: float
    frequency: float
    log_p: Mapping[float, float]
    step: float

    def log_p_near(self, frequency: float) -> float:
        """Return the logarithm of the p-value in the band that has a frequency [Hz]; 0 where none was searched."""
        nearest = min(self.log_p, key=lambda middle: abs(log(middle / frequency)))
        return self.log_p[nearest] if abs(log(nearest / frequency)) < 0.5 * _OCTAVES * log(2) else 0.0


@dataclass(frozen=True)
class _Beats:
    """Power over noise of squared envelopes, along orders of the motor: one row for each band."""

    ratios: tuple[Floats, ...]
    step: float
    turned: float


def search_impacts(seen: tuple[RunFeatures, ...], turns: float) -> Impact | None:
    """Return the clearest beat of a shaft that turns ``turns`` times per turn of the motor, or None.

    Searched are single blocks, in which an angle that was estimated hardly drifts, and all blocks of a run together,
    in which a slow shaft turns often enough. Those are held-out blocks too: beats are no feature that a model predicts.
    """
    return seen[0].kept.get("impacts", (seen[1:], turns), lambda: _search(seen, turns)) if seen else None


def _search(seen: Sequence[RunFeatures], turns: float) -> Impact | None:
    top = _HIGHEST * min((one.run.rate for one in seen), default=0.0)
    found = [
        _clearest([each for one in seen for each in _beats_of(one, top, joined) if each.turned * turns > _TURNS],
                  turns, _centres(top).tolist())
        for joined in (False, True)
    ]  # fmt: skip
    return min((each for each in found if each is not None), key=lambda one: min(one.log_p.values()), default=None)


def _clearest(beats: Sequence[_Beats], turns: float, middles: Sequence[float]) -> Impact | None:
    """Return the clearest beat in pieces of runs."""
    shown = [band for band in range(_BANDS) if any(each.ratios[band].size for each in beats)]
    if not shown:
        return None
    step = min(each.step for each in beats) / turns / _OVERSAMPLED
    orders = np.arange(*_ORDERS, step)
    scores = np.array([np.sum([_score(each, band, orders * turns) for each in beats], axis=0) for band in shown])
    row, at = divmod(int(np.argmax(scores)), orders.size)
    count, places = _HARMONICS * len(beats), log(_SEARCHES * orders.size / _OVERSAMPLED * len(shown))
    log_p = [min(_log_tail(count, score) + places, 0.0) for score in scores[:, at].tolist()]
    if log_p[row] > log(LEVEL):
        return None
    order = _fundamental(beats, shown[row], float(orders[at]), turns)
    if order < _ORDERS[0]:  # something that passes less than twice a turn
        return None
    loudest = max(shown, key=lambda one: sum(_size(each, one, float(orders[at]) * turns) for each in beats))
    log_p_by_band = {middles[one]: own for one, own in zip(shown, log_p, strict=True)}
    return Impact(order, middles[loudest], log_p_by_band, _OVERSAMPLED * step)


def _beats_of(seen: RunFeatures, top: float, joined: bool) -> tuple[_Beats, ...]:
    def made() -> tuple[_Beats, ...]:
        pieces = _joined(seen.run) if joined else [(each,) for each in _fitted_blocks(seen)]
        return tuple(_of_pieces(seen, top, pieces))

    return seen.kept.get("beats", (top, joined), made)


def _fitted_blocks(seen: RunFeatures) -> Iterator[Block]:
    for segment in seen.segments:
        yield from segment.blocks


def _joined(run: MeasuredRun) -> Iterator[tuple[Block, ...]]:
    """Yield the blocks of a run that follow each other without a pause and without a reversal."""
    piece = list[Block]()
    for block in run.blocks:
        ways = [float(np.sign(run.speed[each.samples].mean())) for each in (*piece[-1:], block)]
        if piece and (piece[-1].stop != block.start or ways[0] != ways[1]):
            yield tuple(piece)
            piece = []
        piece.append(block)
    if piece:
        yield tuple(piece)


def _of_pieces(seen: RunFeatures, top: float, pieces: Iterable[Sequence[Block]]) -> Iterator[_Beats]:
    run = seen.run
    for blocks in pieces:
        angle = np.abs(run.angle[blocks[0].start : blocks[-1].stop] - run.angle[blocks[0].start])
        rest = [line_powers(run, block.samples, seen.places).residual for block in blocks]
        residual = np.concatenate([each - each.mean() for each in rest])
        turned = float(angle[-1]) / (2 * pi)
        spectrum = np.fft.rfft(residual)
        envelopes = (_envelope(spectrum, residual.size, run.rate, centre) for centre in _centres(top).tolist())
        ratios = [_over_noise(_evened(each, len(blocks)), angle) for each in envelopes]
        yield _Beats(tuple(ratios), 1 / max(turned, 1e-9), turned)


def _centres(top: float) -> Floats:
    """Return the middles of the bands below ``top`` [Hz], the slowest first."""
    return np.asarray(top * 2 ** (_OCTAVES * (np.arange(-_BANDS, 0) + 0.5)))


def _envelope(spectrum: NDArray[np.complex128], size: int, rate: float, centre: float) -> Floats:
    """Return the squared envelope of a band, sampled as often as its width permits."""
    low, high = (round(centre * 2 ** (way * 0.5 * _OCTAVES) * size / rate) for way in (-1, 1))
    inside = spectrum[low:high]
    if not inside.size:
        return np.zeros(0)
    padded = np.zeros(2 * inside.size, dtype=complex)  # a squared envelope is twice as wide
    padded[: inside.size] = inside
    return np.asarray(np.abs(np.fft.ifft(padded)) ** 2)


def _evened(envelope: Floats, parts: int) -> Floats:
    """Return an envelope over its mean in each of so many parts: what grows with the speed is no beat."""
    return np.concatenate([each / max(float(each.mean()), 1e-300) if each.size else each
                           for each in np.array_split(envelope, parts)])  # fmt: skip


def _over_noise(envelope: Floats, angle: Floats) -> Floats:
    """Return the power of each order of the motor over that of its neighbours."""
    from scipy.ndimage import median_filter

    if envelope.size < 4 * _NEIGHBOURS or angle[-1] <= 0:
        return np.zeros(0)
    at = angle[np.linspace(0, angle.size - 1, envelope.size).astype(int)]
    even = np.linspace(0.0, float(angle[-1]), envelope.size)
    by_angle = np.interp(even, np.maximum.accumulate(at), envelope)
    power = np.abs(np.fft.rfft((by_angle - by_angle.mean()) * np.hanning(by_angle.size))) ** 2
    floor = median_filter(power, size=2 * _NEIGHBOURS + 1, mode="nearest") / log(2)
    return np.asarray(power / np.maximum(floor, 1e-300))


def _score(beats: _Beats, band: int, orders: Floats) -> Floats:
    """Return the power over noise summed over the first harmonics of orders of the motor; 1 each where unknown."""
    return np.asarray(sum(_at(beats, band, harmonic * orders) for harmonic in range(1, _HARMONICS + 1)))


def _at(beats: _Beats, band: int, orders: Floats) -> Floats:
    ratio = np.minimum(beats.ratios[band], _MOST)
    row = np.round(orders / beats.step).astype(int)
    inside = row < ratio.size
    return np.where(inside, ratio[np.where(inside, row, 0)] if ratio.size else 1.0, 1.0)


def _size(beats: _Beats, band: int, order: float) -> float:
    """Return the logarithm of the power over noise summed over the first harmonics of an order of the motor."""
    row = np.round(np.arange(1, _HARMONICS + 1) * order / beats.step).astype(int)
    return float(np.log1p(beats.ratios[band][row[row < beats.ratios[band].size]]).sum())


def _fundamental(beats: Sequence[_Beats], band: int, order: float, turns: float) -> float:
    """Return the lowest order of which ``order`` is a multiple and whose other multiples beat too.

    Impacts whose strength changes with the turns of the shaft beat at whole orders, and so far from each multiple, as
    well: what is not apart from those says nothing.
    """
    width = _MAIN_LOBE * max(each.step for each in beats) / turns
    known = np.add.outer(order * np.arange(3), np.arange(-_SIDES, _SIDES + 1)).ravel()
    for part in range(_LARGEST_PART, 1, -1):
        others = np.array([each for each in range(1, 2 * part) if each % part]) * order / part
        others = others[np.abs(others[:, None] - known).min(axis=1) > width]
        shown = np.mean([_at(each, band, others * turns) for each in beats], axis=0)
        if shown.size and np.median(shown) > _BEATS:
            return order / part
    return order


def _log_tail(shape: int, value: float) -> float:
    """Return the logarithm of the probability that a gamma variate exceeds a value."""
    from scipy.special import gammaincc, gammaln

    tail = float(gammaincc(shape, value))
    return log(tail) if tail > 1e-290 else (shape - 1) * log(value) - value - float(gammaln(shape))
