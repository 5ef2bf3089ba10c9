"""All results of one matrix: elimination, Pugh, Kesselring, Monte Carlo shares, verdict and lints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.decide.convergence import Convergence, converge, cycles
from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Decision, SelectionChart, eliminate
from torquerig.decide.flips import CommonFlip, FlipScore, FlipWeight, common_flip, flip_scores, nearest_flips
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.lints.audit import audit
from torquerig.decide.matrix_io.computed_tables import computed_tables, survivors
from torquerig.decide.near_miss import NearMiss, near_misses
from torquerig.decide.pareto import Dominance, dominance
from torquerig.decide.pugh import BaselineSweep, PughResult, pugh, sweep_baselines
from torquerig.decide.robustness import RankAcceptability, robustness
from torquerig.decide.strength import Strength, strength, strength_from_cost
from torquerig.decide.value_of_information import MissingFact, missing_facts
from torquerig.decide.verdict import MatrixVerdict, verdict_of

if TYPE_CHECKING:
    from torquerig.decide.case import MatrixCase
    from torquerig.decide.lints.finding import Finding
    from torquerig.decide.matrix import DecisionMatrix


@dataclass(frozen=True, kw_only=True)
class MatrixAnalysis:
    """The results of the three methods on one matrix, and how certain the answer is.

    Parameters
    ----------
    chart, near
        Elimination, and the alternatives that failed it narrowly.
    rated : DecisionMatrix
        The alternatives that no requirement eliminates (all, if that would leave none). All results below except Pugh
        are of these.
    pareto : Dominance
    pugh, convergence, sweep, cycles
        Against the stated baseline, until a baseline is stable, against every baseline, and cycles of wins.
    overall : KesselringResult
    strength : Strength or None
        Where technical criteria have weights, and economic ones have weights or costs are stated.
    acceptability : mapping of str to RankAcceptability
    weight_flips, score_flips, common
        Empty or None where there is one alternative.
    missing : tuple of MissingFact
    verdict : MatrixVerdict
    findings : tuple of Finding
    """

    case: MatrixCase
    chart: SelectionChart
    near: tuple[NearMiss, ...]
    rated: DecisionMatrix
    pareto: Dominance
    pugh: PughResult
    convergence: Convergence
    sweep: BaselineSweep
    cycles: tuple[tuple[str, ...], ...]
    overall: KesselringResult
    strength: Strength | None
    acceptability: Mapping[str, RankAcceptability]
    weight_flips: tuple[FlipWeight, ...]
    score_flips: tuple[FlipScore, ...]
    common: CommonFlip | None
    missing: tuple[MissingFact, ...]
    verdict: MatrixVerdict
    findings: tuple[Finding, ...]

    @property
    def eliminated(self) -> tuple[str, ...]:
        """The alternatives that a requirement eliminates."""
        return tuple(name for name in self.case.matrix.alternatives if name not in self.rated.alternatives)


def analyse_matrix(case: MatrixCase) -> MatrixAnalysis:
    """Return elimination, Pugh and Kesselring of a case with verdict, open questions and lints."""
    matrix, rated = case.matrix, survivors(case.matrix)
    chart, sweep = eliminate(matrix), sweep_baselines(matrix)
    overall = kesselring(rated, profile=case.profile)
    found = robustness(rated, profile=case.profile, uncertainty=case.uncertainty, draws=case.draws, seed=case.seed)
    none_meets = len(chart.with_decision(Decision.ELIMINATE)) == len(matrix.alternatives)
    missing = missing_facts(matrix, profile=case.profile)
    several = len(rated.alternatives) > 1
    return MatrixAnalysis(
        case=case,
        chart=chart,
        near=near_misses(chart),
        rated=rated,
        pareto=dominance(rated),
        pugh=pugh(matrix, case.baseline),
        convergence=converge(matrix, case.baseline),
        sweep=sweep,
        cycles=cycles(sweep),
        overall=overall,
        strength=_strength(rated, case),
        acceptability=found,
        weight_flips=nearest_flips(overall) if several else (),
        score_flips=flip_scores(overall) if several else (),
        common=common_flip(overall) if several else None,
        missing=missing,
        verdict=verdict_of(
            chart, None if none_meets else overall, found, facts=tuple(one.fact for one in missing if one.decisive)
        ),
        findings=audit(computed_tables(case)),
    )


def _strength(matrix: DecisionMatrix, case: MatrixCase) -> Strength | None:
    kinds = {criterion.kind for criterion in matrix.criteria if criterion.weight > 0}
    if Kind.TECHNICAL not in kinds:
        return None
    technical = kesselring(matrix.only(kind=Kind.TECHNICAL), profile=case.profile)
    if case.cost is not None:
        costs = {name: matrix.cell(name, case.cost.criterion) for name in matrix.alternatives}
        return strength_from_cost(technical, costs, permissible=case.cost.permissible)
    if Kind.ECONOMIC not in kinds:
        return None
    return strength(technical, kesselring(matrix.only(kind=Kind.ECONOMIC), profile=case.profile))
