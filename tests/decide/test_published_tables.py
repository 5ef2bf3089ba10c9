"""The published Tables II-VI (sections 4.2.3-4.2.7) recomputed from their cells, and what a broken file says."""

from pathlib import Path

import pytest

from torquerig.decide.eliminate import Decision
from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.lost_cells import lost_cell_values
from torquerig.decide.matrix_io.matrix_report import published_tables_text
from torquerig.decide.matrix_io.published_tables import read_tables, tables_from
from torquerig.decide.matrix_io.recompute import (
    recomputed_chart,
    recomputed_kesselring,
    recomputed_pugh,
    technical_shares,
    undeciding_rows,
    weighted_nets,
)
from torquerig.decide.ranks import competition_ranks, dense_ranks
from torquerig.document import parse_document
from torquerig.errors import InputError

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reference_tables.yaml"
REPORT = Path(__file__).resolve().parents[3] / "shared" / "seed"
CUT = "Table VI, cut at the right"


@pytest.fixture(scope="module")
def book():
    return read_tables(FILE)


def edited(*changes):
    text = FILE.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return tables_from(parse_document(text, FILE))


@pytest.mark.parametrize(
    ("table", "sums", "low", "high", "corrected"),
    [
        ("Table III", [1, 3, 3, 0, 0], [1, 3, 3, 0, 0], [1, 3, 3, 0, 0], [0, 2, 2, -1, 0]),
        ("Table IV", [-3, -1, -1, 1, -1], [-4, -2, -2, 0, -2], [-2, 0, 0, 2, 0], [-3, -1, -1, 0, -1]),
        ("Table V", [-2, 0, 0, -2, 2], [-4, -2, -2, -4, 0], [0, 2, 2, 0, 4], [-3, -1, -1, -3, 1]),
    ],
)
def test_tables_iii_to_v_sections_4_2_4_to_6_give_the_printed_sums(book, table, sums, low, high, corrected):
    result = recomputed_pugh(book.table(table))
    assert result.net_certain.tolist() == [0, *sums]
    assert list(book.table(table).sums) == sums
    assert (result.net_low.tolist(), result.net_high.tolist()) == ([0, *low], [0, *high])
    assert recomputed_pugh(book.table(table), correct_baseline=True).net_certain.tolist() == [0, *corrected]


def test_table_iii_section_4_2_4_ranks_share_ties(book):
    sums = book.table("Table III").sums
    assert competition_ranks(sums).tolist() == [3, 1, 1, 4, 4]
    assert dense_ranks(sums).tolist() == [2, 1, 1, 3, 3]
    assert book.table("Table III").ranks == (2, 1, 1, 4, 3)


@pytest.mark.parametrize("table", ["Table IV", "Table V"])
def test_tables_iv_and_v_print_dense_ranks(book, table):
    assert dense_ranks(book.table(table).sums).tolist() == list(book.table(table).ranks)


def test_table_iv_section_4_2_5_the_baseline_outranks_four_of_five(book):
    assert recomputed_pugh(book.table("Table IV")).ranks.tolist() == [2, 6, 3, 3, 1, 3]


def test_table_ii_section_4_2_3_nobody_survives_the_strict_rule(book):
    sheet = book.table("Table II")
    assert len(recomputed_chart(sheet).with_decision(Decision.ELIMINATE)) == 9
    aside = tuple(row.criterion for row in undeciding_rows(sheet))
    assert aside == ("No gearbox needed", "Shaft adapter not needed")
    loose = recomputed_chart(sheet, without=aside)
    assert loose.with_decision(Decision.PURSUE) == ("HDS6A-0102A", "HDS6A-0104A")
    printed_yes = {name for name, yes in zip(sheet.alternatives, sheet.passed, strict=True) if yes}
    assert set(loose.with_decision(Decision.PURSUE, Decision.OPEN)) == printed_yes


def test_table_vi_section_4_2_7_read_by_columns_gives_only_the_first_sums(book):
    result = recomputed_kesselring(book.table("Table VI"))
    assert result.ideal == pytest.approx(4.25)
    assert result.total == pytest.approx([2.85, 2.45, 1.85])
    assert book.table("Table VI").sums == (2.85, 2.75, 2.15)


