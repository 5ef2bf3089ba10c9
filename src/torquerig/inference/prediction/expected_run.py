"""Expected features of one run: power of lines, density of bands, levels and their covariance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.linear.quasi_static import quasi_static
from torquerig.diagnosis.linear.twin import Twin, passed, sources
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.line_routes import line_routes
from torquerig.inference.prediction.measuring_chain import chain_noise, crosstalk_lines, passed_by_logger
from torquerig.inference.prediction.ringing import ringing_density, ringing_lines
from torquerig.inference.prediction.skirts import core_of, density_of, skirts_of
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
    slow_load : ndarray, shape (levels, levels)
        Share of it that random loads make [(N m)^2].
    level_rate : ndarray, shape (levels,)
        How fast the level changes from part to part [N m/s]; 0 in a steady run.
    level_range : ndarray, shape (levels,)
        By how much the torque changes within a part [N m].
    line_range : ndarray, shape (segments, places)
        Standard deviation of the logarithm of ``line_power`` over the speeds of a segment [1].
    """

    line_power: Floats
    line_slope: Floats
    density: Floats
    load_share: Floats
    level: Floats
    level_covariance: Floats
    slow_load: Floats
    level_rate: Floats
    level_range: Floats
    line_range: Floats


def expected_run(rig: Rig, seen: RunFeatures) -> ExpectedRun:
    """Return what the linear twin of ``rig`` expects of the run of ``seen``."""
    twin = Twin(rig.at(seen.run.run))
    count, places = len(seen.segments), len(seen.places)
    recorded = passed_by_logger(twin.rig, seen.bands.middle)
    load = recorded * _load(twin, rig, seen)
    density = load + chain_noise(twin.rig, seen) + recorded * ringing_density(twin, seen)
    power, moved, bent = (np.zeros((count, places)) for _ in range(3))
    skirts, turning = skirts_of(twin, seen.run), np.maximum(np.abs(seen.speed) / (2 * pi), 1e-12)
    core, excluded = core_of(seen), np.array([np.nan_to_num(each.line_excluded) for each in seen.segments])
    unshown = list[tuple[Floats, Floats]]()
    for frequency, square, shifted, varied, follows in _lines(twin, seen):
        routes = line_routes(seen, frequency)
        recorded = passed_by_logger(twin.rig, frequency)
        row = np.broadcast_to(np.arange(count), frequency.shape)
        square, shifted = recorded * square, recorded * shifted
        at, inside = routes.place >= 0, routes.band >= 0
        kept = np.ones(frequency.shape)
        if skirts is not None and follows:
            there = row, np.maximum(routes.place, 0)
            kept = 1 - skirts.lost(frequency / turning, np.where(at, core[there], 0.0))
            hole = np.where(at, excluded[there], 0.0)
            density += density_of(skirts, seen, frequency, np.where(at | inside, 0.5 * square, 0.0), hole)
        np.add.at(power, (row[at], routes.place[at]), (routes.share * kept * square)[at])
        np.add.at(moved, (row[at], routes.place[at]), (routes.share * kept * shifted)[at])
        np.add.at(bent, (row[at], routes.place[at]), (routes.share * kept * square * varied)[at])
        np.add.at(density, (row[inside], routes.band[inside]), 0.5 * (kept * square)[inside] / routes.width[inside])
        slow = ~at & (routes.band < 0)
        if slow.any():
            unshown.append((frequency[slow], 0.5 * square[slow] / count))
    balance = quasi_static(twin, speed=seen.level_speed, acceleration=seen.level_acceleration)
    slow_load = covariance(seen, twin.load_power(np.maximum(seen.level_grid, _SLOWEST)))
    spread = slow_load
    for frequency, square in unshown:
        spread = spread + of_lines(seen, frequency, square)
    slope = np.log(np.maximum(moved, 1e-300) / np.maximum(power, 1e-300)) / _SHIFT * (power > 0)
    moving = not seen.run.is_steady and seen.level.size > 1
    level = balance.sensor.mean(axis=1) + _zero(twin.rig, seen)
    changing = np.abs(np.gradient(level)) / np.maximum(seen.level_duration, 1e-9) if moving else 0.0 * level
    own = balance.sensor.max(axis=1) - balance.sensor.min(axis=1)
    return ExpectedRun(
        power,
        slope,
        density,
        load / density,
        level,
        spread,
        slow_load,
        changing,
        own,
        bent / np.maximum(power, 1e-300),
    )


class _Lines(NamedTuple):
    """Lines of a rig in a run, arrays of shape (lines, segments).

    Frequencies [Hz], mean squares of the amplitudes [(N m)^2], the same with all modes at ``1 - _SHIFT`` of their
    frequency, standard deviations of the logarithm of the square over the speeds of each segment [1], and whether they
    follow the shaft.
    """

    frequency: Floats
    square: Floats
    shifted: Floats
    varied: Floats
    follows: bool


def _lines(twin: Twin, seen: RunFeatures) -> Iterator[_Lines]:
    lines = twin.lines()
    if lines:
        count, points = seen.speeds.shape
        speeds = seen.speeds.ravel()
        motor = quasi_static(twin, speed=speeds, acceleration=np.zeros(speeds.size)).motor
        orders = np.array([line.order for line in lines])[:, None]
        at = np.maximum(orders * np.abs(speeds) / (2 * pi), _SLOWEST)
        both = np.concatenate([at, at * (1 + _SHIFT)], axis=1)
        gain = np.abs(passed([line.transfer for line in lines], both)) * np.tile(sources(lines, motor), 2)
        square, shifted = np.square(gain).reshape(len(lines), 2, count, points).transpose(1, 0, 2, 3)
        varied = np.log(np.maximum(square, 1e-300)).std(axis=2)
        frequency = orders * np.abs(seen.speed) / (2 * pi)
        yield _Lines(frequency, square.mean(axis=2), shifted.mean(axis=2), varied, True)
    for frequency, size in (crosstalk_lines(twin, seen), ringing_lines(twin, seen)):
        if size.size:
            yield _Lines(frequency, size**2, size**2, np.zeros(size.shape), True)
    volts = seen.unit
    for stage in twin.rig.stages():
        if isinstance(stage, Tone):
            tones = np.array([folded(h * stage.frequency, seen.run.rate) for h in range(1, len(stage.amplitudes) + 1)])
            shape = (tones.size, seen.speed.size)
            square = np.broadcast_to(np.square(volts * np.array(stage.amplitudes))[:, None], shape)
            yield _Lines(np.broadcast_to(tones[:, None], shape), square, square, np.zeros(shape), False)


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
