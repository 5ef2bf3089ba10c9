"""Power over noise in each group of blocks of a run, along orders and along frequencies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block
from torquerig.inference.features.line_powers import line_powers
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import Place

Floats = NDArray[np.float64]
Density = Callable[[Floats], Floats]

_NEIGHBOURS = 100  # bins either way whose median is the noise of a bin
_INDEPENDENT = (2 * _NEIGHBOURS + 1) / 1.5 / 2.08  # of a mean as precise: a Hann window is 1.5 bins wide, the median of
# exponential variates has 2.08 times the variance of their mean
FEWEST_TURNS = 4  # of the motor in a group of blocks whose orders are searched
NEAR = 3.0  # [bins] a weaker line so near to a stronger one is its skirt
_LOG_MEDIAN = float(np.log(2.0))  # median over mean of an exponential variate


@dataclass(frozen=True)
class NoiseRatios:
    """Power over the noise of one block along orders and along frequencies; what the known lines leave of it [N m].

    ``start`` is the index of its first sample in the run, ``blocks`` how many blocks of it are joined here.
    """

    run: MeasuredRun
    smearing: float
    speed: float
    speeds: tuple[float, float]
    by_order: Floats
    order_step: float
    by_frequency: Floats
    frequency_step: float
    start: int
    rest: Floats
    blocks: int = 1


def noise_ratios(run: MeasuredRun, places: Sequence[Place], density: Density) -> list[NoiseRatios]:
    """Return the power over noise of what the lines at ``places`` leave in the fitted blocks of a run.

    ``density`` is what a model expects without its lines [(N m)^2/Hz] by frequency [Hz].
    """
    answer = []
    for blocks in _neighbours(run):
        part = slice(blocks[0].start, blocks[-1].stop)
        rest = np.concatenate([_level_removed(line_powers(run, block.samples, places).residual) for block in blocks])
        angle = run.angle[part]
        turned, step = float(angle[-1] - angle[0]), run.rate / rest.size
        turning_at = np.abs(run.speed[part])
        direct = _over_noise(rest, run.rate, density)
        turning, order_step = np.zeros(0), 1.0
        if abs(turned) > 2 * pi * FEWEST_TURNS and np.abs(np.diff(np.sign(run.speed[part]))).max(initial=0) == 0:
            even = np.linspace(0.0, abs(turned), rest.size)
            by_angle = np.interp(even, np.maximum.accumulate(np.sign(turned) * (angle - angle[0])), rest)
            turning, order_step = _over_noise(by_angle, run.rate, density), 2 * pi / abs(turned) * (1 - 1 / rest.size)
        speeds = float(turning_at.min()), float(turning_at.max())
        each = NoiseRatios(
            run, run.smearing(part), float(turning_at.mean()), speeds, by_order=turning, order_step=order_step,
            by_frequency=direct, frequency_step=step, start=part.start, rest=rest, blocks=len(blocks),
        )  # fmt: skip
        _ignore(each, places, reach=NEAR * rest.size / min(block.stop - block.start for block in blocks))
        answer.append(each)
    return answer


def _level_removed(rest: Floats) -> Floats:
    """Return a residual without its mean and slope, so that blocks join without a step."""
    time = np.linspace(-1.0, 1.0, rest.size)
    return np.asarray(rest - rest.mean() - float(rest @ time) / float(time @ time) * time)


def _neighbours(run: MeasuredRun) -> list[list[Block]]:
    """Return the fitted blocks; of a run at one speed those that follow each other together, for a finer resolution."""
    answer: list[list[Block]] = []
    for block in run.blocks:
        if not block.held_out and run.is_steady and answer and answer[-1][-1].stop == block.start:
            answer[-1].append(block)
        elif not block.held_out:
            answer.append([block])
    return answer


def _ignore(each: NoiseRatios, places: Sequence[Place], *, reach: float) -> None:
    """Leave out the bins where known lines are, in both domains.

    A regression leaves something within ``reach`` bins, and of a line that sweeps over a range somewhere in it.
    """
    slow, fast = (speed / (2 * pi) for speed in each.speeds)
    for place in places:
        turning = place.domain == "order"
        orders = (place.at, place.at) if turning else (place.at / max(fast, 1e-9), place.at / max(slow, 1e-9))
        tones = (place.at * slow, place.at * fast) if turning else (place.at, place.at)
        for ratio, step, (low, high) in (
            (each.by_order, each.order_step, orders), (each.by_frequency, each.frequency_step, tones)
        ):  # fmt: skip
            wide = reach + each.smearing * high / step
            _left_out(ratio, low / step - wide, high / step + wide)


def _left_out(ratio: Floats, low: float, high: float) -> None:
    ratio[max(int(np.ceil(min(low, ratio.size))), 0) : max(int(np.floor(min(high, ratio.size))) + 1, 0)] = np.nan


def _over_noise(values: Floats, rate: float, density: Density) -> Floats:
    """Return the power of each bin over that of noise, as an exponential variate; along an angle at the mean speed."""
    power = spectrum(values, rate)
    ratio = over_floor(power, density(np.arange(power.size) * rate / values.size))
    return np.zeros(0) if ratio is None else as_exponential(ratio)


def spectrum(values: Floats, rate: float, *, finer: int = 1) -> Floats:
    """Return the one-sided periodogram under a Hann window [unit^2/Hz], with ``finer`` points per bin."""
    window = np.hanning(values.size)
    bins = np.fft.rfft(values * window, finer * values.size)
    return np.asarray(2 * np.abs(bins) ** 2 / ((window**2).sum() * rate))


def over_floor(power: Floats, expected: Floats) -> Floats | None:
    """Return a spectrum over its noise [1]: the median of the neighbours or ``expected``, whichever is larger.

    None where there are too few neighbours.
    """
    from scipy.ndimage import median_filter

    if power.size < 2 * _NEIGHBOURS:
        return None
    floor = median_filter(power, size=2 * _NEIGHBOURS + 1, mode="reflect") / _LOG_MEDIAN
    return np.asarray(power / np.maximum(floor, expected))


def as_exponential(ratio: Floats) -> Floats:
    """Return the exponential variate of the same p-value as a power over an estimated noise.

    The ratio of an exponential variate to the mean of m others exceeds x with the probability ``(1 + x / m)^-m`` (an F
    distribution).
    """
    return np.asarray(_INDEPENDENT * np.log1p(ratio / _INDEPENDENT))


def measured_ratio(values: Floats) -> Floats:
    """Return the power over the noise of bins whose exponential variates are ``values`` [1]."""
    return np.asarray(_INDEPENDENT * np.expm1(values / _INDEPENDENT))