def test_table_vi_section_4_2_7_cut_at_the_right_gives_all_sums(book):
    result = recomputed_kesselring(book.table(CUT))
    assert result.total[:3] == pytest.approx([2.85, 2.75, 2.15])
    assert result.share[:3] == pytest.approx([0.671, 0.647, 0.506], abs=5e-4)  # printed to three decimals
    assert (result.total_low[3], result.total_high[3]) == pytest.approx((1.15, 3.35))
    assert result.total_low[3] < book.table(CUT).sums[3] < result.total_high[3]


def test_table_vi_without_the_price_the_first_two_tie_at_0_68(book):
    assert technical_shares(book.table(CUT))[:2] == pytest.approx((0.68, 0.68))


@pytest.mark.parametrize(("lowest", "count"), [(0, 18), (1, 14)])
def test_table_vi_fourth_motor_has_so_many_half_point_fillings(lowest, count):
    # 18 on a scale that starts at 0; the printed scores start at 1, as far as one sees
    profile = Profile(name="half points", p_min=lowest, p_max=5)
    found = lost_cell_values((None, None, None, 2.0), weights=(0.3, 0.1, 0.15, 0.3), total=2.6, profile=profile)
    assert len(found) == count
    assert [one[:3] for one in found if one[1] == 2] == [(3.5, 2, 5), (4, 2, 4), (4.5, 2, 3), (5, 2, 2)]


def test_a_sum_out_of_reach_has_no_filling():
    assert lost_cell_values((None, 2.0), weights=(0.5, 0.5), total=4.0, profile=TEACHING) == ()


def test_the_cells_are_those_of_the_published_text(book):
    texts = sorted(REPORT.glob("*.txt")) if REPORT.is_dir() else []
    if not texts:
        pytest.skip("the published text is not beside this checkout")
    lines = [line.split("\t") for line in texts[0].read_text(encoding="utf-8").splitlines()]
    for name in ("Table III", "Table IV", "Table V"):
        sheet = book.table(name)
        start = next(place for place, line in enumerate(lines) if line[0].startswith(f"{name}:"))
        table = lines[start + 2 : start + 11]
        assert table[0] == ["Motor", "REF", *sheet.alternatives]
        printed = {line[0]: tuple(line[2:]) for line in table[1:]}
        assert {row.criterion: row.entries for row in sheet.rows} == {
            key: cells for key, cells in printed.items() if key not in ("SUM", "Rank")
        }
        assert [int(one) for one in printed["SUM"]] == list(sheet.sums)
        assert [int(one) for one in printed["Rank"]] == list(sheet.ranks)
    sheet = book.table("Table II")
    start = next(place for place, line in enumerate(lines) if line[0].startswith("Table II:"))
    for name, yes, line in zip(sheet.alternatives, sheet.passed, lines[start + 3 : start + 12], strict=True):
        assert line == [name, *sheet.column(name), "Yes" if yes else "No"]


def test_a_missing_cell_is_unknown_and_changes_no_other_column():
    book = edited(("cells: [5, 3, 2, 2]", "cells: [5, ~, 2, 2]"))
    result = recomputed_kesselring(book.table("Table VI"))
    assert (result.total_low[0], result.total_high[0]) == pytest.approx((2.65, 3.05))
    assert result.total[1:] == pytest.approx([2.45, 1.85])


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "weight: 0.3, cells",
            "weight: -0.3, cells",
            r":\d+: tables.4.rows.Operates in optimal RPM range.weight: .*at least 0",
        ),
        (
            "[5, 3.5, 3.5, 2]",
            "[5, 3.5, 9, 2]",
            r"rows.Operates in optimal RPM range.cells: 9 points are outside the scale 1..5",
        ),
        ("[5, 3.5, 3.5, 2]", "[5, 3.5, good, 2]", r"'good' is no number"),
        ('[REF, "0", "0"', '[REF, "x", "0"', r"tables.1.rows.Torque.cells: 'x' is no mark"),
        ('[REF, "0", "0"', '["+", "0", "0"', r"the cell of the baseline is '\+'"),
        ('[REF, "0", "0"', '[REF, "0"', r"5 cells for 6 columns"),
        (
            "baseline: REF",
            "baseline: RFE",
            r"tables.1.baseline: the baseline 'RFE' is not in the table; did you mean 'REF'",
        ),
        ("ideal: Ideal Motor", "ideal: Ideel Motor", r"did you mean 'Ideal Motor'"),
        ("name: Table III", "name: Table II", r"the table 'Table II' occurs twice"),
        ("[REF, HDS5C-102A, HDS6A-104A", "[REF, HDS5C-102A, HDS5C-102A", r"the column 'HDS5C-102A' occurs twice"),
        ("sums: [null, 1,", "sums: [1,", r"tables.1.sums: 5 values for 6 columns"),
        ('proceed: "No"', 'proceed: "maybe"', r"'maybe' is no decision"),
        ("method: pugh", "method: pug", r"tables.1.method: .*'pugh'"),
        ("baseline_has: true", "baseline_hs: true", r"unknown key; did you mean .*'baseline_has'"),
        ("scale: {min: 1, max: 5}", "scale: {min: 5, max: 1}", r"tables.4.scale: .*upwards"),
        ('follows_rating: ["0.5-6 Nm"]', 'follows_rating: ["0.5-6 N"]', r"did you mean '0.5-6 Nm'"),
    ],
)
def test_a_broken_file_is_one_sentence_with_its_place(old, new, said):
    with pytest.raises(InputError, match=said) as raised:
        edited((old, new))
    assert str(raised.value).startswith(f"{FILE}:")
    assert "\n" not in str(raised.value)


