"""What no recording may have: no or one sample, channels of unequal length, samples that are not numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.signals.recording import Recording


def check_lengths(columns: Mapping[str, NDArray[np.float64]], where: str) -> int:
    """Return the number of samples that all columns have; RecordingError where they differ, or are fewer than two."""
    lengths = {name: values.size for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        listed = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise RecordingError(
            f"{where}: the channels have unequal numbers of samples ({listed}); cut them to the same span of time, "
            "or name only those that belong together in the sidecar's channels"
        )
    samples = next(iter(lengths.values()), 0)
    if samples < 2:
        has = "no samples" if samples == 0 else "one sample"
        raise RecordingError(f"{where}: the recording has {has} and at least 2 are needed; record it again")
    return samples


def check_finite(recording: Recording) -> Recording:
    """Return the recording; RecordingError names channel, count and place of samples that are no finite numbers."""
    for name, channel in recording.channels.items():
        bad = ~np.isfinite(channel.values)
        count = int(np.count_nonzero(bad))
        if count:
            first = int(np.argmax(bad))
            raise RecordingError(
                f"{recording.name}: {name} has {count} sample{'s' if count > 1 else ''} not a finite number, the first "
                f"at sample {first} ({first / recording.sample_rate:.6g} s); cut the recording to a span without them, "
                "or record it again"
            )
    return recording
