"""Lines in what a model leaves: periodic in the angle or position, or fixed in frequency; and whether by chance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.moved import BAND, Mask, Moved

Floats = NDArray[np.float64]

SIGNIFICANT = 1e-6  # chance that so strong a line stands anywhere among all that were looked at
_MOST = 12
_LEAST_PLACES = 48  # fewer make no floor
_NEIGHBOURS = 40  # places on either side that make the floor
_CLEAR = 3  # nearest places left out of the floor: a line's own skirt
_LOWEST = 6  # cycles that a line must have over the run; slower is not told from a slow course
_POINTS = 4000
_VISIBLE = 0.005  # by so much of itself a line lowers the residual's rms; a smaller one is not worth telling
_OWN = 1e-4  # of its strongest: where the motion itself has so much, what is left comes with its cadence
_FEWEST = 200  # samples in motion
_TIE = 1.1  # so much better a fixed frequency must be than the place that it stands for
_CELLS, _BY_HAND = 16, 100  # cells per shortest wave: its size is within 0.7 % then; fewer places are summed directly
_ROUND = 0.3  # of a full cycle's spread, which samples of one direction must have to tell a wave
_PER_PLACE = 2  # points looked at per resolved place


Pair = tuple[Floats, Moved, Mask]  # what is left of a run, the run, and which samples of it are looked at


@dataclass(frozen=True, kw_only=True)
class Line:
    """One line.

    Parameters
    ----------
    domain : {"order", "frequency"}
    at : float
        [1/rev] or [cycles/m], or [Hz].
    width : float
        What the runs resolve.
    amplitude : float
        Zero to peak, of the runs that show it [N m] or [N].
    excess_db : float
        Over the floor beside it.
    p_value : float
        That chance put so strong a line anywhere looked at.
    """

    domain: str
    at: float
    width: float
    amplitude: float
    excess_db: float
    p_value: float


def turn_of(runs: Sequence[Moved]) -> float:
    """Return the angle of one cycle per unit: 2 pi where the motion is in a line (cycles/m), 1 where it turns."""
    return 2 * np.pi if in_a_line(runs) else 1.0


def in_a_line(runs: Sequence[Moved]) -> bool:
    """Whether the runs move in a line."""
    return any(channel.quantity in ("position", "velocity") and runs[0].channel.quantity == "force"
               for channel in runs[0].recording.channels.values())  # fmt: skip


def lines_in(residuals: Sequence[Floats], runs: Sequence[Moved], *, held: bool = False) -> tuple[Line, ...]:
    """Return the significant lines of what a model leaves, strongest first.

    A line is taken out with its phase and size of each run and direction before the next is looked for. It counts as
    fixed in frequency only where that lowers the residual clearly more than the place does that it stands for: at one
    steady speed the two cannot be told apart.
    """
    return lines_and_rest(residuals, runs, held=held)[0]


def lines_and_rest(
    residuals: Sequence[Floats], runs: Sequence[Moved], *, held: bool = False
) -> tuple[tuple[Line, ...], list[Pair]]:
    """Return the significant lines, strongest first, and what is left without them where there is enough to look at."""
    masks = [(run.held if held else run.seen) & even(run) for run in runs]
    whole = zip(residuals, runs, masks, strict=True)
    pairs = [(each.copy(), run, mask) for each, run, mask in whole if mask.sum() > _FEWEST]
    found: list[Line] = []
    while pairs and len(found) < _MOST:
        worth = [line for line in _candidates(pairs) if not any(_same(line, one) for one in found)]
        without = [_without(pairs, line) for line in worth]
        left = [_rms(each) for each in without]
        falls = [(_rms(pairs) - one) * (_TIE if line.domain == "order" else 1.0)
                 for one, line in zip(left, worth, strict=True)]  # fmt: skip
        if not left or max(falls) < _VISIBLE * _rms(pairs):
            break
        best = int(np.argmax(falls))
        found.append(worth[best])
        pairs = without[best]
    return tuple(found), pairs


def amplitudes(pairs: Sequence[Pair], domain: str) -> tuple[Floats, Floats]:
    """Return places [1/rev], [cycles/m] or [Hz] and what stands there, zero to peak; empty where too few are resolved.

    What is ``amplitude`` of a line is this at its place, summed in power over runs and directions.
    """
    grid, scale, _ = _places(pairs, domain) if pairs else (np.zeros(0), 1.0, 0.0)
    if grid.size == 0:
        return grid, grid
    power, _ = _power(pairs, domain, grid * scale)
    return grid, 2 * np.sqrt(power / sum(int(mask.sum()) for *_, mask in pairs))


def _candidates(pairs: Sequence[Pair]) -> list[Line]:
    """Return the strongest line over places and over time, where not by chance, and the order of a frequency."""
    peaks = [line for line in (_strongest(pairs, domain) for domain in ("order", "frequency")) if line]
    peaks = [line for line in peaks if line.p_value < SIGNIFICANT]
    return [*peaks, *(_twin(pairs, line) for line in peaks if line.domain == "frequency")]


def _twin(pairs: Sequence[Pair], line: Line) -> Line:
    """Return the order that a frequency stands for at the runs' usual speed."""
    scale = turn_of([run for _, run, _ in pairs])
    usual = float(np.median(np.concatenate([np.abs(run.speed[mask]) for _, run, mask in pairs]))) * scale / (2 * np.pi)
    span = max(float(np.ptp(run.position[mask])) for _, run, mask in pairs) * scale / (2 * np.pi)
    at, width = line.at / usual, 1 / span
    near = np.linspace(at - 2 * width, at + 2 * width, 41)
    power, _ = _power(pairs, "order", near * scale)
    return replace(line, domain="order", at=float(near[int(np.argmax(power))]), width=width)


