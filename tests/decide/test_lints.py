"""Each lint fires on the published tables and falls silent when its cell is mended; none fires on a clean matrix."""

from dataclasses import replace
from pathlib import Path

import pytest

from torquerig.decide.criterion import Better, Kind
from torquerig.decide.lints.audit import SET_LINTS, TABLE_LINTS, audit
from torquerig.decide.lints.duplication import correlated_rows
from torquerig.decide.lints.names import nearly_same_names
from torquerig.decide.lints.polarity import polarity_against_the_name
from torquerig.decide.lints.rank_checks import conventions_differ
from torquerig.decide.lints.requirements import wish_worded_requirement
from torquerig.decide.lints.sums import products_do_not_follow
from torquerig.decide.lints.ties import winners_tie
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, Row, TableSet
from torquerig.decide.matrix_io.published_tables import read_tables, tables_from
from torquerig.document import parse_document

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reference_tables.yaml"


def found_in(table_set):
    return {(finding.lint, finding.table, finding.what) for finding in audit(table_set)}


def after(*changes):
    text = FILE.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return found_in(tables_from(parse_document(text, FILE)))


@pytest.fixture(scope="module")
def published():
    return found_in(read_tables(FILE))


def hits(found, lint, table="", words=""):
    return [what for kind, name, what in found if kind == lint and name.startswith(table) and words in what]


# lint, table, words in the finding, and the change to the file that mends it
CASES = [
    (
        "tied sums, different ranks",
        "Table III",
        "ranks 4 and 3",
        [("ranks: [null, 2, 1, 1, 4, 3]", "ranks: [null, 2, 1, 1, 3, 3]")],
    ),
    (
        "mixed rank conventions",
        "Table III",
        "2 1 1 4 3",
        [("ranks: [null, 2, 1, 1, 4, 3]", "ranks: [null, 2, 1, 1, 3, 3]")],
    ),
    (
        "weights do not sum to 1",
        "Table VI",
        "0.85",
        [("{weight: 0.15, cells: [5, 2, 2, 3], prod", "{weight: 0.3, cells: [5, 2, 2, 3], prod")],
    ),
    (
        "sums that do not follow from the cells",
        "Table VI",
        "ESM0x-401-302",
        [("cells: [5, 4, 3, 2]", "cells: [5, 4, 4, 2]")],
    ),
    (
        "sums that do not follow from the cells",
        "Table VI",
        "ESM01-38-153-20",
        [("cells: [5, 4, 3, 2]", "cells: [5, 4, 4, 3]")],
    ),
    (
        "sums that do not follow from the cells",
        "Table VI",
        "belongs to no column",
        [("spare_sums: [2.6]", "spare_sums: []")],
    ),
    ("+ against a baseline that has it", "Table III", "can use same sensor", [(", baseline_has: true", "")]),
    (
        "+ against a baseline that has it",
        "Table IV",
        "'ESI MAX-101-302'",
        [('sensor: {cells: [REF, "-", "-", "-", "+",', 'sensor: {cells: [REF, "-", "-", "-", "0",')],
    ),
    (
        "rows that do not discriminate",
        "Table III",
        "3 of 6",
        [('Speed: {cells: [REF, "+", "+",', 'Speed: {cells: [REF, "0", "+",')],
    ),
    (
        "rows that do not discriminate",
        "Table V",
        "4 of 6",
        [
            (
                'improvement: {cells: [REF, "?", "?", "?", "?", "?"]}',
                'improvement: {cells: [REF, "?", "?", "?", "?", "+"]}',
            )
        ],
    ),
    ("? counted as 0", "Table IV", "-3 instead of -4..-2", [("sums: [null, -3, -1, -1, 1, -1]", "sums: []")]),
    ("? counted as 0", "Table V", "2 instead of 0..4", [("sums: [null, -2, 0, 0, -2, 2]", "sums: []")]),
    (
        "? passed as yes",
        "Table II",
        "5 of the 5",
        [
            (
                'ESM013B-152-304:   {cells: ["+", "+", "+", "?", "-", "?"], proceed: "Yes"}',
                'ESM013B-152-304:   {cells: ["+", "+", "+", "?", "-", "?"], proceed: "No"}',
            )
        ],
    ),
    (
        "all have -",
        "Table II",
        "Shaft adapter",
        [
            (
                'HDS6A-0104A:       {cells: ["+", "+", "+", "?", "-"',
                'HDS6A-0104A:       {cells: ["+", "+", "+", "?", "+"',
            )
        ],
    ),
    (
        "a wish used as a requirement",
        "Table II",
        "No gearbox",
        [('HDS60-0102A:       {cells: ["+", "+", "+", "?"', 'HDS60-0102A:       {cells: ["+", "+", "+", "-"')],
    ),
    (
        "the goal has no criterion",
        "Table VI",
        "torque ripple",
        [
            (
                "Inertia: {weight: 0.15, cells: [5, 2, 2, 3], prod",
                "Low Cogging: {weight: 0.15, cells: [5, 2, 2, 3], prod",
            )
        ],
    ),
    (
        "the goal is unknown",
        "Table V",
        "for all alternatives",
        [
            (
                'improvement: {cells: [REF, "?", "?", "?", "?", "?"]}',
                'improvement: {cells: [REF, "?", "?", "?", "?", "+"]}',
            )
        ],
    ),
    (
        "identical rows",
        "Table IV",
        "'Torque' and 'can use same sensor'",
        [('Torque: {cells: [REF, "-", "-", "-", "+",', 'Torque: {cells: [REF, "-", "-", "-", "0",')],
    ),
    ("price inside the technical rating", "Table VI", "'Price'", [(", kind: economic}", "}")]),
    ("same rating, different marks", "Table II", "200 W", [('follows_rating: ["0.5-6 Nm"]', "follows_rating: []")]),
    ("the baseline is not ranked", "Table IV", "4 of 5", [("ranks: [null, 3, 2, 2, 1, 2]", "ranks: []")]),
    ("one thing, several names", "Table II", "HDS6A-104A (Table III", [("HDS6A-104A,", "HDS6A-0104A,")]),
    ("unclear polarity", "Table II", "Need A series adapter", [("Need A series adapter]", "A series adapter fits]")]),
    (
        "unclear polarity",
        "Table VI",
        "modifications needed",
        [("Wear rig modifications needed:", "Few modifications:")],
    ),
    (
        "tie for the first rank",
        "Table III",
        "'ESI MAX-401-302'",
        [('cells: [REF, "0", "0", "0", "-"', 'cells: [REF, "0", "+", "0", "-"')],
    ),
    (
        "the baseline never changes",
        "Table III, Table IV, Table V",
        "REF",
        [("baseline: REF", "baseline: REF\n    reading_of: elsewhere")],
    ),
]