def test_all_weights_zero_is_refused():
    text = FILE.read_text(encoding="utf-8")
    for weight in ("0.3", "0.1", "0.15"):
        text = text.replace(f"weight: {weight}\n", "weight: 0\n").replace(f"weight: {weight},", "weight: 0,")
    with pytest.raises(InputError, match="all weights are 0"):
        tables_from(parse_document(text, FILE))


def test_keys_of_earlier_versions_are_read_with_one_notice(capsys):
    text = FILE.read_text(encoding="utf-8")
    old = text.replace("baseline:", "datum:").replace("baseline_has:", "datum_has:")
    assert tables_from(parse_document(old, FILE)) == tables_from(parse_document(text, FILE))
    notice = capsys.readouterr().err
    assert notice.count("\n") == 1
    assert "'datum' is now 'baseline', 'datum_has' is now 'baseline_has'" in notice


WEIGHTED = """
tables:
  - name: drives
    method: pugh
    columns: [belt, gear, direct]
    baseline: belt
    sums: [~, -0.3, 1]
    rows:
      cost: {weight: 20 %, cells: [S, "+", "−−"]}
      noise: {weight: "0,5", cells: [0, "–", 2]}
      mass: {weight: 0.3, cells: [s, s, 1]}
"""


def weighted(old="", new=""):
    assert old in WEIGHTED
    return tables_from(parse_document(WEIGHTED.replace(old, new, 1), FILE))


def test_graded_marks_and_weights_of_a_pugh_row_count_in_a_sum_next_to_the_plain_one():
    (table,) = weighted().tables
    assert (table.column("direct"), table.weights) == (("--", "++", "+"), (0.2, 0.5, 0.3))
    assert recomputed_pugh(table).net_certain.tolist() == [0, 0, 1]
    assert weighted_nets(table).tolist() == [pytest.approx([-0.3, 0.9])] * 3
    shown = published_tables_text(weighted())
    assert "weighted SUM (? left out)" in shown
    assert "the printed sum" not in shown
    wrong = published_tables_text(weighted("~, -0.3, 1", "~, -0.3, 4"))
    assert "direct: the printed sum is 4, the signs give 1, weighted 0.9" in " ".join(wrong.split())


def test_an_unknown_graded_mark_spans_the_grades():
    (table,) = weighted("cells: [s, s, 1]", 'cells: [s, "?", 1]').tables
    low, known, high = weighted_nets(table)
    assert (low[0], known[0], high[0]) == pytest.approx((-0.9, -0.3, 0.3))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("weight: 0.3, ", "", "rows.mass: the weight is missing"),
        ("weight: 0.3", "weight: 30", "rows.mass.weight: 30.0 may be per cent, as '20 %' of 'cost' is"),
        ("weight: 0.3", "weight: much", "rows.mass.weight: 'much' is no clear number; write 20 %, 0.2 or 20"),
        ("[s, s, 1]", "[s, s, 3]", "rows.mass.cells: 3.0 is no mark of this table"),
    ],
)
def test_a_weight_or_mark_that_is_unclear_is_refused_with_its_line(old, new, said):
    with pytest.raises(InputError, match=said):
        weighted(old, new)
