"""The numbers of one run that are compared with a model: lines, bands and levels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import STANDSTILL, Block, permitted_range
from torquerig.inference.features.bands import Bands, bands
from torquerig.inference.features.level_motion import level_motion
from torquerig.inference.features.line_places import line_frequencies
from torquerig.inference.features.line_powers import LinePowers, apart_by_lines, line_powers
from torquerig.inference.features.segment import LineTable, Segment
from torquerig.inference.features.side_lines import may_be_beside
from torquerig.inference.kept import Kept
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

SPEEDS = 3  # of a segment whose speed changes
POINTS_OF_GRID = 400  # of the integral over frequency
_HIGHEST_IN_LEVEL = 4.0  # [1] times the inverse length of a part: above it the mean of a part passes less than 1 %
_PARTS_OF_BLOCK = 4  # whose mean torque is a level: a zero may settle within a block


@dataclass(frozen=True, kw_only=True, eq=False)
class RunFeatures:
    """Features of the fitted or of the held-out blocks of one run.

    Parameters
    ----------
    run : MeasuredRun
    places : tuple of Place
    segments : tuple of Segment
    parts : ndarray, shape (levels, 2)
        First sample and one past the last of each part whose mean is a level.
    level : ndarray, shape (levels,)
        Mean torque without the lines [N m].
    level_speed, level_acceleration : ndarray, shape (levels, POINTS)
        Of the motor at moments of each part [rad/s], [rad/s^2]: what opposes motion is not linear in the speed.
    """

    run: MeasuredRun
    places: tuple[Place, ...]
    segments: tuple[Segment, ...]
    parts: NDArray[np.int64]
    level: Floats
    level_speed: Floats
    level_acceleration: Floats

    @cached_property
    def kept(self) -> Kept:
        """What models were asked for these features, for models that differ in other numbers."""
        return Kept()

    @cached_property
    def speed(self) -> Floats:
        """Mean speed of each segment [rad/s], shape (segments,)."""
        return np.array([segment.speed for segment in self.segments])

    @cached_property
    def lines(self) -> LineTable:
        """Lines of all segments."""
        rows = self.segments
        return LineTable(
            power=np.array([row.line_power for row in rows]), count=np.array([row.line_count for row in rows]),
            noise_bandwidth=np.array([row.line_noise_bandwidth for row in rows]),
            half_width=np.array([row.line_half_width for row in rows]),
        )  # fmt: skip

    @cached_property
    def band_power(self) -> Floats:
        """Density of each band in each segment [(N m)^2/Hz], shape (segments, bands)."""
        return np.array([row.bands.power for row in self.segments])

    @cached_property
    def band_count(self) -> Floats:
        """Independent values behind each of them, shape (segments, bands)."""
        return np.array([row.bands.count for row in self.segments])

    @cached_property
    def level_time(self) -> Floats:
        """Middle of each part [s], shape (levels,)."""
        return np.asarray(0.5 * self.parts.sum(axis=1) / self.run.rate)

    @cached_property
    def largest_level(self) -> float:
        """Largest mean torque of a part, without sign [N m]."""
        return float(np.abs(self.level).max(initial=0.0))

    @cached_property
    def level_segment(self) -> NDArray[np.intp]:
        """Segment that holds each part, shape (levels,); the slowest one where the motor turns back in a block."""
        answer = np.full(len(self.parts), int(np.argmin(np.abs(self.speed))) if self.segments else -1)
        for index, segment in enumerate(self.segments):
            for block in segment.blocks:
                answer[(self.parts[:, 0] >= block.start) & (self.parts[:, 1] <= block.stop)] = index
        return answer

    @cached_property
    def level_time_error(self) -> Floats:
        """Standard deviation of the time between torque and speed in each part [s], shape (levels,)."""
        return self.run.time_error(np.abs(self.level_speed).mean(axis=1))

    @cached_property
    def level_neighbours(self) -> NDArray[np.bool_]:
        """Which parts are within four times that time of each part, itself included, shape (levels, levels)."""
        time, near = self.level_time, 4 * self.level_time_error + 0.5 * self.level_duration
        return np.asarray(np.abs(time[:, None] - time[None]) <= near[:, None])

    @cached_property
    def level_grid(self) -> Floats:
        """Frequencies [Hz] over which the variance of the levels is integrated, shape (POINTS_OF_GRID,); first 0."""
        shortest = float(self.level_duration.min(initial=np.inf))
        return np.linspace(0.0, _HIGHEST_IN_LEVEL / shortest, POINTS_OF_GRID)

    @cached_property
    def level_passed(self) -> NDArray[np.complex128]:
        """What the mean of each part passes of a wave at each frequency of ``level_grid`` [1], shape (levels, grid)."""
        return passed_by_levels(self, self.level_grid)

    @cached_property
    def line_frequency(self) -> Floats:
        """Frequency of each line in each segment [Hz], shape (segments, places)."""
        return line_frequencies(self.places, self.speed)

    @cached_property
    def speeds(self) -> Floats:
        """Speeds of each segment, shape (segments, 1 or SPEEDS)."""
        return np.array([segment.speeds for segment in self.segments]).reshape(len(self.segments), -1)

    @cached_property
    def swept(self) -> Floats:
        """Slowest and fastest speed of each segment over its mean [1], shape (segments, 2)."""
        sizes = np.abs(self.speeds)
        mean = np.maximum(np.abs(self.speed), 1e-12)[:, None]
        return np.asarray(np.stack([sizes.min(axis=1), sizes.max(axis=1)], axis=1) / mean)

    @cached_property
    def side_places(self) -> Floats:
        """Whether a line (axis 1) may have side lines at another place (axis 2) [1], (segments, places, places)."""
        own = ~np.eye(len(self.places), dtype=bool)
        return np.asarray(may_be_beside(self.line_frequency, self.line_frequency) & own, dtype=np.float64)

    @cached_property
    def side_bands(self) -> Floats:
        """The same of bands, shape (segments, places, bands)."""
        middle = np.broadcast_to(self.bands.middle, (len(self.segments), self.bands.middle.size))
        return np.asarray(may_be_beside(self.line_frequency, middle), dtype=np.float64)

    @cached_property
    def line_excluded(self) -> Floats:
        """Within this distance [Hz] of each line the bands have no bins, shape (segments, places)."""
        return np.array([np.nan_to_num(row.line_excluded) for row in self.segments])

    @cached_property
    def durations(self) -> Floats:
        """Mean length of the blocks of each segment [s], shape (segments,)."""
        return np.array([self.duration_of(segment) for segment in self.segments])

    def duration_of(self, segment: Segment) -> float:
        """Return the mean length of the blocks of a segment [s]."""
        lengths = [block.stop - block.start for block in segment.blocks]
        return sum(lengths) / len(lengths) / self.run.rate

    @cached_property
    def segment_time(self) -> Floats:
        """Length of all blocks of each segment together [s], shape (segments,)."""
        return np.asarray(self.durations * np.array([len(segment.blocks) for segment in self.segments]))

    @cached_property
    def bands(self) -> Bands:
        """The bands of the first segment, whose edges are those of all."""
        return self.segments[0].bands

    @cached_property
    def unit(self) -> float:
        """Torque per unit of the recorded channel [N m]."""
        recording = self.run.recording
        return recording.channels[recording.torque_name()].si_per_unit

    @cached_property
    def level_duration(self) -> Floats:
        """Length of each part [s], shape (levels,)."""
        return np.asarray((self.parts[:, 1] - self.parts[:, 0]) / self.run.rate)


def passed_by_levels(seen: RunFeatures, frequency: Floats) -> NDArray[np.complex128]:
    """Return what the mean of each part passes of a wave [1]: ``sinc(f T) exp(2 pi i f t)``, shape (levels, points)."""
    middle = 0.5 * seen.parts.sum(axis=1) / seen.run.rate
    turned = np.exp(2j * np.pi * frequency[None] * middle[:, None])
    return np.asarray(np.sinc(frequency[None] * seen.level_duration[:, None]) * turned)


def run_features(run: MeasuredRun, places: Sequence[Place], *, held_out: bool | None = False) -> RunFeatures:
    """Return the features of the fitted blocks, of the held-out ones (``held_out``), or of all (None)."""
    blocks = [block for block in run.blocks if held_out is None or block.held_out == held_out]
    found = [line_powers(run, block.samples, places) for block in blocks]
    groups = _groups(run, blocks, [not _stands_still(run, block) for block in blocks])
    return _features(run, places, blocks, found, [rows for group in groups for rows in apart_by_lines(group, found)])


def features_like(seen: RunFeatures, run: MeasuredRun) -> RunFeatures:
    """Return the features of another run of the same length at the places, blocks and segments of ``seen``."""
    blocks = blocks_like(seen)
    row = {block.start: at for at, block in enumerate(blocks)}
    found = [line_powers(run, block.samples, seen.places) for block in blocks]
    same = [[row[block.start] for block in one.blocks] for one in seen.segments]
    return _features(run, seen.places, blocks, found, same)


def blocks_like(seen: RunFeatures) -> list[Block]:
    """Return the blocks that features were taken of, those at standstill too."""
    first, last = seen.parts[::_PARTS_OF_BLOCK, 0], seen.parts[_PARTS_OF_BLOCK - 1 :: _PARTS_OF_BLOCK, 1]
    return [Block(*edges, held_out=False) for edges in zip(first.tolist(), last.tolist(), strict=True)]


def _features(
    run: MeasuredRun, places: Sequence[Place], blocks: Sequence[Block], found: Sequence[LinePowers],
    groups: Sequence[Sequence[int]],
) -> RunFeatures:  # fmt: skip
    segments = tuple(_segment(run, places, [(blocks[row], found[row]) for row in rows]) for rows in groups)
    edges = [np.linspace(block.start, block.stop, _PARTS_OF_BLOCK + 1).astype(int) for block in blocks]
    pairs = [pair for each in edges for pair in pairwise(each.tolist())]
    rest = [lines.residual[low - block.start : high - block.start]
            for block, lines, each in zip(blocks, found, edges, strict=True)
            for low, high in pairwise(each.tolist())]  # fmt: skip
    level = np.array([float(values.mean()) for values in rest])
    parts = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    speed, acceleration = level_motion(run, parts)
    return RunFeatures(
        run=run, places=tuple(places), segments=segments, parts=parts, level=level, level_speed=speed,
        level_acceleration=acceleration,
    )  # fmt: skip


def _stands_still(run: MeasuredRun, block: Block) -> bool:
    """Return whether the motor stops or turns back in a block: sticking has no spectrum that a linear model gives."""
    speed = run.speed[block.samples]
    least = STANDSTILL * float(np.abs(run.speed).max())
    return bool(np.abs(speed).min() < least or speed.min() * speed.max() < 0)


def _groups(run: MeasuredRun, blocks: Sequence[Block], turning: Sequence[bool]) -> list[list[int]]:
    """Return the indices of the blocks that turn at about one speed, in the order of the speeds."""
    mean = [float(run.speed[block.samples].mean()) for block in blocks]
    least = STANDSTILL * max(float(np.abs(run.speed).max()), 1e-12)
    groups: list[list[int]] = []
    for index in [one for one in np.argsort(mean, kind="stable").tolist() if turning[one]]:
        if groups and mean[index] - mean[groups[-1][0]] <= permitted_range(abs(mean[index]), least):
            groups[-1].append(index)
        else:
            groups.append([index])
    return groups


def _segment(run: MeasuredRun, places: Sequence[Place], members: Sequence[tuple[Block, LinePowers]]) -> Segment:
    power = np.array([lines.power for _, lines in members])
    shown = np.isfinite(power)
    count = shown.sum(axis=0).astype(float)
    speeds = [float(run.speed[block.samples].mean()) for block, _ in members]

    def mean(values: Floats) -> Floats:
        total = np.where(shown, values, 0.0).sum(axis=0)
        return np.asarray(np.where(count > 0, total / np.maximum(count, 1.0), np.nan))

    lines = [_occupied(run, places, block, each) for block, each in members]
    return Segment(
        blocks=tuple(block for block, _ in members),
        speed=float(np.mean(speeds)),
        speeds=_speeds(run, [block for block, _ in members]),
        line_power=mean(power),
        line_noise_bandwidth=mean(np.array([each.noise_bandwidth for _, each in members])),
        line_half_width=mean(np.array([each.half_width for _, each in members])),
        line_excluded=mean(np.array([each.leakage for _, each in members])),
        line_count=count,
        bands=bands([each.residual for _, each in members], lines, run.rate, slowest=run.slowest),
        block_lines=power,
    )


def _speeds(run: MeasuredRun, blocks: Sequence[Block]) -> Floats:
    parts = [run.speed[block.samples] for block in blocks]
    if run.is_steady:
        return np.array([np.mean([part.mean() for part in parts])])
    return np.linspace(min(part.min() for part in parts), max(part.max() for part in parts), SPEEDS)


def _occupied(run: MeasuredRun, places: Sequence[Place], block: Block, lines: LinePowers) -> tuple[Floats, Floats]:
    """Return the middle [Hz] and the half-width [Hz] of what each line of a block sweeps over."""
    shown = np.isfinite(lines.power)
    speed = np.abs(run.speed[block.samples])
    slow, fast = line_frequencies(places, np.array([speed.min(), speed.max()]))[:, shown]
    return 0.5 * (slow + fast), 0.5 * (fast - slow) + lines.leakage[shown]
