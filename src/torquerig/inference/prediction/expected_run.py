"""Expected features of one run: power of lines, density of bands, levels and their covariance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.linear.quasi_static import quasi_static
from torquerig.diagnosis.linear.twin import Twin, passed, sources
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.line_routes import line_routes
from torquerig.inference.prediction.measuring_chain import chain_noise, crosstalk_lines, passed_by_logger
from torquerig.inference.prediction.ringing import ringing_density, ringing_lines
from torquerig.inference.prediction.slow_torque import covariance, of_lines
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load
from torquerig.sensor_stages.drift import Drift
from torquerig.sensor_stages.scale_and_zero import ScaleAndZero
from torquerig.sensor_stages.tone import Tone, folded

Floats = NDArray[np.float64]

_SHIFT = 0.01  # [1] of the frequencies of the modes, for a difference quotient
_SLOWEST = 0.05  # [Hz] slower than this the response of the shafts is that at rest


@dataclass(frozen=True)
class ExpectedRun:
    """What a model expects of the features of one run.

    Parameters
    ----------
    line_power : ndarray, shape (segments, places)
        Sum of the squares of the amplitudes of the lines at a place, without noise [(N m)^2].
    line_slope : ndarray, shape (segments, places)
        Change of the logarithm of ``line_power`` per relative change of the frequencies of the rig's modes [1].
    density : ndarray, shape (segments, bands)
        Mean one-sided density without the lines that have a place [(N m)^2/Hz].
    load_share : ndarray, shape (segments, bands)
        Share of it that random loads make [1].
    level : ndarray, shape (levels,)
        [N m]
    level_covariance : ndarray, shape (levels, levels)
        [(N m)^2]
    level_rate : ndarray, shape (levels,)
        How fast the level changes from part to part [N m/s]; 0 in a steady run.
    """

    line_power: Floats
    line_slope: Floats
    density: Floats
    load_share: Floats
    level: Floats
    level_covariance: Floats
    level_rate: Floats


def expected_run(rig: Rig, seen: RunFeatures) -> ExpectedRun:
    """Return what the linear twin of ``rig`` expects of the run of ``seen``."""
    twin = Twin(rig.at(seen.run.run))
    count, places = len(seen.segments), len(seen.places)
    kept = passed_by_logger(twin.rig, seen.bands.middle)
    load = kept * _load(twin, rig, seen)
    density = load + chain_noise(twin.rig, seen) + kept * ringing_density(twin, seen)
    power, moved = np.zeros((count, places)), np.zeros((count, places))
    unshown = list[tuple[Floats, Floats]]()
    for frequency, amplitude, shifted in _lines(twin, seen):
        routes = line_routes(seen, frequency)
        kept = passed_by_logger(twin.rig, frequency)
        row = np.broadcast_to(np.arange(count), frequency.shape)
        square = kept * amplitude**2
        at = routes.place >= 0
        np.add.at(power, (row[at], routes.place[at]), (routes.share * square)[at])
        np.add.at(moved, (row[at], routes.place[at]), (routes.share * kept * shifted**2)[at])
        inside = routes.band >= 0
        np.add.at(density, (row[inside], routes.band[inside]), 0.5 * square[inside] / routes.width[inside])
        slow = ~at & (routes.band < 0)
        if slow.any():
            unshown.append((frequency[slow], 0.5 * square[slow] / count))
    balance = quasi_static(twin, speed=seen.level_speed, acceleration=seen.level_acceleration)
    spread = covariance(seen, twin.load_power(np.maximum(seen.level_grid, _SLOWEST)))
    for frequency, square in unshown:
        spread = spread + of_lines(seen, frequency, square)
    slope = np.log(np.maximum(moved, 1e-300) / np.maximum(power, 1e-300)) / _SHIFT * (power > 0)
    moving = not seen.run.is_steady and seen.level.size > 1
    level = balance.sensor.mean(axis=1) + _zero(twin.rig, seen)
    changing = np.abs(np.gradient(level)) / np.maximum(seen.level_duration, 1e-9) if moving else 0.0 * level
    return ExpectedRun(power, slope, density, load / density, level, spread, changing)


def _lines(twin: Twin, seen: RunFeatures) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Yield frequencies [Hz], amplitudes [N m], and amplitudes with all modes at ``1 - _SHIFT`` of their frequency.

    Each is of shape (lines, segments).
    """
    lines = twin.lines()
    if lines:
        motor = quasi_static(twin, speed=seen.speed, acceleration=np.zeros(seen.speed.size)).motor
        orders = np.array([line.order for line in lines])[:, None]
        frequency = orders * np.abs(seen.speed) / (2 * pi)
        at = np.maximum(frequency, _SLOWEST)
        both = np.concatenate([at, at * (1 + _SHIFT)], axis=1)
        gain = np.abs(passed([line.transfer for line in lines], both))
        size = sources(lines, motor)
        yield frequency, np.asarray(gain[:, : at.shape[1]] * size), np.asarray(gain[:, at.shape[1] :] * size)
    for frequency, size in (crosstalk_lines(twin, seen), ringing_lines(twin, seen)):
        if size.size:
            yield frequency, size, size
    volts = seen.unit
    for stage in twin.rig.stages():
        if isinstance(stage, Tone):
            tones = np.array([folded(h * stage.frequency, seen.run.rate) for h in range(1, len(stage.amplitudes) + 1)])
            shape = (tones.size, seen.speed.size)
            size = np.broadcast_to(volts * np.array(stage.amplitudes)[:, None], shape)
            yield np.broadcast_to(tones[:, None], shape), size, size


def _load(twin: Twin, rig: Rig, seen: RunFeatures) -> Floats:
    """Return the density that random loads make in each segment [(N m)^2/Hz], shape (segments, bands).

    A load whose process depends on the set-point is taken at the speed of the segment.
    """
    bands, run, count = seen.bands, seen.run.run, len(seen.segments)
    if seen.run.is_steady or not run.speed or not _depends_on_speed(twin, rig.at(replace(run, speed=0.5 * run.speed))):
        return np.tile(twin.load_power_between(bands.low, bands.high), (count, 1))
    fastest = float(np.abs(seen.speed).max())
    at = [replace(run, speed=float(speed) or 1e-6 * fastest) for speed in seen.speed]
    return np.array([Twin(rig.at(one)).load_power_between(bands.low, bands.high) for one in at])


def _depends_on_speed(twin: Twin, slower: Rig) -> bool:
    own = [term for term in twin.terms if isinstance(term, Load)]
    other = [term for term in slower.terms() if isinstance(term, Load)]
    return own != other


def _zero(rig: Rig, seen: RunFeatures) -> Floats:
    """Return the zero of the sensor in each part [N m], shape (levels,)."""
    zero, unit = np.zeros(seen.level.size), seen.unit
    time = 0.5 * seen.parts.sum(axis=1) / seen.run.rate
    for stage in rig.stages():
        if isinstance(stage, ScaleAndZero):
            zero += stage.zero
        elif isinstance(stage, Drift):
            zero += unit * stage.course(time, seen.run.recording.duration)
    return zero
