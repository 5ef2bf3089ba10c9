"""Runs of one value, and of samples that are not numbers, across the blocks of a recording."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import log

import numpy as np
from numpy.typing import NDArray

KEPT = 1000
"""Most runs of one kind that are kept [1]; further ones are dropped."""


@dataclass(frozen=True, kw_only=True)
class Run:
    """``length`` samples from sample ``first`` on; all of ``value`` where it is a run of one value."""

    first: int
    length: int
    value: float = float("nan")

    @property
    def last(self) -> int:
        """The number of the last sample."""
        return self.first + self.length - 1


@dataclass(frozen=True, kw_only=True)
class Repeats:
    """The runs of one value in a block.

    Parameters
    ----------
    samples, repeats : int
        Number of samples, and number of samples that equal the one before.
    leading, trailing : Run
        At the ends of the block; the same run where all samples are equal.
    longest : Run
    long : tuple of Run
        Runs of eight samples or more, in order, without leading and trailing.
    """

    samples: int
    repeats: int
    leading: Run
    trailing: Run
    longest: Run
    long: tuple[Run, ...]

    @property
    def expected_longest(self) -> float:
        """The expected longest run [samples] where repeats are independent of each other."""
        share = self.repeats / max(self.samples - 1, 1)
        return 1.0 + (log(self.samples * (1 - share) + 1) / -log(share) if 0 < share < 1 else 0.0)

    def stuck(self) -> list[Run]:
        """Return the runs longer than 8 samples and than three times the longest that is expected."""
        least = max(8.0, 3 * self.expected_longest)
        every = {run.first: run for run in (self.leading, *self.long, self.trailing)}
        return [run for _, run in sorted(every.items()) if run.length > least]


def repeats_of(values: NDArray[np.float64], first: int = 0) -> Repeats:
    """Return the runs of one value in ``values``, shape (samples,); ``first`` is the number of its first sample."""
    starts = np.concatenate([[0], np.flatnonzero(values[1:] != values[:-1]) + 1])
    lengths = np.diff(np.append(starts, values.size))

    def run(index: int) -> Run:
        return Run(first=first + int(starts[index]), length=int(lengths[index]), value=float(values[starts[index]]))

    inner = np.flatnonzero(lengths[1:-1] >= 8) + 1
    return Repeats(
        samples=values.size,
        repeats=values.size - starts.size,
        leading=run(0),
        trailing=run(-1),
        longest=run(int(np.argmax(lengths))),
        long=tuple(run(index) for index in inner[:KEPT].tolist()),
    )


def joined_repeats(left: Repeats, right: Repeats) -> Repeats:
    """Return the runs of two consecutive blocks; a run over the seam is one run."""
    same = left.trailing.value == right.leading.value
    seam = replace(left.trailing, length=left.trailing.length + right.leading.length) if same else None
    left_is_one, right_is_one = left.leading.length == left.samples, right.leading.length == right.samples
    inner = [
        run
        for run, inside in (
            (seam, seam is not None and not left_is_one and not right_is_one),
            (left.trailing, seam is None and not left_is_one),
            (right.leading, seam is None and not right_is_one),
        )
        if run is not None and inside and run.length >= 8
    ]
    return Repeats(
        samples=left.samples + right.samples,
        repeats=left.repeats + right.repeats + same,
        leading=seam if seam is not None and left_is_one else left.leading,
        trailing=seam if seam is not None and right_is_one else right.trailing,
        longest=max((left.longest, *([seam] if seam else []), right.longest), key=lambda run: run.length),
        long=(*left.long, *inner, *right.long)[:KEPT],
    )


def not_numbers(values: NDArray[np.float64], first: int = 0) -> tuple[Run, ...]:
    """Return the runs of samples that are NaN or infinite."""
    with np.errstate(over="ignore", invalid="ignore"):
        if np.isfinite(values.sum()):
            return ()
    return tuple(Run(first=first + start, length=length) for start, length in runs_of(~np.isfinite(values)))


def joined_runs(left: tuple[Run, ...], right: tuple[Run, ...]) -> tuple[Run, ...]:
    """Return the runs of two consecutive blocks, with one over the seam as one run."""
    if left and right and left[-1].last + 1 == right[0].first:
        over = replace(left[-1], length=left[-1].length + right[0].length)
        return (*left[:-1], over, *right[1:])
    return (*left, *right)


def runs_of(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first sample and the length of each run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.view(np.int8), [0]])))
    return [(int(start), int(stop - start)) for start, stop in zip(edges[::2], edges[1::2], strict=True)]
