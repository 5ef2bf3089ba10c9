"""What a gap in a gear changes in the features of a run: simulated with gaps of some widths and without one.

No linear model has a gap. Where the torque passes zero the flanks part, fly and strike: lines, densities and mean
torques change, which the simulation of the contact shows (``mechanisms.Backlash``). The change is the logarithm of a
power with the gap less that without it, and the difference of two mean torques, of runs that share load, noise and
phases. It is added to what the linear twin expects of the rig without the gap (Kennedy & O'Hagan 2001, J. R. Stat.
Soc. B 63: a fast model with the discrepancy of a slow one), and interpolated over the logarithm of the width.

Whether flanks part depends on how the lines meet: the simulated lines have the phases that the run shows. The run is
simulated once, with the parameters of the rig for which it is first required. Not valid where the torque passes zero
only by what that rig lacks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import log, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.rests import near_zero, rests
from torquerig.inference.features.run_features import RunFeatures, blocks_like, features_like
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.inference.places import Place
from torquerig.inference.prediction.line_phases import Samples, with_measured_phases
from torquerig.linear_twin.field_speed import share_of_field
from torquerig.parallel import parallel_map, processes
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.sensor_stages.scale_and_zero import ScaleAndZero

Floats = NDArray[np.float64]

WIDTHS = (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)  # [arcmin] from a precision gear to a worn worm
ARCMIN = pi / 180 / 60  # [rad]
_REPLICATES = 3  # runs with other loads and phases
_LAW = 0.2  # [1] of a change: law and damping of the contact are not stated
_UNLOADED = 0.003  # [1] share of the samples of a block whose torque is near zero or beyond
_NEAR = 0.1  # [1] of the mean torque of the block: what the shafts between gap and sensor may take from it
_LEAST = 0.1  # [1] of the noise: a weaker line cannot be distinguished from it
_OPENS = 0.2  # [1] of the logarithm of a density: a gap that changes no band by more does not open
_NEIGHBOURS = 7  # bands whose scatter is pooled
_FRESH_SEED = 20_000  # apart from those of other draws


@dataclass(frozen=True, eq=False)
class Change:
    """What a gap changes in the features of one run, each with its standard deviation.

    Parameters
    ----------
    line, line_error : ndarray, shape (..., segments, places)
        Of the logarithm of the power of each line [1].
    band, band_error : ndarray, shape (..., segments, bands)
        Of the logarithm of each density [1].
    level, level_error : ndarray, shape (..., levels)
        Of each mean torque [N m].
    """

    line: Floats
    line_error: Floats
    band: Floats
    band_error: Floats
    level: Floats
    level_error: Floats

    def mixed(self, weights: Floats) -> Change:
        """Return the change weighted over the first axis, with its errors and that of the contact's law."""

        def own(values: Floats) -> Floats:
            return np.asarray(np.tensordot(weights, values, axes=1))

        line, band, level = own(self.line), own(self.band), own(self.level)
        return Change(
            line, np.hypot(own(self.line_error), _LAW * line), band, np.hypot(own(self.band_error), _LAW * band),
            level, np.hypot(own(self.level_error), _LAW * level),
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class SimulatedRests:
    """Statistics of rests of one run.

    Parameters
    ----------
    measured : ndarray, shape (statistics,)
    simulated : ndarray, shape (replicates, widths + 1, statistics)
        The first one of the widths is a closed gap.
    """

    measured: Floats
    simulated: Floats


@dataclass(frozen=True, eq=False)
class _Table:
    """Changes of the features at some places by the width, first axis of all arrays: ``WIDTHS``."""

    places: tuple[Place, ...]
    change: Change
    rests: SimulatedRests | None

    def at(self, gap: float, places: Sequence[Place]) -> Change:
        """Return the change at a gap [rad]; none of lines that were not there when it was simulated."""
        widths = np.array(WIDTHS) * ARCMIN
        inside = float(np.clip(gap, widths[0], widths[-1]))
        row = np.array([np.interp(log(inside), np.log(widths), one) for one in np.eye(widths.size)])
        found = self.change.mixed(row * min(gap / float(widths[0]), 1.0))
        if tuple(places) == self.places:
            return found
        own = [self.places.index(place) if place in self.places else -1 for place in places]
        line, error = (np.pad(each, ((0, 0), (0, 1)))[:, own] for each in (found.line, found.line_error))
        return replace(found, line=line, line_error=error)


def gap_change(rig: Rig, seen: RunFeatures) -> Change | None:
    """Return what the gaps of the mechanisms ``backlash`` of a rig change; None where there are none or none opens.

    Raises
    ------
    SimulationError
        Where the rig cannot be simulated.
    """
    gaps = [part for part in rig.of_kind("backlash") if part.gap > 0]
    if len(gaps) != 1 or not comes_near_zero(seen.run):
        return None
    return _table(rig, gaps[0], seen).at(gaps[0].gap, seen.places)


def simulated_rests(rig: Rig, part: Part, seen: RunFeatures) -> SimulatedRests | None:
    """Return how the torque of a run rests near zero, and so with gaps; None where no width changes its spectrum.

    ``part`` is a mechanism ``backlash``, not yet in ``rig``; raises as ``gap_change``.
    """
    return _table(rig + part, part, seen).rests if comes_near_zero(seen.run) else None


def _table(rig: Rig, part: Part, seen: RunFeatures) -> _Table:
    """Return the changes of the parts of ``seen``; few rigs need those of held-out ones, which are simulated again."""
    kept, gear = seen.run.kept, part.gear  # type: ignore[attr-defined]
    closed = kept.get("closed", gear, lambda: rig.without(part.name))
    return kept.get("gap", (gear, seen.parts.tobytes()), lambda: _simulated(closed, part, seen))


def comes_near_zero(run: MeasuredRun) -> bool:
    """Return whether the torque comes so near to zero in a block of a run that flanks may part there."""
    return run.kept.get("near zero", (), lambda: any(_comes_near(run.torque[each.samples]) for each in run.blocks))


def can_be_simulated(run: MeasuredRun) -> bool:
    """Return whether the conditions of a run determine its course; a measured input repeats in no other run."""
    return run.run.speed is not None and run.run.inputs is None


def _comes_near(torque: Floats) -> bool:
    mean = float(torque.mean())
    low = float(np.quantile(np.sign(mean) * torque, _UNLOADED))
    return low < _NEAR * abs(mean)


def _simulated(closed: Rig, part: Part, seen: RunFeatures) -> _Table:
    runs = [_as_measured(each, seen.run) for replicate in range(_REPLICATES)
            for each in _recordings(closed, part, seen.run, seed=_FRESH_SEED + replicate)]  # fmt: skip
    found, size = parallel_map(lambda each: _powers_and_levels(features_like(seen, each)), runs), len(WIDTHS) + 1
    rows = range(0, len(runs), size)
    change = _change([found[row : row + size] for row in rows])
    ringing = seen.bands.middle[int(np.argmax(change.band[-1].mean(axis=0)))]
    rests = None
    if np.abs(change.band).max() > _OPENS:
        every = [_rests(closed, each, seen, 1 / ringing) for each in (seen.run, *runs)]
        rests = SimulatedRests(every[0], np.array([every[1 + row : 1 + row + size] for row in rows]))
    return _Table(seen.places, change, rests)


def _rests(closed: Rig, run: MeasuredRun, seen: RunFeatures, window: float) -> Floats:
    """Return the statistics of rests of a run in the blocks of ``seen``, near zero being that of its run."""
    zero = sum(stage.zero for stage in closed.at(run.run).stages() if isinstance(stage, ScaleAndZero))
    near = near_zero(seen.run.torque - zero, rate=run.rate, window=window)
    return rests(run.torque - zero, blocks_like(seen), rate=run.rate, window=window, near=near)


def _recordings(closed: Rig, part: Part, run: MeasuredRun, *, seed: int) -> list[Recording]:
    """Return simulated runs of one seed: without a gap, then with each width."""
    from torquerig.simulation.batch import simulate_batch

    phased, rate = with_measured_phases(closed, _samples(run)), run.rate
    at = phased.at(_of_field(phased, run))
    rigs = [at + replace(part, gap=width * ARCMIN) for width in (0.0, *WIDTHS)]  # type: ignore[call-arg]
    return simulate_batch(
        rigs, seeds=[seed] * len(rigs), duration=run.torque.size / rate, sample_rate=rate, most_steps=10_000,
        workers=processes(),
    )  # fmt: skip


def _of_field(rig: Rig, run: MeasuredRun) -> Run:
    """Return the conditions of a run with the set-point of its drive: that of an induction motor is its field."""
    conditions = run.run
    if conditions.speed is None or not run.is_steady:
        return conditions
    return replace(conditions, speed=conditions.speed / share_of_field(rig, conditions))


def _samples(run: MeasuredRun) -> Samples:
    """Return the samples in which the phases of lines are measured: those of the blocks that a fit may see."""
    used = np.zeros(run.torque.size, dtype=bool)
    for block in run.blocks:
        used[block.samples] = not block.held_out
    return Samples(run=run.run, rate=run.rate, torque=run.torque, angle=run.angle, speed=run.speed, used=used)


def _as_measured(recording: Recording, run: MeasuredRun) -> MeasuredRun:
    """Return a simulated recording as the run that it repeats, with the simulated angle."""
    angle = recording.channels[str(recording.find("motor_angle", truth=True))].in_si()
    if run.is_steady and not run.has_encoder:
        angle = np.linspace(angle[0], angle[-1], angle.size)
    torque = recording.channels[recording.torque_name()].in_si()
    return replace(run, torque=torque, angle=angle, speed=speed_of(angle, run.rate))


def _powers_and_levels(seen: RunFeatures) -> tuple[Floats, Floats, Floats]:
    """Return the logarithms of the powers of lines and of the densities, and the mean torques."""
    return _log_lines(seen), np.log(np.maximum(seen.band_power, 1e-300)), seen.level


def _change(replicates: Sequence[Sequence[tuple[Floats, Floats, Floats]]]) -> Change:
    """Return the mean change over replicates, first axis the width; each replicate begins with a closed gap."""

    def of(kind: int, pooled: tuple[int, ...]) -> tuple[Floats, Floats]:
        values = np.array([[each[kind] for each in one] for one in replicates])
        change = np.nan_to_num(values[:, 1:] - values[:, :1])
        scatter = _pooled(change.var(axis=0, ddof=1), pooled)
        return change.mean(axis=0), np.sqrt(np.maximum(scatter, 0.0) / len(replicates))

    return Change(*of(0, (3, 1, 3)), *of(1, (3, 1, _NEIGHBOURS)), *of(2, (3, _NEIGHBOURS)))


def _log_lines(seen: RunFeatures) -> Floats:
    """Return the logarithm of the power of each line without the noise below it, shape (segments, places)."""
    bands = seen.bands
    power = np.where(np.isfinite(seen.band_power), seen.band_power, np.nanmin(seen.band_power, axis=1, keepdims=True))
    at = np.log(np.maximum(seen.line_frequency, bands.low[0]))
    floor = np.exp([np.interp(one, np.log(bands.middle), np.log(np.maximum(own, 1e-300)))
                    for one, own in zip(at, power, strict=True)])  # fmt: skip
    noise = seen.lines.noise_bandwidth * floor
    return np.asarray(np.log(np.maximum(seen.lines.power - noise, _LEAST * noise)))


def _pooled(variance: Floats, sizes: tuple[int, ...]) -> Floats:
    """Return variances averaged over neighbours along each axis."""
    from scipy.ndimage import uniform_filter

    return np.asarray(uniform_filter(variance, size=sizes, mode="nearest")) if variance.size else variance