def _without(pairs: Sequence[Pair], line: Line) -> list[Pair]:
    return [(each - waves(run, line, each, mask), run, mask) for each, run, mask in pairs]


def moving(run: Moved) -> Mask:
    """Whether a sample is taken in motion, a twentieth of the usual speed or more."""
    return np.asarray(np.abs(run.speed) > 0.05 * float(np.sqrt(np.mean(run.speed**2))))


def even(run: Moved) -> Mask:
    """Whether a sample is taken at hardly changing speed; all in motion where a run has few of them."""
    gained = np.abs(np.gradient(run.speed))
    calm = moving(run) & (gained < 0.05 * float(gained.max()))
    return calm if calm.sum() > 0.2 * calm.size else moving(run)


def waves(run: Moved, line: Line, residual: Floats, mask: Mask) -> Floats:
    """Return the line as it stands in a residual, shape (samples,): fitted on ``mask``, by direction of motion."""
    phase = phase_of(run, line)
    made = np.zeros(residual.size)
    for way in (1.0, -1.0):
        going = run.speed * way > 0
        if (going & mask).sum() < 50 or _round(phase[going & mask]) < _ROUND:
            continue
        basis = np.column_stack([np.cos(phase), np.sin(phase), np.ones(phase.size)])
        held = np.linalg.lstsq(basis[going & mask], residual[going & mask], rcond=None)[0]
        made[going] = basis[going][:, :2] @ held[:2]
    return made


def _round(phase: Floats) -> float:
    """Return how well samples go round a cycle [1]: 1 all round, 0 where they stay at one phase.

    From few phases a wave of any size is told with its mean to match, and is none at the others.
    """
    wave = np.column_stack([np.cos(phase), np.sin(phase)])
    return float(np.sqrt(2) * np.linalg.svd(wave - wave.mean(axis=0), compute_uv=False)[-1] / np.sqrt(phase.size))


def phase_of(run: Moved, line: Line) -> Floats:
    """Return the phase of a line's wave at each sample [rad]."""
    if line.domain == "frequency":
        return np.asarray(2 * np.pi * line.at * run.recording.time())
    return np.asarray(turn_of([run]) * line.at * run.position)


def _rms(pairs: Sequence[Pair]) -> float:
    return root_mean_square([each[mask] for each, _, mask in pairs])


def _in_the_motion(pairs: Sequence[Pair], places: Floats) -> Mask:
    """Whether the speed itself swings at a frequency: what friction leaves there is no line."""
    own, _ = _power([(run.speed, run, np.ones_like(mask)) for _, run, mask in pairs], "frequency", places)
    return np.asarray(own > _OWN * own.max())


def _same(one: Line, other: Line) -> bool:
    return one.domain == other.domain and abs(one.at - other.at) < 0.5 * one.width


