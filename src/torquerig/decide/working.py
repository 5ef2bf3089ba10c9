"""Everything that is worked out of a case, once, for all that tell it: text, page, workbook."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from torquerig.decide.case import MatrixCase
from torquerig.decide.convergence import Convergence, converge, cycles
from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Decision, SelectionChart, eliminate
from torquerig.decide.flips import CommonFlip, FlipScore, FlipWeight, common_flip, flip_scores, nearest_flips
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.computed_sheets import computed_book, survivors
from torquerig.decide.missing import MissingFact, missing_facts
from torquerig.decide.near_miss import NearMiss, near_misses
from torquerig.decide.pareto import Dominance, dominance
from torquerig.decide.pugh import DatumSweep, PughResult, pugh, sweep_datums
from torquerig.decide.robustness import Acceptability, robustness
from torquerig.decide.strength import Strength, strength, strength_from_cost
from torquerig.decide.verdict import MatrixVerdict, verdict_of


@dataclass(frozen=True, kw_only=True)
class WorkedOut:
    """The three methods on one matrix, and how sure the answer is.

    Parameters
    ----------
    chart, near
        Elimination, and who failed it by a hair.
    rated : DecisionMatrix
        Those that no demand eliminates (all, where that would leave nobody); what follows is of these, except Pugh.
    pareto : Dominance
    pugh, convergence, sweep, circles
        Against the stated datum, until a datum stands, against every datum, and wins that run round.
    overall : KesselringResult
    strength : Strength or None
        Where technical criteria are weighed, and economic ones too or costs are stated.
    acceptability : mapping of str to Acceptability
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
    sweep: DatumSweep
    circles: tuple[tuple[str, ...], ...]
    overall: KesselringResult
    strength: Strength | None
    acceptability: Mapping[str, Acceptability]
    weight_flips: tuple[FlipWeight, ...]
    score_flips: tuple[FlipScore, ...]
    common: CommonFlip | None
    missing: tuple[MissingFact, ...]
    verdict: MatrixVerdict
    findings: tuple[Finding, ...]

    @property
    def eliminated(self) -> tuple[str, ...]:
        """Those that a demand takes out of the rating."""
        return tuple(name for name in self.case.matrix.alternatives if name not in self.rated.alternatives)


def work_out(case: MatrixCase) -> WorkedOut:
    """Return elimination, Pugh and Kesselring of a case with verdict, open questions and lints."""
    matrix, rated = case.matrix, survivors(case.matrix)
    chart, sweep = eliminate(matrix), sweep_datums(matrix)
    overall = kesselring(rated, profile=case.profile)
    found = robustness(rated, profile=case.profile, doubt=case.doubt, draws=case.draws, seed=case.seed)
    nobody = len(chart.with_decision(Decision.ELIMINATE)) == len(matrix.alternatives)
    rivals = len(rated.alternatives) > 1
    return WorkedOut(
        case=case,
        chart=chart,
        near=near_misses(chart),
        rated=rated,
        pareto=dominance(rated),
        pugh=pugh(matrix, case.datum),
        convergence=converge(matrix, case.datum),
        sweep=sweep,
        circles=cycles(sweep),
        overall=overall,
        strength=_strength(rated, case),
        acceptability=found,
        weight_flips=nearest_flips(overall) if rivals else (),
        score_flips=flip_scores(overall) if rivals else (),
        common=common_flip(overall) if rivals else None,
        missing=missing_facts(matrix, profile=case.profile),
        verdict=verdict_of(chart, None if nobody else overall, found),
        findings=audit(computed_book(case)),
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