@pytest.mark.parametrize(("lint", "table", "words", "mend"), CASES, ids=[f"{case[0]}, {case[1]}" for case in CASES])
def test_the_finding_is_there_and_goes_when_the_cell_is_mended(published, lint, table, words, mend):
    assert hits(published, lint, table, words)
    assert not hits(after(*mend), lint, table, words)


def test_the_five_renamed_motors_are_found(published):
    assert len(hits(published, "one thing, several names")) == 5


def test_a_name_without_its_alias_comes_from_nowhere():
    found = after(("  - names: [HDS6A-0102A, HDS5C-102A]", "  - names: [HDS6A-0102A, other]"))
    assert hits(found, "unknown name", "Table III", "HDS5C-102A")


def test_the_proposed_reading_of_table_vi_is_not_blamed(published):
    assert not [finding for finding in published if "cut at the right" in finding[1]]


def test_every_finding_says_where_why_and_what_to_do():
    for finding in audit(read_tables(FILE)):
        assert finding.what
        assert finding.why
        assert finding.remedy
        assert finding.place.startswith(f"{FILE}:")


def points_table(**changed):
    rows = (
        Row(criterion="ripple", weight=0.6, entries=(5.0, 3.0, 1.0, 2.0), products=(3.0, 1.8, 0.6, 1.2)),
        Row(criterion="speed", weight=0.4, entries=(2.0, 4.0, 3.0, 5.0)),
    )
    table = MatrixTable(
        name="clean", method=Method.KESSELRING, alternatives=tuple("abcd"), rows=rows, sums=(3.8, 3.4, 1.8, 3.2),
        ranks=(1, 2, 4, 3), ideal_sum=5.0,
    )  # fmt: skip
    return replace(table, **changed)


def pugh_table(**changed):
    rows = (
        Row(criterion="ripple", entries=("+", "+", "-", "0"), baseline_has=False),
        Row(criterion="same sensor", entries=("S", "-", "S", "S"), baseline_has=True),
    )
    table = MatrixTable(
        name="signs", method=Method.PUGH, alternatives=tuple("abcd"), rows=rows, baseline="ref", sums=(1, 0, -1, 0)
    )
    return replace(table, **changed)


def chart_table(**changed):
    rows = (
        Row(criterion="servo", entries=("+", "+", "+", "+", "-")),
        Row(criterion="fits", entries=("+", "+", "+", "+", "+"), follows_rating=True),
    )
    table = MatrixTable(
        name="chart", method=Method.ELIMINATION, alternatives=tuple("abcde"), rows=rows,
        passed=(True, True, True, True, False),
    )  # fmt: skip
    return replace(table, **changed)


