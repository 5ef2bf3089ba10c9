"""Rivals without a name: what describes a mismatch and claims no cause, so that no name wins for want of another.

A named effect that fits no better than a description is not named; the description then says where the mismatch stands.
"""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.neutral import noise_hump
from torquerig.rig.assembly import Rig


def in_words(candidate: Candidate, rig: Rig) -> str:
    """Return what a description came to in a fitted rig."""
    part = rig.part(candidate.parts[0].name)
    return noise_hump.in_words(part) if isinstance(part, mechanisms.NoiseHump) else candidate.description


def descriptions(case: Case) -> Iterator[Candidate]:
    """Yield what describes the case's mismatch."""
    yield from noise_hump.propose(case)
