"""A study as a matrix of one's own: drives by their best filter, criteria and demands, every origin kept."""

from __future__ import annotations

from dataclasses import replace

from torquerig.decide.case import MatrixCase
from torquerig.study.rated_drives import left_over, with_demands
from torquerig.study.scoring import Decided


def as_matrix(decided: Decided, *, name: str, seed: int) -> MatrixCase:
    """Return the case that ``torquerig matrix`` works out, fills into Excel, and takes edits of.

    The present combination is the datum, even where a demand eliminates it. How often a drive is best can differ a
    little from the study's own figure, which lets every filter of a drive count.
    """
    best: dict[str, str] = {}
    for one in left_over(decided):
        best.setdefault(decided.alternatives[one].drive.candidate.name, one)
    rows = tuple(dict.fromkeys((*best.values(), decided.datum)))
    return MatrixCase(matrix=replace(with_demands(decided, rows), name=name), baseline=decided.datum, seed=seed)
