"""Power of the lines of one block: by regression on the angle, or summed over the width of a smeared line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.hann_window import hann_window
from torquerig.inference.features.line_places import RESOLVED, line_frequencies, shown_places, smeared_width
from torquerig.inference.features.regression import HANN_NOISE, regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import Place
from torquerig.recordings.repair.moments import moments_of

Floats = NDArray[np.float64]

_LOST = 0.1  # [1] an order that is smeared over more of its frequency is no line
_LEFT = 1e-3  # [1] of the power of a line that a regression on a measured angle leaves next to it
_FAR = 12  # [bins] either way: where the noise of a line is taken, and as far as its leakage is looked for
_MEDIAN_OF_EXPONENTIAL = float(np.log(2.0))


@dataclass(frozen=True)
class LinePowers:
    """Lines of one block.

    Parameters
    ----------
    power : ndarray, shape (places,)
        Square of the amplitude (zero to peak), noise included [(N m)^2]; NaN where the block does not show the line.
    noise_bandwidth : ndarray, shape (places,)
        The noise adds so many times its density [Hz] to ``power``.
    half_width : ndarray, shape (places,)
        Within so much of its frequency [Hz] everything was taken as the line.
    leakage : ndarray, shape (places,)
        Within so much of its frequency [Hz] the spectrum next to the line holds what is left of it.
    residual : ndarray, shape (samples,)
        Torque without the lines [N m]; level and slope are still in it.
    """

    power: Floats
    noise_bandwidth: Floats
    half_width: Floats
    leakage: Floats
    residual: Floats


def apart_by_lines(group: Sequence[int], found: Sequence[LinePowers]) -> list[list[int]]:
    """Return the blocks of a group apart that show other lines; a line that a block does not show is in its bands."""
    parts = dict[bytes, list[int]]()
    for row in group:
        parts.setdefault(np.isfinite(found[row].power).tobytes(), []).append(row)
    return list(parts.values())


def line_powers(run: MeasuredRun, samples: slice, places: Sequence[Place]) -> LinePowers:
    """Return the lines at ``places`` in the samples of a block.

    Moments without a signal have no weight in the regression: a line that is bridged there would be missing from the
    torque, and its negative stand in the residual.
    """
    torque, speed = run.torque[samples], run.speed[samples]
    lost = np.zeros(0, dtype=bool) if run.lost is None else run.lost[samples]
    duration = torque.size / run.rate
    time = np.arange(torque.size) / run.rate
    smearing = run.smearing(samples)
    shown = shown_places(places, speed, run.rate, smearing=smearing)
    if smearing > _LOST:
        shown = [index for index in shown if places[index].domain == "frequency"]
    power, bandwidth, half_width, leakage = (np.full(len(places), np.nan) for _ in range(4))
    waves = Waves([places[index] for index in shown], run.angle[samples], time)
    window = hann_window(torque.size)
    found = regressed(torque, waves, window=np.where(lost, 0.0, window) if lost.any() else window)
    if lost.any():
        found = replace(found, rest=_continued(found.rest, lost))
        torque = (
            found.rest + found.level + found.slope * np.linspace(-1.0, 1.0, torque.size) + waves.summed(found.amplitude)
        )
    power[shown] = np.abs(found.amplitude) ** 2
    bandwidth[shown] = 2 * HANN_NOISE / duration * found.widening
    half_width[shown] = RESOLVED / duration
    frequency = line_frequencies(places, float(speed.mean()))[0]
    follows = np.array([places[index].domain == "order" for index in shown], dtype=bool)
    left = np.where(follows & run.has_encoder, _LEFT, 1.0)
    leakage[shown] = _leakage(found.rest, power[shown], frequency[shown], rate=run.rate, left=left)
    residual = found.rest + found.level + found.slope * np.linspace(-1.0, 1.0, torque.size)
    width = smeared_width(places, frequency, smearing, duration)
    smeared = [index for index in shown if width[index] > 0]
    if smeared:
        kept = [row for row, index in enumerate(shown) if index not in set(smeared)]
        sharp = Waves([places[shown[row]] for row in kept], run.angle[samples], time)
        rest = torque - torque.mean() - sharp.summed(found.amplitude[kept])
        phases = [places[index].at * run.angle[samples] for index in smeared]
        half_width[smeared] = width[smeared]
        power[smeared], bandwidth[smeared] = _sum_smeared(rest, phases, width[smeared], rate=run.rate)
    return LinePowers(power, bandwidth, half_width, np.maximum(leakage, half_width), residual)


def _continued(rest: Floats, lost: NDArray[np.bool_]) -> Floats:
    """Return what a regression leaves, with straight lines over the moments without a signal.

    A line joins the means of as many samples before and after as the moment has: between single samples it would hold
    their noise for the whole moment, which makes slow noise of fast one.
    """
    answer = rest.copy()
    for start, stop in moments_of(lost):
        length = stop - start
        sides = (slice(max(start - length, 0), start), slice(stop, stop + length))
        ends = [rest[own][~lost[own]] for own in sides]
        means = [float(values.mean()) for values in ends if values.size] or [0.0]
        answer[start:stop] = np.linspace(means[0], means[-1], length)
    return answer


def _leakage(rest: Floats, power: Floats, frequency: Floats, *, rate: float, left: Floats) -> Floats:
    """Return within how many hertz of each line what a regression leaves of it exceeds the noise, shape (lines,).

    The power next to a line under a Hann window falls with the sixth power of the distance in bins; ``left`` is the
    share of each line that the regression leaves, shape (lines,): an angle that was estimated does not follow the shaft
    exactly, and the frequency of a tone is found to some hundredths of a bin and wanders.
    """
    step = rate / rest.size
    window = hann_window(rest.size)
    density = 2 * np.abs(np.fft.rfft(rest * window)) ** 2 / ((window**2).sum() * rate)
    answer = np.full(frequency.size, RESOLVED)
    for row, at in enumerate(frequency.tolist()):
        middle = round(at / step)
        around = density[max(middle - _FAR, 1) : middle + _FAR + 1]
        noise = 2 * float(np.median(around)) / _MEDIAN_OF_EXPONENTIAL * step if around.size else 0.0
        if noise > 0:
            answer[row] = min(max(RESOLVED, (left[row] * power[row] / noise) ** (1 / 6)), _FAR)
    return answer * step


def _sum_smeared(rest: Floats, phases: Sequence[Floats], width: Floats, *, rate: float) -> tuple[Floats, Floats]:
    """Return the power of lines that are wider than a bin, and what it has for its noise bandwidth.

    Each line is brought to rest by its phase, which sweeps with the shaft (order tracking: Brandt 2011, Noise and
    Vibration Analysis, 12). What the angle does not follow of it then lies within ``width`` [Hz] of its frequency.
    ``phases`` are those of the lines at each sample [rad].
    """
    window = hann_window(rest.size)
    step = rate / rest.size
    scale = 2 * step * 2 / ((window**2).sum() * rate)
    bins = np.minimum((width / step).astype(int), (rest.size - 1) // 2)
    power = np.zeros(width.size)
    for row, (phase, reach) in enumerate(zip(phases, bins.tolist(), strict=True)):
        spectrum = np.abs(np.fft.fft(rest * window * np.exp(-1j * phase))) ** 2
        power[row] = scale * (spectrum[: reach + 1].sum() + spectrum[rest.size - reach :].sum())
    return power, 2 * (2 * bins + 1) * step
