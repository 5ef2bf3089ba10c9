"""What a model says the features of a run should be, measured on its simulations: true for any effect, and dearer."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import chain
from math import inf

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.chance_of_load import ChanceOfLoad
from torquerig.diagnosis.expecting.expectation import Expectation, amplitude_variance, expected, floor_of
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.turning import turns_back
from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.parallel import parallel_map
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.samples_at_limit import rebuilt
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.clip import Clip
from torquerig.sensor_stages.dropout import Dropout
from torquerig.simulation.batch import simulate_batch
from torquerig.simulation.simulator import simulate

Floats = NDArray[np.float64]

_WORKERS = 2
_MOST_STEPS = 50  # a sample, where rigs of this kind need one or a few: numbers that ask for more are none that can be


def simulated(rig: Rig, observed: Observed, *, seed: int, wander: float = 0.0) -> Observed:
    """Return what the rig records in the run of ``observed``, cut into the same stretches.

    It is mended as a recording is: no moment without signal is there, and hits that reached a limit are rebuilt.
    """
    recording = simulate(
        _never_silent(rig).at(observed.run),
        duration=observed.recording.duration,
        seed=seed,
        sample_rate=observed.rate,
        wander=wander,
        most_steps=_MOST_STEPS,
    )
    return _looked_at(recording, rig, observed)


def _looked_at(recording: Recording, rig: Rig, observed: Observed) -> Observed:
    """Return a simulation of a run as the recording of it is looked at."""
    angle = recording.channels["true_motor_angle_rad"].values
    return replace(
        observed,
        recording=recording,
        torque=rebuilt(recording, limit=limit_of(rig)).torque(),
        angle=angle,
        speed=speed_of(angle, observed.rate),
        origin="simulated",
        angle_measured=True,
    )


def limit_of(rig: Rig) -> float:
    """Return the lowest limit at which a reading of the rig stops, either way [V]; infinite where it has none."""
    ranges = [sensor.converter_range for sensor in rig.parts_of(AmplifiedTorqueSensor)]
    placed = [each for part in rig.parts for each in part.stages(rig) if each.position == PlacedStage.INPUT]
    limits = [each.stage.limit for each in placed if isinstance(each.stage, Clip)]
    return min((*ranges, *limits), default=inf)


def _never_silent(rig: Rig) -> Rig:
    """Return the rig without what loses its signal: lost moments of a recording are filled before anything is compared.

    So a model with them and one without foretell the same of all else, in the same draws of what is random.
    """
    lasting = [part for part in rig.parts if not any(isinstance(each.stage, Dropout) for each in part.stages(rig))]
    return rig if len(lasting) == len(rig.parts) else replace(rig, parts=tuple(lasting))


def simulated_runs(rig: Rig | Sequence[Rig], seen: Sequence[Features], *, seeds: Sequence[int]) -> list[list[Observed]]:
    """Return one simulation per seed of every run, of one rig or of one for each; runs of one length are one batch."""
    rigs = [rig] * len(seen) if isinstance(rig, Rig) else rig
    jobs = [(each, features.observed, seed) for each, features in zip(rigs, seen, strict=True) for seed in seeds]
    alike: dict[tuple[float, float], list[int]] = {}
    for row, (_, observed, _) in enumerate(jobs):
        alike.setdefault((observed.recording.duration, observed.rate), []).append(row)

    def together(group: tuple[tuple[float, float], list[int]]) -> list[Recording]:
        (duration, rate), rows = group
        return simulate_batch(
            [_never_silent(jobs[row][0]).at(jobs[row][1].run) for row in rows], seeds=[jobs[row][2] for row in rows],
            duration=duration, sample_rate=rate, workers=_WORKERS, most_steps=_MOST_STEPS,
        )  # fmt: skip

    with ThreadPoolExecutor(_WORKERS) as pool:
        rows = [row for group in alike.values() for row in group]
        recordings = chain.from_iterable(pool.map(together, alike.items()))
        of_rows = [(each, *jobs[row][:2]) for each, row in zip(recordings, rows, strict=True)]
        copies = dict(zip(rows, pool.map(lambda job: _looked_at(*job), of_rows), strict=True))
    each = len(seeds)
    return [[copies[at] for at in range(row * each, (row + 1) * each)] for row in range(len(seen))]


def expected_by_simulation(rig: Rig, seen: Sequence[Features], *, seeds: Sequence[int]) -> tuple[Expectation, ...]:
    """Return the expected features of every run, measured on simulations."""
    return expected_from(rig, seen, simulated_runs(rig, seen, seeds=seeds))


def expected_from(rig: Rig, seen: Sequence[Features], copies: Sequence[Sequence[Observed]]) -> tuple[Expectation, ...]:
    """Return the expected features of every run from its simulated copies."""

    def of_run(row: int) -> Expectation:
        return _mean(rig, seen[row], copies[row])

    return tuple(parallel_map(of_run, range(len(seen))))


def _mean(rig: Rig, seen: Features, copies: Sequence[Observed]) -> Expectation:
    spread = expected(rig, seen)
    turning = [turns_back(copy) for copy in copies]
    if seen.turning is not None:
        # a copy whose motor is held fast does not turn back, and has no blocks
        looks = [_features(copy, seen) for copy, back in zip(copies, turning, strict=True) if back]
        beside = [_beside_the_twin(rig, look) for look in looks]
        return replace(spread, turning=spread.turning + np.mean(beside, axis=0)) if beside else spread
    copies = [copy for copy, back in zip(copies, turning, strict=True) if not back]
    if not copies:  # all of them turned back, as a torque too large for the drive makes them
        return spread
    chances = [ChanceOfLoad.of(rig, copy) for copy in copies]
    quiet = [_features(chance.quieted(copy), seen) for chance, copy in zip(chances, copies, strict=True)]
    power = spread.power
    if seen.power.size:
        usual = [
            chance.usual(_features(copy, seen), spread) if chance.drawn else still.power
            for chance, copy, still in zip(chances, copies, quiet, strict=True)
        ]
        power = _mean_power(usual, otherwise=power)
    squares, level = _beyond(rig, seen, quiet)
    return replace(
        spread,
        power=power,
        amplitude=np.sqrt(np.maximum(spread.amplitude**2 + squares, 0.0)),
        variance=amplitude_variance(seen, floor_of(seen, power)),
        level=spread.level + level,
    )


def _features(copy: Observed, seen: Features) -> Features:
    # a steady run is the same all along, so all of it counts
    whole = seen.observed.steady and seen.turning is None
    return features(copy, seen.places, held=None if whole else seen.held, unknown=seen.unknown)


def _beyond(rig: Rig, seen: Features, quiet: Sequence[Features]) -> tuple[Floats, Floats]:
    """Return by how much the squares of the lines and the mean torque of quiet copies differ from what the twin says.

    Stretch by stretch, of a steady run over all of them: which place shows a line that stands beside another, and where
    a zero has drifted to, differs from stretch to stretch, and the twin knows it.

    Returns
    -------
    squares : ndarray, shape (stretches, places) or (places,)
        [(N m)^2].
    level : ndarray, shape (parts,) or ()
        [N m].
    """
    twins = [expected(rig, copy) for copy in quiet]
    beneath = [(1 - twin.load_share) * twin.power for twin in twins]
    if seen.power.size:
        power = _mean_power([copy.power for copy in quiet], otherwise=beneath[0])
        beneath = [power] * len(quiet)
    squares = [
        np.abs(copy.amplitude) ** 2 - 2 * amplitude_variance(copy, floor) - twin.amplitude**2
        for copy, floor, twin in zip(quiet, beneath, twins, strict=True)
    ]
    levels = [copy.level - twin.level for copy, twin in zip(quiet, twins, strict=True)]
    if not seen.observed.steady:
        return np.nan_to_num(np.mean(squares, axis=0)), np.asarray(np.mean(levels, axis=0))
    every = np.concatenate(squares)
    shown = np.isfinite(every)
    mean = np.where(shown, every, 0.0).sum(axis=0) / np.maximum(shown.sum(axis=0), 1)
    return np.asarray(mean), np.asarray(np.mean(np.concatenate(levels)))


def _beside_the_twin(rig: Rig, copy: Features) -> Floats:
    """Return by how much the blocks of a copy differ from the twin's.

    Lines differ in phase from copy to recording and are projected out of both. Of the slow torque, which steps where
    the shaft turns back, that would take a part which is not the recording's: the twin's is taken off before.
    """
    blocks, slow = copy.turning, expected(rig, copy).turning
    assert blocks is not None
    assert slow is not None
    return blocks.without_lines(blocks.torque - slow)


def _mean_power(of_copies: Sequence[Floats], *, otherwise: Floats) -> Floats:
    """Mean over the copies; where lines leave no bin, what the twin says."""
    mean = np.mean(of_copies, axis=0)
    return np.asarray(np.where(np.isfinite(mean), mean, otherwise))