def _places(pairs: Sequence[Pair], domain: str) -> tuple[Floats, float, float]:
    """Return where lines are looked for, none where too few are resolved; the angle of a cycle; the step resolved."""
    scale = 2 * np.pi if domain == "frequency" else turn_of([run for _, run, _ in pairs])
    spans, tops = [], []
    for _, run, mask in pairs:
        fast = 1.0 if domain == "frequency" else float(np.median(np.abs(run.speed[mask])))
        spans.append(float(np.ptp(_axis(run, domain)[mask])) * scale / (2 * np.pi))
        tops.append(BAND * run.rate / (fast * scale / (2 * np.pi)))
    step = 1 / max(spans)
    first, last = _LOWEST * step, min(tops)
    count = min(round((last - first) / step * _PER_PLACE), _POINTS)
    return np.linspace(first, last, count) if count >= _LEAST_PLACES else np.zeros(0), scale, step


def _strongest(pairs: Sequence[Pair], domain: str) -> Line | None:
    grid, scale, step = _places(pairs, domain)
    count = grid.size
    if count == 0:
        return None
    power, terms = _power(pairs, domain, grid * scale)
    over = power / _floor(power, terms)
    if domain == "frequency":
        over[_in_the_motion(pairs, grid * scale)] = 0.0
    peak = int(np.argmax(over))
    ratio = float(over[peak])
    if ratio <= 1:  # nothing stands out, or the motion itself has every frequency
        return None
    # each run and direction gives the square of a complex normal number: the tail of their sum, Chernoff's bound
    chance = count / _PER_PLACE * np.exp(-terms * max(ratio - 1 - np.log(max(ratio, 1.0)), 0.0))
    near = np.linspace(grid[peak] - grid[1] + grid[0], grid[peak] + grid[1] - grid[0], 21)
    fine, _ = _power(pairs, domain, near * scale)
    size = np.sqrt(max(float(fine.max()) * (1 - 1 / ratio), 0.0) / sum(int(mask.sum()) for *_, mask in pairs))
    return Line(
        domain=domain, at=float(near[int(np.argmax(fine))]), width=step, amplitude=2 * float(size),
        excess_db=float(10 * np.log10(ratio)), p_value=float(min(1.0, chance)),
    )  # fmt: skip


def _axis(run: Moved, domain: str) -> Floats:
    return run.recording.time() if domain == "frequency" else run.position


def _power(pairs: Sequence[Pair], domain: str, places: Floats) -> tuple[Floats, int]:
    """Squared size of the residuals' part at each place, summed over runs and directions, and of how many those are."""
    total, terms = np.zeros(places.size), 0
    for residual, run, mask in pairs:
        for way in (1.0, -1.0):
            going = np.flatnonzero(mask & (run.speed * way > 0))
            if going.size < _FEWEST // 4:
                continue
            values, axis = residual[going] - residual[going].mean(), _axis(run, domain)[going]
            terms += 1
            total += np.abs(_transformed(values, axis, places)) ** 2 / going.size
    return total, max(terms, 1)


def _transformed(values: Floats, axis: Floats, places: Floats) -> NDArray[np.complex128]:
    """``sum values exp(-i place axis)`` at each place; many places from values gathered in fine cells."""
    if places.size < _BY_HAND:
        return np.asarray(np.exp(-1j * np.outer(places, axis)) @ values)
    cell = 2 * np.pi / (_CELLS * float(places.max()))
    index = np.rint((axis - axis.min()) / cell).astype(np.int64)
    length = 1 << int(np.ceil(np.log2(4 * max(2 * np.pi / (cell * float(places[1] - places[0])), index.max() + 1))))
    spectrum = np.fft.rfft(np.bincount(index, weights=values), length)
    nearest = np.rint(places * cell * length / (2 * np.pi)).astype(np.int64)
    return np.asarray(spectrum[nearest])


def _floor(power: Floats, terms: int) -> Floats:
    """Mean of chance at each place, from the median of its neighbours, a line's own skirt left out."""
    from scipy.ndimage import median_filter

    reach = min(_NEIGHBOURS * _PER_PLACE, power.size // 4)
    wide = np.ones(2 * reach + 1, dtype=bool)
    wide[reach - _CLEAR * _PER_PLACE : reach + _CLEAR * _PER_PLACE + 1] = False
    middle = np.log(2) if terms == 1 else (terms - 1 / 3) / terms  # median over mean of a sum of exponentials
    return np.asarray(median_filter(power, footprint=wide, mode="reflect")) / middle + 1e-300
