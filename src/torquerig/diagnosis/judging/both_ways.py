"""A mode whose own band stays too loud in one run and too quiet in another: it answers what drives it, not noise."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.rig.assembly import Rig

_NARROW = 0.5  # of its middle: a wider stretch of a spectrum is wrong for other reasons


def rings_both_ways(left: Sequence[Mismatch], rig: Rig) -> bool:
    """Whether a mode in the rig leaves the band in which it rings wrong, upwards in a run and downwards in another."""
    return any(_both_ways(left, part.frequency) for part in rig.of_kind("torsional_mode"))


def _both_ways(left: Sequence[Mismatch], frequency: float) -> bool:
    near = [
        each.excess_dB
        for each in left
        if each.domain == "frequency" and each.width < _NARROW * each.at and abs(each.at - frequency) < 0.5 * each.width
    ]
    return min(near, default=0.0) < 0 < max(near, default=0.0)
