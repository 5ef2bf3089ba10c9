"""Whether a line of fixed frequency sounds all along, as electronics do, or comes and goes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import SHIFTED, Peak
from torquerig.inference.places import Place, order
from torquerig.recordings.spectrum import between_bins

Floats = NDArray[np.float64]

_LINE = 3  # bins either way that hold a steady line under a Hann window
_BESIDE, _FLOOR = 12.0, 60.0  # [Hz] either way: where bursts of some hundredths of a second spread to, and the floor
_FEW = 50  # bins that tell no floor
_CLEAR = 4.0  # standard deviations by which what is beside the line must exceed the floor
_ONCE_A_TURN = 1.01  # orders of the motor: its own turn, and those of slower shafts
_STEADY = 0.75  # share of its power that a steady tone keeps in one line


def sounds_all_along(peak: Peak, runs: Sequence[Observed], known: Sequence[Place]) -> bool:
    """Whether the line keeps nearly all its power in one line, in the run that shows it best.

    Of a tone of amplitude A that sounds for a share d of the time, ``d A^2`` is its power and ``d^2 A^2`` that of its
    line; the rest is spread beside it. A tone whose frequency jumps or sweeps loses its line likewise. What stands
    beside the lines at ``known``, side lines once a turn of a shaft among it, is theirs. A run whose time base is
    broken spreads every tone, and tells nothing of it.
    """
    shown = [run for run in runs if run.steady and run.name in peak.runs and not run.broken]
    shares = [_share_in_line(run, peak.place.at, known) for run in shown]
    return not shares or max(shares) > _STEADY


def steady_frequency(run: Observed, at: float) -> float:
    """Return the frequency [Hz] of the tallest line of a run near ``at``, between the bins by its two largest.

    Near means within what an unmeasured angle shifts a line, or three bins.
    """
    power, step = spectrum_of_seen(run)
    reach = max(_LINE, round(SHIFTED * run.smearing * at / step))
    low, high = max(round(at / step) - reach, 1), min(round(at / step) + reach, power.size - 2)
    return step * between_bins(power, low + int(np.argmax(power[low : high + 1])))


def spectrum_of_seen(run: Observed) -> tuple[Floats, float]:
    """Return the power of what fits may see of a run under a Hann window, and the step of its frequencies [Hz]."""
    torque = run.torque[run.seen]
    power = np.abs(np.fft.rfft((torque - torque.mean()) * np.hanning(torque.size))) ** 2
    return power, run.rate / torque.size


def _share_in_line(run: Observed, at: float, known: Sequence[Place]) -> float:
    power, step = spectrum_of_seen(run)
    first = max(int((at - _FLOOR) / step), 0)  # what stands further off is not asked
    power = power[first : int((at + _FLOOR) / step) + 2]
    frequency = step * (first + np.arange(power.size))
    far = np.abs(frequency - at)
    free = far > _LINE * step
    for place in (*known, *_side_lines(known)):
        line = place.frequency(run.mean_speed)
        if abs(line - at) > _LINE * step:
            free &= np.abs(frequency - line) > max(_LINE * step, run.smearing * line)
    beside, floor = free & (far < _BESIDE), _floor_at(at, frequency[free], power[free])
    line_power = float(np.maximum(power[far <= _LINE * step] - floor, 0.0).sum())
    spread = float((power[beside] - floor).sum())
    return line_power / (line_power + (spread if spread > _CLEAR * floor * np.sqrt(beside.sum()) else 0.0) + 1e-30)


def _side_lines(known: Sequence[Place]) -> list[Place]:
    """Return where lines stand once a turn of a shaft beside those of other orders, which no runout leaves even."""
    orders = [place.at for place in known if place.domain == "order"]
    turns = [at for at in orders if at < _ONCE_A_TURN]
    return [order(at) for one in orders for turn in turns for at in (one - turn, one + turn) if at > 0]


def _floor_at(at: float, frequency: Floats, power: Floats) -> float:
    """Return the floor at a frequency [Hz], between those on either side: a load's own falls with frequency."""
    far = np.abs(frequency - at)
    near, beyond = far < _FLOOR, (far < _FLOOR) & (far >= _BESIDE)
    sides = [power[beyond & (frequency < at)], power[beyond & (frequency > at)]]
    if min(side.size for side in sides) < _FEW:
        return _floor(power[near])
    return float(np.sqrt(_floor(sides[0]) * _floor(sides[1])))


def _floor(power: Floats) -> float:
    """Return the mean that the lower quartile of an exponential stands for: bursts raise the median."""
    return float(np.quantile(power, 0.25)) / float(np.log(4 / 3)) if power.size else 0.0
