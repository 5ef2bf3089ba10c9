"""All lints over all tables of one decision."""

from __future__ import annotations

from collections.abc import Callable

from torquerig.decide.lints.datum import datum_without_rank, one_datum_only, plus_against_having_datum
from torquerig.decide.lints.demands import wish_used_as_demand, wish_worded_demand
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
from torquerig.decide.lints.sums import products_do_not_follow, sums_do_not_follow
from torquerig.decide.lints.ties import winners_tie
from torquerig.decide.lints.unknowns import unknown_counted_as_zero, unknown_passed_as_yes
from torquerig.decide.lints.weights import weights_not_one
from torquerig.decide.matrix_io.sheet import Book, Sheet

SheetLint = Callable[[Sheet, Book], list[Finding]]
BookLint = Callable[[Book], list[Finding]]

SHEET_LINTS: tuple[SheetLint, ...] = (
    weights_not_one,
    sums_do_not_follow,
    products_do_not_follow,
    tied_ranks_differ,
    ranks_follow_no_convention,
    plus_against_having_datum,
    datum_without_rank,
    unknown_counted_as_zero,
    unknown_passed_as_yes,
    rows_without_difference,
    rows_all_minus,
    identical_rows,
    correlated_rows,
    wish_used_as_demand,
    wish_worded_demand,
    polarity_unclear,
    polarity_against_the_name,
    winners_tie,
    nearly_same_names,
    goal_without_criterion,
    price_in_technical_rating,
    same_rating_judged_differently,
)
BOOK_LINTS: tuple[BookLint, ...] = (one_datum_only, conventions_differ, several_names, unmatched_names)


def audit(book: Book) -> tuple[Finding, ...]:
    """Return what is wrong with the tables of ``book``, table by table, then what is wrong between them."""
    within = [finding for sheet in book.audited for lint in SHEET_LINTS for finding in lint(sheet, book)]
    between = [finding for lint in BOOK_LINTS for finding in lint(book)]
    return (*within, *between)
