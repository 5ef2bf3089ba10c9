"""Where samples were written twice or lost, or the signal jumps: the moments about it, which are bridged as lost ones.

A step from one sample to the next has a spectrum that falls by 6 dB an octave and fills the bands above what the shafts
pass on; bridged over some milliseconds it stays below them.
"""

from __future__ import annotations

from collections.abc import Iterable

from torquerig.recordings.recording import Recording

_EITHER_SIDE = 0.0015  # [s]


def seams(samples: Iterable[int], recording: Recording) -> list[tuple[int, int]]:
    """Return the moments about the first samples after a jump: first sample and one past the last of each."""
    reach = max(round(_EITHER_SIDE * recording.sample_rate), 1)
    return [(max(at - reach, 0), min(at + reach, recording.samples)) for at in samples]