def test_clean_tables_have_no_findings():
    table_set = TableSet(
        tables=(chart_table(), pugh_table(), points_table()), goal="ripple", goal_words=("ripple",), ratings={"a": "1"}
    )
    assert audit(table_set) == ()
    assert len(TABLE_LINTS) + len(SET_LINTS) == 26


def test_rows_that_rise_together_are_found_over_four_alternatives_and_not_over_three():
    first = Row(criterion="size", weight=0.5, entries=(1.0, 2.0, 3.0, 5.0), kind=Kind.TECHNICAL)
    second = Row(criterion="weight", weight=0.5, entries=(1.0, 2.0, 4.0, 5.0))
    table = points_table(rows=(first, second), sums=(), ranks=())
    (finding,) = correlated_rows(table, TableSet(tables=(table,)))
    assert "r = 0.96 over 4" in finding.what  # 9 / sqrt(8.75 * 10)
    falling = replace(second, entries=(5.0, 4.0, 2.0, 1.0))
    unknown = replace(second, entries=(1.0, "?", 4.0, 5.0))
    for other in (falling, unknown):
        assert not correlated_rows(replace(table, rows=(first, other)), TableSet(tables=(table,)))


@pytest.mark.parametrize(
    ("name", "better", "found"),
    [
        ("ripple", Better.MORE, True),
        ("ripple reduction", Better.MORE, False),
        ("torque reserve", Better.LESS, True),
        ("price", Better.LESS, False),
        ("rotor inertia", Better.LESS, False),
        ("price", None, False),
    ],
)
def test_a_name_that_says_the_opposite_of_its_direction_is_found(name, better, found):
    table = points_table(rows=(Row(criterion=name, weight=1.0, entries=(1.0, 2.0, 3.0, 4.0), better=better),))
    assert bool(polarity_against_the_name(table, TableSet(tables=(table,)))) is found


def test_a_requirement_that_calls_itself_a_wish_is_found_only_where_it_eliminates():
    row = Row(criterion="quiet", entries=("+", "+", "+", "+", "-"), purpose="should be pleasant in the room")
    (finding,) = wish_worded_requirement(chart_table(rows=(row,)), TableSet(tables=()))
    assert "'quiet' eliminates 'e', but is worded as a wish ('should')" in finding.what
    assert not wish_worded_requirement(chart_table(rows=(replace(row, entries=("+",) * 5),)), TableSet(tables=()))
    assert not wish_worded_requirement(chart_table(rows=(replace(row, purpose="must not ring"),)), TableSet(tables=()))


def test_a_tie_of_unknowns_is_no_tie_in_front():
    known = Row(criterion="x", weight=1.0, entries=(4.0, 4.0, 1.0, 2.0))
    for entries, tie in (((3.0, 3.0, 3.0, 3.0), True), (("?", "?", 3.0, 3.0), False)):
        table = points_table(rows=(known, replace(known, criterion="y", entries=entries)), sums=(), ranks=())
        assert bool(winners_tie(table, TableSet(tables=(table,)))) is tie


def test_names_that_differ_only_in_spelling_are_found():
    table = points_table(alternatives=("HDS6A-0104A", "hds6a 104A", "HDS6A-0102A", "x"))
    (finding,) = nearly_same_names(table, TableSet(tables=(table,)))
    assert finding.what == "'HDS6A-0104A' and 'hds6a 104A' differ only in their spelling"


def test_a_wrong_product_is_found():
    wrong = replace(points_table().rows[0], products=(3.0, 1.8, 0.6, 1.5))
    (finding,) = products_do_not_follow(points_table(rows=(wrong,)), TableSet(tables=()))
    assert "d: 0.6 x 2 is 1.2, printed is 1.5" in finding.what


def test_tables_that_rank_by_different_conventions_are_found():
    dense = pugh_table(name="dense", ranks=(1, 2, 3, 2))
    competition = pugh_table(name="competition", ranks=(1, 2, 4, 2))
    assert conventions_differ(TableSet(tables=(dense, competition)))
    assert not conventions_differ(TableSet(tables=(dense, dense)))


def test_a_wrong_net_sum_is_found_but_one_that_a_question_mark_allows_is_not():
    unknown = Row(criterion="price", entries=("?", "?", "?", "?"))
    table = pugh_table(rows=(*pugh_table().rows, unknown), sums=(2, 5, 0, 1))
    found = hits(found_in(TableSet(tables=(table,))), "sums that do not follow from the cells")
    assert found == ["b: the printed sum is 5, the signs give -1..1"]
