"""Every cell can be followed from the catalog to the verdict, and edits to what they did."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.decide.cell import Cell, Origin, Override
from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.certainty_text import ranking_changes_text, trace_text
from torquerig.decide.matrix_io.matrix_file import read_matrix
from torquerig.decide.trace import all_traces, trace
from torquerig.decide.version_comparison import ranking_changes
from torquerig.errors import UnknownNameError

CASE = replace(read_matrix(Path(__file__).resolve().parents[2] / "scenarios" / "matrix_example.yaml"), draws=500)
PAIR = ("servo A", "speed reserve")


def with_cell(cell, pair=PAIR):
    return analyse_matrix(replace(CASE, matrix=replace(CASE.matrix, cells={**CASE.matrix.cells, pair: cell})))


def test_the_way_runs_from_the_catalog_to_the_verdict():
    origin = Origin(name="maximum speed of HDS6A-0104A", shown="5000 rpm", evidence="DOC", source="data sheet p. 2")
    cell = Cell(
        low=1.2, high=1.4, origins=(origin,), metric="maximum speed / needed speed", evidence="CALC", source="run 7"
    )
    found = trace(with_cell(cell), *PAIR)
    labels = [label for label, _ in found.steps]
    assert labels == ["catalog", "metric", "value", "missing", "requirement", "Pugh", "value function", "points",
                      "weight", "total", "decision"]  # fmt: skip
    steps = dict(found.steps)
    assert steps["catalog"] == "maximum speed of HDS6A-0104A: 5000 rpm [DOC], from data sheet p. 2"
    assert steps["value"] == "1.2..1.4 [CALC], from run 7"
    assert steps["points"] == "2.8, from 2.2 to 3.4, on the scale 1 to 5"
    assert steps["weight"] == "0.2 as given, 0.200 normalised: adds 0.56 to T"
    assert "verdict" in steps["decision"]


def test_an_override_is_shown_as_one_and_beside_what_it_replaced():
    worked = with_cell(Cell(value=1.5, by_hand=Override(points=2.0, reason="the drive derates when hot")))
    steps = dict(trace(worked, *PAIR).steps)
    assert steps["value"] == "1.5"
    assert steps["set by hand"] == "2 points, because: the drive derates when hot"
    assert steps["points"].startswith("2, ")
    row, column = worked.overall.alternatives.index(PAIR[0]), worked.overall.criteria.index(PAIR[1])
    assert worked.overall.low[row, column] == worked.overall.high[row, column] == 2.0
    assert worked.overall.by_hand == {PAIR: "the drive derates when hot"}


def test_every_cell_has_its_way_and_an_eliminated_one_says_why_it_ends():
    worked = analyse_matrix(CASE)
    found = all_traces(worked)
    assert len(found) == len(CASE.matrix.alternatives) * len(CASE.matrix.criteria)
    assert all(len(one.steps) >= 3 for one in found)
    out = dict(trace(worked, "induction motor B", "price").steps)
    assert out["points"] == "none: a requirement eliminates it"
    assert out["decision"] == "eliminate"
    skipped = dict(trace(worked, "induction motor B", "speed reserve").steps)
    assert skipped["requirement"].endswith("not tested, an earlier requirement eliminates it")
    assert trace_text(found[0]).splitlines()[0] == "present drive / servo drive"


def test_a_name_that_is_not_there_gets_its_close_matches():
    worked = analyse_matrix(CASE)
    with pytest.raises(UnknownNameError, match="did you mean 'servo A'"):
        trace(worked, "servo B", "price")
    with pytest.raises(UnknownNameError, match="did you mean 'price'"):
        trace(worked, "servo A", "prise")


def test_an_edited_weight_and_baseline_are_told_with_what_they_did():
    changed = tuple(replace(one, weight=4.0) if one.name == "price" else one for one in CASE.matrix.criteria)
    after = replace(CASE, baseline="servo A", matrix=replace(CASE.matrix, criteria=changed))
    found = ranking_changes(analyse_matrix(CASE), analyse_matrix(after))
    assert {(one.key, one.before, one.after) for one in found.edits} == {
        ("baseline", "present drive", "servo A"), ("criteria.price.weight", 0.2, 4.0),
    }  # fmt: skip
    assert (found.winners_before, found.winners_after) == (("servo A",), ("present drive",))
    assert found.reversed_pairs == (("servo A", "present drive"),)
    assert "present drive now ranks above servo A" in ranking_changes_text(found)
    assert "nothing was changed" in ranking_changes_text(ranking_changes(analyse_matrix(CASE), analyse_matrix(CASE)))


@settings(max_examples=15, deadline=None)
@given(st.sampled_from(CASE.matrix.alternatives))
def test_removing_an_alternative_overtakes_nobody(gone):
    left = [name for name in CASE.matrix.alternatives if name != gone]
    fewer = replace(CASE, matrix=CASE.matrix.only(alternatives=left), baseline=left[0])
    assert ranking_changes(analyse_matrix(CASE), analyse_matrix(fewer)).reversed_pairs == ()
