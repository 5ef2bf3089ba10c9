"""All lints over all tables of one decision."""

from __future__ import annotations

from collections.abc import Callable

from torquerig.decide.lints.baseline import baseline_without_rank, one_baseline_only, plus_against_having_baseline
from torquerig.decide.lints.discrimination import rows_all_minus, rows_without_difference
from torquerig.decide.lints.duplication import correlated_rows, identical_rows
from torquerig.decide.lints.finding import Finding
from torquerig.decide.lints.goal import goal_without_criterion
from torquerig.decide.lints.names import (
    nearly_same_names,
    same_rating_judged_differently,
    several_names,
    unmatched_names,
)
from torquerig.decide.lints.polarity import polarity_against_the_name, polarity_unclear
from torquerig.decide.lints.price import price_in_technical_rating
from torquerig.decide.lints.rank_checks import conventions_differ, ranks_follow_no_convention, tied_ranks_differ
from torquerig.decide.lints.requirements import wish_used_as_requirement, wish_worded_requirement
from torquerig.decide.lints.sums import products_do_not_follow, sums_do_not_follow
from torquerig.decide.lints.ties import winners_tie
from torquerig.decide.lints.unknowns import unknown_counted_as_zero, unknown_passed_as_yes
from torquerig.decide.lints.weights import weights_not_one
from torquerig.decide.matrix_io.matrix_table import MatrixTable, TableSet

TableLint = Callable[[MatrixTable, TableSet], list[Finding]]
SetLint = Callable[[TableSet], list[Finding]]

TABLE_LINTS: tuple[TableLint, ...] = (
    weights_not_one,
    sums_do_not_follow,
    products_do_not_follow,
    tied_ranks_differ,
    ranks_follow_no_convention,
    plus_against_having_baseline,
    baseline_without_rank,
    unknown_counted_as_zero,
    unknown_passed_as_yes,
    rows_without_difference,
    rows_all_minus,
    identical_rows,
    correlated_rows,
    wish_used_as_requirement,
    wish_worded_requirement,
    polarity_unclear,
    polarity_against_the_name,
    winners_tie,
    nearly_same_names,
    goal_without_criterion,
    price_in_technical_rating,
    same_rating_judged_differently,
)
SET_LINTS: tuple[SetLint, ...] = (one_baseline_only, conventions_differ, several_names, unmatched_names)


def audit(table_set: TableSet) -> tuple[Finding, ...]:
    """Return the findings of the tables of ``table_set``, table by table, then those between tables."""
    within = [finding for table in table_set.audited for lint in TABLE_LINTS for finding in lint(table, table_set)]
    between = [finding for lint in SET_LINTS for finding in lint(table_set)]
    return (*within, *between)
