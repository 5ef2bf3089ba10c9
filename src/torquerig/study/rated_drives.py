"""The drives of a study, each with its best filter, rated by criteria and requirements."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from torquerig.decide.best_shares import sampled_totals
from torquerig.decide.eliminate import Decision, eliminate
from torquerig.decide.kesselring import TEACHING, KesselringResult, kesselring
from torquerig.decide.robustness import RankAcceptability
from torquerig.decide.value_of_information import MissingFact, missing_facts
from torquerig.decide.verdict import MatrixVerdict, verdict_of

if TYPE_CHECKING:
    from torquerig.decide.best_shares import SampledTotals
    from torquerig.decide.matrix import DecisionMatrix
    from torquerig.study.scoring import Decided


@dataclass(frozen=True, kw_only=True)
class RatedDrives:
    """Drives of a study and the confidence that one of them is best.

    Parameters
    ----------
    matrix : DecisionMatrix
        The best combination of each drive against the criteria, together with the requirements on its drive.
    overall : KesselringResult
        Of ``matrix``.
    combinations : mapping of str to RankAcceptability
        Of every combination of these drives, by what is drawn.
    verdict : MatrixVerdict
        Of the drives: share of samples in which a drive is best with any of its filters, and open requirements on it.
    """

    matrix: DecisionMatrix
    overall: KesselringResult
    combinations: Mapping[str, RankAcceptability]
    verdict: MatrixVerdict

    @cached_property
    def facts(self) -> tuple[MissingFact, ...]:
        """Every missing value that a maker can state, those first that improve the choice most."""
        found = missing_facts(self.matrix, profile=self.overall.profile)
        return tuple(one for one in found if self.matrix.cell(*one.cells[0]).unknown_reason)


def samples_of(decided: Decided, names: Sequence[str]) -> SampledTotals:
    """Return the Monte Carlo samples of these combinations, for :func:`rated_drives` of any of them."""
    return sampled_totals(decided.matrix.only(alternatives=names))


def rated_drives(decided: Decided, names: Iterable[str], samples: SampledTotals | None = None) -> RatedDrives:
    """Return the rated drives of these combinations; at least one. ``samples`` are theirs, where they are known.

    Each drive is represented by its best filter. Its share of samples is that of all its filters among ``names``, which
    use the same samples.
    """
    drives = _by_drive(decided, tuple(names))
    listed = [name for names_of in drives.values() for name in names_of]
    matrix = with_requirements(decided, tuple(drives))
    overall = kesselring(matrix, profile=TEACHING)
    found = (samples_of(decided, listed) if samples is None else samples).best(listed)
    shares = {name: _of_drives(one, drives) for name, one in found.items()}
    return RatedDrives(
        matrix=matrix,
        overall=overall,
        combinations=found,
        verdict=verdict_of(eliminate(matrix), overall, shares),
    )


def feasible_combinations(decided: Decided) -> tuple[str, ...]:
    """Return the combinations whose drive no requirement eliminates, the best first."""
    out = set(decided.chart.with_decision(Decision.ELIMINATE))
    return tuple(name for name in decided.ranked() if decided.alternatives[name].drive.candidate.name not in out)


def with_requirements(decided: Decided, names: tuple[str, ...]) -> DecisionMatrix:
    """Return the matrix of criteria of these combinations, together with the requirements on their drives."""
    known = {criterion.name for criterion in decided.matrix.criteria}
    requirements = {
        one.name: f"{one.name} (required)" if one.name in known else one.name for one in decided.requirements.criteria
    }
    cells = {
        (name, shown): decided.requirements.cell(decided.alternatives[name].drive.candidate.name, requirement)
        for name in names
        for requirement, shown in requirements.items()
    }
    kept = decided.matrix.only(alternatives=names)
    return replace(
        kept,
        criteria=(
            *kept.criteria,
            *(replace(one, name=requirements[one.name]) for one in decided.requirements.criteria),
        ),
        cells={**kept.cells, **cells},
    )


def _by_drive(decided: Decided, names: tuple[str, ...]) -> dict[str, list[str]]:
    """Return the combinations of each drive by the best of them, the best drive first."""
    by_drive: dict[str, list[str]] = {}
    for name in (one for one in decided.ranked() if one in set(names)):
        by_drive.setdefault(decided.alternatives[name].drive.candidate.name, []).append(name)
    return {listed[0]: listed for listed in by_drive.values()}


def _of_drives(found: RankAcceptability, drives: Mapping[str, list[str]]) -> RankAcceptability:
    """Return the share of samples in which each drive is best with any filter, by its best combination."""
    best = [sum(found.best_share(name) for name in listed) for listed in drives.values()]
    rows = [found.alternatives.index(name) for name in drives]
    return replace(found, alternatives=tuple(drives), shares=np.array(best)[:, None], mean_share=found.mean_share[rows])
