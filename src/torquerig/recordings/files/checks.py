"""Checks of a recording: two samples or more, channels of equal length, finite numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.inspection.runs import runs_of
from torquerig.recordings.recording import Recording


def check_lengths(columns: Mapping[str, NDArray[np.float64]], where: str, *, remedy: str = "") -> int:
    """Return the number of samples that all columns have; RecordingError where they differ, or are fewer than two."""
    return check_counts({name: values.size for name, values in columns.items()}, where, remedy=remedy)


def check_counts(lengths: Mapping[str, int], where: str, *, remedy: str = "") -> int:
    """Return the common number of samples of all columns; RecordingError as :func:`check_lengths`."""
    if len(set(lengths.values())) > 1:
        listed = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise RecordingError(
            f"{where}: the channels have unequal numbers of samples ({listed}); "
            f"{remedy or 'cut them to the same span of time'}, or name only those that belong together in the "
            "sidecar's channels"
        )
    samples = next(iter(lengths.values()), 0)
    if samples < 2:
        has = "no samples" if samples == 0 else "one sample"
        raise RecordingError(f"{where}: the recording has {has} and at least 2 are needed; record it again")
    return samples


def check_finite(recording: Recording, *, first: int = 0) -> Recording:
    """Return the recording; RecordingError names channel, count and places of samples that are not finite numbers.

    ``first`` is the number of its first sample, where it is a block of a longer recording.
    """
    for name, channel in recording.channels.items():
        # quick test without extra memory: a finite sum means finite samples
        with np.errstate(over="ignore", invalid="ignore"):
            if np.isfinite(channel.values.sum()):
                continue
        bad = ~np.isfinite(channel.values)
        count = int(np.count_nonzero(bad))
        if count:
            start = first + int(np.argmax(bad))
            raise RecordingError(
                f"{recording.name}: {name} has {count} sample{'s' if count > 1 else ''} not a finite number, the first "
                f"at sample {start} ({start / recording.sample_rate:.6g} s){_listed_runs(bad, first)}; cut the "
                "recording to a span without them, or record it again"
            )
    return recording


def _listed_runs(bad: NDArray[np.bool_], first: int, most: int = 3) -> str:
    runs = runs_of(bad)
    if len(runs) == 1 and runs[0][1] == 1:
        return ""
    spans = [f"{first + start}..{first + start + length - 1}" if length > 1 else f"{first + start}"
             for start, length in runs[:most]]  # fmt: skip
    more = f" and {len(runs) - most} more runs" if len(runs) > most else ""
    return f": samples {', '.join(spans)}{more}"
