"""Expected features of one run: power of lines, density of bands, levels and their covariance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.acceleration_error import acceleration_covariance
from torquerig.inference.prediction.gap_change import gap_change
from torquerig.inference.prediction.hit_courses import COURSES, hit_courses
from torquerig.inference.prediction.kept_twin import clumping_of, level_balance, level_inertia, load_key, loads_of
from torquerig.inference.prediction.line_features import line_features
from torquerig.inference.prediction.measuring_chain import chain_noise, passed_by_logger, rounding_error
from torquerig.inference.prediction.reading_courses import Courses, course_density, courses, slow_noise
from torquerig.inference.prediction.ringing import ringing_density
from torquerig.inference.prediction.slow_lines import covariance_of_lines
from torquerig.inference.prediction.slow_torque import covariance
from torquerig.inference.prediction.speed_torque import profile_density, wander_at, wander_between
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.sensor_stages.drift import Drift
from torquerig.sensor_stages.scale_and_zero import ScaleAndZero
from torquerig.sensor_stages.speed_course import SpeedCourse

Floats = NDArray[np.float64]

_SHIFT = 0.01  # [1] of the frequencies of the modes, for a difference quotient
_SLOWEST = 2  # points of the grid: slower than this the response of the shafts is that at rest


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
        Share of it that random loads and changes of the speed make [1].
    hit_courses : ndarray, shape (courses, bands)
        Logarithm of the density of random loads with hits of another course, over the one above [1].
    level : ndarray, shape (levels,)
        [N m]
    level_covariance : ndarray, shape (levels, levels)
        [(N m)^2]
    slow_load : ndarray, shape (levels, levels)
        Share of it that random loads make [(N m)^2].
    level_rate : ndarray, shape (levels,)
        How fast the level changes from part to part [N m/s]; 0 in a steady run.
    level_range : ndarray, shape (levels,)
        By how much the torque departs from a straight course within a part [N m].
    near_lines : ndarray, shape (segments, places)
        Sum of the squares of the amplitudes of the lines that may have side lines at a place [(N m)^2].
    near_bands : ndarray, shape (segments, bands)
        Density if all lines that may have side lines in a band stood in it [(N m)^2/Hz].
    line_range : ndarray, shape (segments, places)
        Standard deviation of the logarithm of ``line_power`` over the speeds of a segment [1].
    line_beat : ndarray, shape (segments, places)
        Variance of the logarithm of ``line_power`` where several lines share a place and beat, or a line is noise in
        part [1].
    load_clumping : float
        Variance of the logarithm of a load's power in a time T, common to all bands, times T [s].
    block_gain : tuple of ndarray, shape (blocks,) each
        Logarithm of the square of the gain of the reading in each block of each segment [1]; none where it is steady.
    line_error : ndarray, shape (segments, places)
        Standard deviation of the logarithm of ``line_power`` that simulated replicates leave [1].
    density_error : ndarray, shape (segments, bands)
        The same of ``density`` [1].
    level_error : ndarray, shape (levels,)
        The same of ``level`` [N m].
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
    near_lines: Floats
    near_bands: Floats
    line_beat: Floats
    load_clumping: float = 0.0
    block_gain: tuple[Floats, ...] = ()
    line_error: Floats | float = 0.0
    density_error: Floats | float = 0.0
    level_error: Floats | float = 0.0
    hit_courses: Floats = field(default_factory=lambda: np.zeros((COURSES, 1)))


def expected_run(rig: Rig, seen: RunFeatures) -> ExpectedRun:
    """Return what is expected of the run of ``seen``: by the linear twin, with what simulated gaps change of it."""
    twin = Twin(rig.at(seen.run.run))
    loads = () if seen.run.is_steady else {load.name for load in loads_of(twin.rig)}  # they may depend on the speed
    parts = [repr(part) for part in rig.parts if part.name in loads]
    key = (twin.terms, twin.rig.stages(), twin.cutoff, twin.scale, rig.measured, *parts)
    return seen.kept.get("expected", key, lambda: _with_gaps(rig, seen, _by_twin(twin, rig, seen)))


def _with_gaps(rig: Rig, seen: RunFeatures, model: ExpectedRun) -> ExpectedRun:
    change = gap_change(rig, seen)
    if change is None:
        return model
    return replace(
        model, line_power=model.line_power * np.exp(change.line), line_error=change.line_error,
        density=model.density * np.exp(change.band), density_error=np.hypot(change.band_error, model.density_error),
        level=model.level + change.level, level_error=change.level_error,
    )  # fmt: skip


def expected_line_power(rig: Rig, seen: RunFeatures) -> Floats:
    """Return ``line_power`` of the expected run alone."""
    twin, change = Twin(rig.at(seen.run.run)), gap_change(rig, seen)
    power, read = line_features(twin, seen).power, courses(twin.rig, seen)
    power = power if read is None else read.power[:, None] * power
    return power if change is None else np.asarray(power * np.exp(change.line))


def _by_twin(twin: Twin, rig: Rig, seen: RunFeatures) -> ExpectedRun:
    recorded = passed_by_logger(twin.rig, seen.bands.middle)
    load = recorded * _load(twin, rig, seen)
    noise = chain_noise(twin.rig, seen)
    density = load + noise + recorded * ringing_density(twin, seen)
    lines = line_features(twin, seen)
    balance = level_balance(twin, seen)
    slow = np.maximum(seen.level_grid, seen.level_grid[_SLOWEST])
    slow_load = seen.kept.get("slow", load_key(twin), lambda: covariance(seen, _slow_power(twin, seen, slow)))
    spread = slow_load
    for each in lines.unshown:
        spread = spread + covariance_of_lines(seen, each)
    wandering = slow_noise(twin.rig, seen)
    spread = spread if wandering is None else spread + wandering
    accelerating = acceleration_covariance(seen)
    if accelerating is not None:
        spread = spread + np.outer(*2 * [level_inertia(twin, seen)]) * accelerating
    moving = not seen.run.is_steady and seen.level.size > 1
    level = balance.sensor.mean(axis=1) + _zero(twin.rig, seen)
    # parts of held-out blocks are left out between: the steepest slope that the two ends permit
    steepest = np.abs(np.gradient(level)) / np.maximum(seen.level_duration, 1e-9) if moving else 0.0 * level
    changing = np.where(seen.level_neighbours, steepest[None], 0.0).max(axis=1)
    own, loads = _range_about_line(balance.sensor), loads_of(twin.rig)
    courses_of_hits = seen.kept.get("hits", loads, lambda: hit_courses(loads, seen.bands))
    density = density + lines.density
    expected = ExpectedRun(
        line_power=lines.power, line_slope=lines.slope, line_range=lines.varied, line_beat=lines.beat, density=density,
        load_share=load / density, level=level, level_covariance=spread, slow_load=slow_load, level_rate=changing,
        load_clumping=clumping_of(twin.rig), level_range=own, hit_courses=courses_of_hits,
        density_error=rounding_error(twin.rig, seen, density),
        near_lines=np.einsum("sp,spq->sq", lines.power, seen.side_places),
        near_bands=np.einsum("sp,spb->sb", 0.5 * lines.power, seen.side_bands) / (seen.bands.high - seen.bands.low),
    )  # fmt: skip
    read = courses(twin.rig, seen)
    return expected if read is None else _as_read(expected, read, noise, course_density(twin.rig, seen, level))


def _as_read(expected: ExpectedRun, read: Courses, noise: Floats, moving: Floats) -> ExpectedRun:
    """Return what is expected of a reading whose gain and zero have courses.

    ``noise`` is the density of the chain's noise, ``moving`` that of the courses [(N m)^2/Hz].
    """
    power, both = read.power[:, None], np.outer(read.gain, read.gain)
    density = noise + power * (expected.density - noise) + moving
    return replace(
        expected, line_power=power * expected.line_power, density=density,
        load_share=power * expected.load_share * expected.density / density,
        level=read.gain * expected.level + read.zero, level_covariance=both * expected.level_covariance,
        slow_load=both * expected.slow_load, level_rate=np.abs(read.gain) * expected.level_rate,
        level_range=np.abs(read.gain) * expected.level_range, near_lines=power * expected.near_lines,
        near_bands=power * expected.near_bands, block_gain=read.blocks,
    )  # fmt: skip


def _range_about_line(values: Floats) -> Floats:
    """Return the range of each row about its straight line, shape (rows,)."""
    time = np.linspace(-1.0, 1.0, values.shape[1])
    slope = (values @ time) / float(time @ time)
    rest = values - values.mean(axis=1, keepdims=True) - slope[:, None] * time
    return np.asarray(rest.max(axis=1) - rest.min(axis=1))


def _slow_power(twin: Twin, seen: RunFeatures, frequency: Floats) -> Floats:
    """Return the density that random loads and a wandering speed make [(N m)^2/Hz]."""
    return twin.load_power(frequency) + wander_at(twin, seen, frequency)


def _moved(twin: Twin, seen: RunFeatures, density: Callable[[Twin, RunFeatures], Floats]) -> Floats:
    """Return what changes of the speed make in each band [(N m)^2/Hz]."""
    key = (density.__name__, twin.shafts, twin.cutoff, twin.scale, *twin.drives)
    return seen.kept.get("moved", key, lambda: density(twin, seen))


def _load(twin: Twin, rig: Rig, seen: RunFeatures) -> Floats:
    """Return the density that random loads and changes of the speed make [(N m)^2/Hz], shape (segments, bands)."""
    moved = _moved(twin, seen, wander_between) + _moved(twin, seen, profile_density)
    return np.asarray(_random_load(twin, rig, seen) + moved)


def _random_load(twin: Twin, rig: Rig, seen: RunFeatures) -> Floats:
    """Return the density that random loads make in each segment [(N m)^2/Hz], shape (segments, bands).

    A load whose process depends on the set-point is taken at the speed of the segment.
    """
    bands, run, count = seen.bands, seen.run.run, len(seen.segments)
    own, key = loads_of(twin.rig), load_key(twin)
    parts = [repr(part) for part in rig.parts if any(load.name == part.name for load in own)]
    slower = own
    if not seen.run.is_steady and run.speed:
        half = replace(run, speed=0.5 * run.speed)
        slower = seen.kept.get("slower", (*key, *parts), lambda: loads_of(rig.at(half)))
    if slower == own:
        even = seen.kept.get("load", key, lambda: twin.load_power_between(bands.low, bands.high))
        return np.tile(even, (count, 1))
    return seen.kept.get("load", (*key, slower, *parts), lambda: _load_at_each_speed(rig, seen))


def _load_at_each_speed(rig: Rig, seen: RunFeatures) -> Floats:
    bands, run = seen.bands, seen.run.run
    fastest = float(np.abs(seen.speed).max())
    at = [replace(run, speed=float(speed) or 1e-6 * fastest) for speed in seen.speed]
    return np.array([Twin(rig.at(one)).load_power_between(bands.low, bands.high) for one in at])


def _zero(rig: Rig, seen: RunFeatures) -> Floats:
    """Return what is added to the torque in each part [N m], shape (levels,): zero, drift, course over the speed."""
    zero, unit = np.zeros(seen.level.size), seen.unit
    time = 0.5 * seen.parts.sum(axis=1) / seen.run.rate
    for stage in rig.stages():
        if isinstance(stage, ScaleAndZero):
            zero += stage.zero
        elif isinstance(stage, Drift):
            zero += unit * stage.course(time, seen.run.recording.duration)
        elif isinstance(stage, SpeedCourse):
            zero += stage.torque(seen.level_speed).mean(axis=1)
    return zero
