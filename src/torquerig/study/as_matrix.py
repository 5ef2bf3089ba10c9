"""A study as a decision matrix: drives with their best filter, criteria and requirements, with all sources."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from torquerig.decide.case import MatrixCase
from torquerig.study.rated_drives import feasible_combinations, with_requirements

if TYPE_CHECKING:
    from torquerig.study.scoring import Decided


def as_matrix(decided: Decided, *, name: str, seed: int) -> MatrixCase:
    """Return the case that ``torquerig matrix`` reads, writes to Excel and evaluates.

    The present combination is the baseline, even where a requirement eliminates it. The share of Monte Carlo samples in
    which a drive is best can differ a little from that of the study, which counts every filter of a drive.
    """
    best: dict[str, str] = {}
    for one in feasible_combinations(decided):
        best.setdefault(decided.alternatives[one].drive.candidate.name, one)
    rows = tuple(dict.fromkeys((*best.values(), decided.baseline)))
    return MatrixCase(matrix=replace(with_requirements(decided, rows), name=name), baseline=decided.baseline, seed=seed)
