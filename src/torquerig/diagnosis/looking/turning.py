"""The torque of a run that turns back, block by block, with the lines of the shafts projected out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.motor_angle import smoothed_speed
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

STEPS = 4
_BLOCK = 0.02  # [s] from one to the next, long against the first mode, short against a reversal
_SPACINGS = 2  # of a block's length: under a Hann window it then weighs little beyond its neighbours' middles
_POINTS = 64  # of a block, at which the lines are followed
_RIDGE = 1e-12  # of what a line weighs: blocks that weigh nothing leave no line undetermined
_FEW, _MANY = 0.5, 3.1  # [1/rev of the motor] few loads come in fewer pulses or in more
_WIDE = 1e-3  # singular values below this share of the largest carry no line


@dataclass(frozen=True)
class Turning:
    """Means of one run over blocks that overlap by half, under a Hann window each.

    A line that passes a resonance has no one size and phase over the run, so projecting it out leaves some of it; the
    window leaves a thousandth of what turns five times in a block, and nothing of 50 Hz.

    Parameters
    ----------
    size : int
        Samples from one block to the next, half a block's length.
    start : ndarray, shape (blocks,)
        First sample of each block.
    course : ndarray, shape (steps,)
        Speed of the motor [rad/s] over the whole run, ``STEPS`` to a block from the first sample on.
    first : float
        Torque at the first step [N m].
    torque, speed, acceleration : ndarray, shape (blocks,)
        [N m]; of the motor [rad/s], [rad/s^2].
    lines : ndarray, shape (blocks, dimensions)
        Orthonormal columns that span what lines of any size and phase can do to the blocks.
    """

    size: int
    start: NDArray[np.int64]
    course: Floats
    first: float
    torque: Floats
    speed: Floats
    acceleration: Floats
    lines: Floats

    @property
    def length(self) -> int:
        """Samples of a block."""
        return _SPACINGS * self.size

    def mean_of(self, course: Floats) -> Floats:
        """Return the weighted mean over each block of values that hold from one step of the course to the next."""
        first = np.round(self.start * STEPS / self.size).astype(int)
        weights = _weights(_SPACINGS * STEPS)
        index = np.minimum(first[:, None] + np.arange(weights.size), course.size - 1)
        return np.asarray(course[index] @ weights)

    def without_lines(self, blocks: Floats, spread: Floats | float = 1.0) -> Floats:
        """Return the part of ``blocks`` that no line can make, in units of the spread of each."""
        weights = np.broadcast_to(1 / np.asarray(spread), blocks.shape)
        lines, weighted = self.lines * weights[:, None], blocks * weights
        gram = lines.T @ lines
        gram[np.diag_indices_from(gram)] *= 1 + _RIDGE
        return np.asarray(weighted - lines @ np.linalg.solve(gram, lines.T @ weighted))


def turns_back(observed: Observed) -> bool:
    """Whether the motor runs both ways in this run."""
    return smoothed_speed.turns_back(observed.speed)


def block_size(observed: Observed) -> int:
    """Return how many samples make a block of this run."""
    return max(1, round(_BLOCK * observed.rate))


def turning(
    observed: Observed, places: Sequence[Place], *, held: bool | None, unknown: Sequence[Place] = ()
) -> Turning:
    """Return the blocks of the stretches that fits may see (``held`` False), may not see (True), or all (None).

    Blocks hold whole periods of 50 Hz, and of few other tones: those are to be taken out before. Lines of ``unknown``
    cause may be a load's, which opposes the motion whichever way it goes, and so may what stands on slow known ones.
    """
    size = block_size(observed)
    length = _SPACINGS * size
    starts = np.concatenate([
        np.arange(stretch.start, stretch.stop - length + 1, size)
        for stretch in observed.stretches
        if held is None or stretch.held == held
    ])  # fmt: skip
    middles = starts + length // 2
    ends = observed.speed[np.minimum(starts + length, observed.speed.size - 1)]
    loads = [place for place in places if place.domain == "order" and (place in unknown or _FEW <= place.at <= _MANY)]
    columns = np.hstack([
        waves_in_blocks(observed, starts, [place.at for place in places if place.domain == "order"]),
        waves_in_blocks(observed, starts, [place.at for place in loads], both_ways=True),
    ])  # fmt: skip
    steps = np.arange(0, observed.speed.size, size / STEPS).astype(int)
    return Turning(
        size=size,
        start=starts,
        course=observed.speed[steps],
        first=float(observed.torque[: max(1, size // STEPS)].mean()),
        torque=observed.torque[starts[:, None] + np.arange(length)] @ _weights(length),
        speed=observed.speed[middles],
        acceleration=(ends - observed.speed[starts]) * observed.rate / length,
        lines=orthonormal(columns),
    )


def waves_in_blocks(
    observed: Observed, starts: NDArray[np.int64], orders: Sequence[float], *, both_ways: bool = False
) -> Floats:
    """Return the means over the blocks of a cosine and a sine of each motor order, shape (blocks, 2 orders).

    ``both_ways`` where they oppose the motion whichever way it goes.
    """
    length = _SPACINGS * block_size(observed)
    points, weights = starts[:, None] + ((np.arange(_POINTS) + 0.5) * length / _POINTS).astype(int), _weights(_POINTS)
    angle = observed.angle[points]
    way = np.sign(observed.speed[points]) if both_ways else 1.0
    waves = [(way * np.exp(1j * at * angle)) @ weights for at in orders]
    columns = [part for wave in waves for part in (wave.real, wave.imag)]
    return np.array(columns).T.reshape(starts.size, len(columns))


def _weights(count: int) -> Floats:
    """Return Hann's weights of so many even parts of a block, at the middle of each, their sum 1."""
    weights = np.sin(np.pi * (np.arange(count) + 0.5) / count) ** 2
    return np.asarray(weights / weights.sum())


def orthonormal(columns: Floats) -> Floats:
    """Return orthonormal columns that span what ``columns`` do, less what carries nothing."""
    if columns.shape[1] == 0:
        return columns
    left, sizes, _ = np.linalg.svd(columns, full_matrices=False)
    return np.asarray(left[:, sizes > _WIDE * sizes[0]])
