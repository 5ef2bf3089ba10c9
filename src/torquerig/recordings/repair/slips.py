"""What lets go and grips again: single blows that swing a loaded shaft to and fro, far beyond all else that it does.

A coupling that slips unwinds the shafts and strikes them when it grips, so that the reading swings to both sides for
some hundredths of a second, now and then. Hits of a load go one way; flanks of a gap strike where the torque comes near
zero; a damaged bearing knocks in a rhythm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.moments import moments_of
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_BLOCK, _ABOUT = 0.02, 12  # [s], and blocks either way of which the level is the median
# robust spreads: of 293 blind rigs without such blows two have a loaded steady run with three beyond 20, and none has
# them in all; in such runs of seven with them the furthest is 25 to 73. Once known, smaller ones are some as well; and
# the share of that which the swing to the other side must reach
_FAR, _KNOWN, _BOTH_WAYS = 20.0, 7.0, 0.3
_LOADED = 5.0  # robust spreads from zero to the level of a run in which no flanks part
_FEWEST, _MOST_OFTEN, _TOGETHER = 3, 3.5, 3  # blows in a run; a second; blocks within which two are one
_IN_RHYTHM = 0.1  # of the shortest time between two blows, by which all others are whole multiples of it
_BEFORE, _AFTER = 0.005, 0.1  # [s] that are left out beside a blow, which rings on
_STEP, _HELD, _AT_MOST = 0.004, 2.5, 0.1  # [s] back, while the torque that is held strays by so many spreads; [s]


@dataclass(frozen=True)
class Slips:
    """The moments of a recording's blows, first sample and one past the last, and how far the furthest swings [V]."""

    moments: tuple[tuple[int, int], ...]
    furthest: float
    spreads: float


def slips(recordings: Sequence[Recording]) -> tuple[Slips | None, ...]:
    """Return the blows of each recording; None for all unless each steady run under load has some, and one has.

    Where they are there, those that stand out less are some, too, but where a run's friction changes sides.

    Parameters
    ----------
    recordings : sequence of Recording
        Moments without signal bridged.
    """
    looked = [_looked_at(each) for each in recordings]
    loaded = [each for each in looked if each is not None and each.steady and each.under_load]
    under_load = [each.slips(_FAR).moments for each in loaded]
    often = any(
        len(moments) > _MOST_OFTEN * each.recording.duration for moments, each in zip(under_load, loaded, strict=True)
    )
    if not loaded or often or min(map(len, under_load)) < _FEWEST or all(map(_in_rhythm, under_load)):
        return (None,) * len(recordings)
    found = [None if each is None else each.slips(_KNOWN) for each in looked]
    return tuple(each if each is not None and each.moments else None for each in found)


@dataclass(frozen=True)
class _Look:
    """How far a recording's blocks reach above and below the level about them, in robust spreads, shape (blocks,)."""

    up: Floats
    down: Floats
    level: Floats  # [V]
    spread: float  # [V]
    recording: Recording

    @property
    def under_load(self) -> bool:
        return float(abs(np.median(self.level))) > _LOADED * self.spread

    @property
    def steady(self) -> bool:
        return self.recording.run.profile == "steady"

    def slips(self, least: float) -> Slips:
        """Return what swings to both sides, to one of them by more than ``least`` spreads."""
        rate, far = self.recording.sample_rate, np.maximum(self.up, self.down) > least
        size, moments, furthest = _block_of(rate), [], 0.0
        for start, stop in moments_of(np.convolve(far, np.ones(2 * _TOGETHER + 1), "same") > 0):
            up, down = float(self.up[start:stop].max()), float(self.down[start:stop].max())
            if min(up, down) < _BOTH_WAYS * least:
                continue
            own = np.flatnonzero(far[start:stop]) + start
            first = self._let_go(int(own[0]) * size, float(self.level[own[0]])) - round(_BEFORE * rate)
            last = (int(own[-1]) + 1) * size + round(_AFTER * rate)
            moments.append((max(first, 0), min(last, self.recording.samples)))
            furthest = max(furthest, up, down)
        return Slips(tuple(moments), furthest * self.spread, furthest)

    def _let_go(self, at: int, level: float) -> int:
        """Return the sample from which on something held less than before the blow ``at`` which it gripped again."""
        volts, step = self.recording.torque_values(), max(round(_STEP * self.recording.sample_rate), 1)
        for start in range(at, max(at - round(_AT_MOST * self.recording.sample_rate), step), -step):
            if abs(float(np.median(volts[start - step : start])) - level) < _HELD * self.spread:
                return start
        return at


def _in_rhythm(moments: Sequence[tuple[int, int]]) -> bool:
    """Whether blows come at multiples of one time, as the knocks of a bearing do."""
    between = np.diff([start for start, _ in moments])
    times = between / between.min()
    return bool(np.all(np.abs(times - np.round(times)) < _IN_RHYTHM))


def _looked_at(recording: Recording) -> _Look | None:
    """Return how far a recording reaches, None where it is short or stands still."""
    volts, size = recording.torque_values(), _block_of(recording.sample_rate)
    blocks = volts[: volts.size // size * size].reshape(-1, size)
    if blocks.shape[0] <= 2 * _ABOUT:
        return None
    level = _level(np.median(blocks, axis=1))
    beside = blocks - level[:, None]
    if recording.run.profile == "reversal":
        beside[_changing_sides(level)] = 0.0
    spread = spread_about_zero(beside)
    if not spread:
        return None
    return _Look(
        up=beside.max(axis=1) / spread, down=-beside.min(axis=1) / spread, level=level, spread=spread,
        recording=recording,
    )  # fmt: skip


def _level(medians: Floats) -> Floats:
    return np.asarray(np.median(_windows(medians), axis=1))


def _changing_sides(level: Floats) -> NDArray[np.bool_]:
    around = _windows(level)
    return np.asarray((around.min(axis=1) < 0) & (around.max(axis=1) > 0))


def _windows(values: Floats) -> Floats:
    return sliding_window_view(np.pad(values, _ABOUT, mode="edge"), 2 * _ABOUT + 1)


def _block_of(rate: float) -> int:
    return max(round(_BLOCK * rate), 1)
