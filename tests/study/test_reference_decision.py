"""A published decision made again: nothing hard-coded, each difference with its reason, the same page each time."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.decide.criterion import Better, Criterion, Requirement
from torquerig.decide.matrix_io.matrix_table import Method
from torquerig.decide.verdict import Certainty
from torquerig.document import parse_document, read_document
from torquerig.errors import TorquerigError
from torquerig.metrics.figure import Figure
from torquerig.metrics.motor_facts import FACT_UNITS, motor_facts
from torquerig.reporting.reference_report.decision_page import reference_decision_markdown, reference_decision_page
from torquerig.reporting.reference_report.decision_trace import trace_chapter
from torquerig.study.reference_decision.cell_comparison import compared_table
from torquerig.study.reference_decision.computed import computed_table
from torquerig.study.reference_decision.decision import reference_decision
from torquerig.study.reference_decision.known_figures import Known
from torquerig.study.reference_decision.plan import read_plan
from torquerig.study.reference_decision.reasons import (
    Cause,
    Compared,
    reason_of_points,
    reason_of_requirement,
    reason_of_sign,
)
from torquerig.study.results import StudyRuns
from torquerig.study.verdict import verdict

CATALOG = load_catalog(shipped_folder())
SHIPPED = shipped_scenarios() / "reference_decision.yaml"
TABLES = """
tables:
  - name: Signs
    method: pugh
    columns: [REF, HDS6A-104A]
    baseline: REF
    rows:
      Speed: {cells: [REF, "+"]}
      Price: {cells: [REF, "-"], kind: economic}
    sums: [null, 0]
    ranks: [null, 1]
  - name: Points
    method: kesselring
    scale: {min: 1, max: 5}
    columns: [Ideal, HDS6A-0104A]
    ideal: Ideal
    rows:
      Speed: {weight: 0.8, cells: [5, 2]}
    sums: [4.0, 1.6]
"""
PLAN = """
published: tables.yaml
scenario: {scenario}
draws: 0
duration: 0.5 s
tables:
  Signs:
    gearbox: reference-5-1
    rows:
      Speed: {{metric: speed_use, unit: "1", better: band, band: [0.3, 1.0], purpose: of rated speed}}
      Price: {{metric: price, unit: EUR, better: less, purpose: what is new}}
  Points:
    gearbox: reference-5-1
    also: [REF]
    rows:
      Speed: {{metric: speed_use, unit: "1", better: band, band: [0.3, 1.0], points: {{0: 1, 0.3: 5}}, purpose: use}}
    missing:
      ripple: {{metric: disturbance, unit: N*m, better: less, points: {{0: 5, 1: 1}}, purpose: the goal}}
"""


@pytest.fixture(scope="module")
def shipped():
    return read_plan(read_document(SHIPPED), CATALOG)


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    folder = tmp_path_factory.mktemp("plan")
    (folder / "tables.yaml").write_text(TABLES)
    text = PLAN.format(scenario=shipped_scenarios() / "wear_rig.yaml")
    return reference_decision(read_plan(parse_document(text, folder / "plan.yaml"), CATALOG), workers=1)


def elimination(plan, book=None):
    """Return Table II, which needs no run."""
    runs = StudyRuns(study=plan.study, drives=(), mean_load=1.0, occupancy_percent=5.0, particle_size=5e-4,
                     output_speed=20.9)  # fmt: skip
    plan = plan if book is None else replace(plan, book=book)
    return compared_table(computed_table(plan, "Table II", Known(runs)), plan.book, agree_within=0.5)


def test_the_shipped_plan_runs_what_its_tables_name(shipped):
    assert set(shipped.study.settings.motors) == {
        "bldc-12n14p", "HDS6A-0102A", "HDS6A-0104A", "ESM06X-401-302", "ESM04X-101-302", "ESM013B-152-304"}  # fmt: skip
    assert set(shipped.study.settings.gearboxes) == {"spur-2.5-1", "reference-5-1", "economy-20-1"}
    assert set(shipped.tables) == {sheet.name for sheet in shipped.book.audited}


def test_table_two_from_the_catalog(shipped):
    """The audit of the reference report: 200 W and 100 W fail 6 N m at 5:1, a motor of 400 W reaches it."""
    table = elimination(shipped)
    cells = {(cell.row, cell.alternative): cell for cell in table.cells}
    assert cells["0.5-6 Nm", "HDS6A-0102A"].reason.cause is Cause.READING  # 0.637 N m lies in 0.5-6 at the motor
    assert cells["0.5-6 Nm", "ESM04X-101-302"].reason.cause is Cause.VALUE  # 0.318 N m in neither
    assert cells["0.5-6 Nm", "HDS6A-0104A"].reason.cause is Cause.AGREES
    assert cells["No gearbox needed", "INNOMOTICS GP-71M"].computed == "-"  # at most 2.6 N m
    shaft = cells["Shaft adapter not needed", "HDS6A-0104A"].reason
    assert shaft.cause is Cause.MISSING
    assert "shaft diameter of bldc-12n14p" in shaft.sentence
    assert all(cell.reason.sentence for cell in table.differing)
    assert {finding.lint for finding in table.findings} >= {"? passed as yes", "a wish used as a requirement"}


def test_published_marks_are_read_and_not_known(shipped):
    sheet = shipped.book.table("Table II")
    turned = tuple(replace(row, entries=tuple("-" for _ in row.entries)) for row in sheet.rows)
    others = (replace(one, rows=turned) if one is sheet else one for one in shipped.book.tables)
    table = elimination(shipped, replace(shipped.book, tables=tuple(others)))
    assert {cell.published for cell in table.cells} == {"-"}
    assert {cell.computed for cell in table.cells} == {cell.computed for cell in elimination(shipped).cells}
    assert not [cell for cell in table.differing if cell.computed == "-"]


MORE = Criterion(name="x", unit="N*m", better=Better.MORE, purpose="as read", requirement=Requirement(low=6.0))


@pytest.mark.parametrize(
    ("changed", "cause"),
    [
        ({"published": "0", "computed": "S"}, Cause.AGREES),
        ({"published": "+", "computed": "?"}, Cause.MISSING),
        ({"published": "?", "computed": "-"}, Cause.VALUE),
        ({"published": "+", "computed": "-", "same_gearbox": "+"}, Cause.BASELINE),
        ({"published": "+", "computed": "-", "otherwise": "+", "other_purpose": "as else"}, Cause.READING),
        ({"published": "+", "computed": "S"}, Cause.BASELINE),
        ({"published": "+", "computed": "-", "polarity": True}, Cause.POLARITY),
        ({"published": "0", "computed": "-"}, Cause.VALUE),
    ],
)
def test_why_a_sign_differs(changed, cause):
    cell = Compared(
        figure=Figure(low=1.0, high=2.0, missing="inertia of A"), baseline=Figure(value=1.5), criterion=MORE, **changed
    )
    found = reason_of_sign(cell)
    assert found.cause is cause
    assert bool(found.sentence) is (cause is not Cause.AGREES)
    if cause is Cause.MISSING:
        assert "inertia of A is missing" in found.sentence


def test_why_a_demand_and_points_differ():
    cell = Compared(published="+", computed="-", figure=Figure(value=3.0), criterion=MORE)
    assert reason_of_requirement(cell).sentence == "The value is 3 N*m, and required is >= 6 N*m."
    points = replace(cell, published=3.5)
    assert reason_of_points(points, low=2.0, high=3.1, within=0.5).cause is Cause.AGREES
    assert "gives 2..2.9 points" in reason_of_points(points, low=2.0, high=2.9, within=0.5).sentence


def test_facts_have_their_units():
    facts = motor_facts(CATALOG.motor("HDS6A-104A"), CATALOG.gearbox("reference-5-1"), present=CATALOG.motor("REF"))
    assert {name: figure.unit for name, figure in facts.items()} == dict(FACT_UNITS)
    assert facts["rated_speed"].value == 3000  # to the last bit, a limit of 3000 rpm asks for it
    assert facts["output_torque"].value == pytest.approx(1.27 * 5 * 0.97)
    assert facts["inertia_at_output"].low == pytest.approx(0.17e-4 * 25)
    own = motor_facts(CATALOG.motor("REF"), CATALOG.gearbox("reference-5-1"), present=CATALOG.motor("REF"))
    assert own["same_shaft"].value == 1


def test_a_small_decision_and_its_answer(small):
    signs, points = small.tables
    assert {cell.row: cell.computed for cell in signs.cells} == {"Speed": "S", "Price": "-"}
    assert signs.totals["computed net, ? as + or -"] == ("-1",)
    assert points.cells[0].published == "2"
    assert points.cells[0].reason.cause is Cause.VALUE
    assert points.rated is not None
    assert points.rated.weights.tolist() == pytest.approx([0.8, 0.2])  # what print lacks to 1
    answer = small.answer
    assert answer.published == "HDS6A-0104A"
    assert answer.published_text == "Points, 1.6 of 4 printed"
    assert answer.keeps
    assert str(answer.overall.certainty) in answer.sentences()[1]
    assert 0 <= answer.keeps_share <= 1
    assert set(answer.table) == {
        "Points computed with its printed weights", "Points computed with the missing 0.2 on ripple",
        "Points computed with the missing 0.2 on ripple, new motors only"}  # fmt: skip


def test_the_answer_uses_the_words_of_the_study_and_keeps_its_demands_open(small):
    """``compare`` on the same drives: one engine, so one word, one chance and one open demand."""
    answer, of_study = small.answer, verdict(small.decided)
    assert answer.overall.certainty is Certainty.OPEN
    assert of_study.certainty is answer.overall.certainty_if_met
    assert answer.overall.best_shares == of_study.best_shares
    assert answer.conditions == ("whether bldc-12n14p is a servo motor",)
    assert of_study.facts[0].sentence().startswith("ask the maker whether bldc-12n14p is a servo motor: if not, ")


def test_every_computed_cell_leads_back_to_the_catalog(small):
    tables = {table.caption: table for table in trace_chapter(small).tables}
    rows = {(row[0].text, row[1].text): row for row in tables["Points: calculation of the computed marks"].rows}
    known = CATALOG.motor("HDS6A-0104A").rated_speed
    assert rows["Speed", "HDS6A-0104A"][2].text == (
        f"rated speed of HDS6A-0104A: {known.shown()} [{known.evidence}], from {known.source}"
    )
    values = {row[1].text for row in tables["The catalog values of each simulated drive"].rows}
    assert {"rotor inertia of HDS6A-0104A", "stiffness of reference-5-1"} <= values


def test_the_page_is_the_same_each_time_and_asks_nobody(small):
    again = reference_decision(small.plan, workers=2)
    assert reference_decision_page(again) == reference_decision_page(small)
    page, text = reference_decision_page(small), reference_decision_markdown(small)
    assert "<script" not in page
    assert "http" not in page
    for cell in (cell for one in small.tables for cell in one.differing):
        assert cell.reason.sentence in text.replace("\\", "")
    assert small.tables[0].table.sheet.method is Method.PUGH


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        ("  Signs:\n", "  Sings:\n", "unknown published table 'Sings'"),
        ("      Price: {metric", "      Prize: {metric", "has no row 'Prize'"),
        ("metric: price, unit: EUR", "metric: price, unit: SEK", "price has the unit 'EUR'"),
        ("metric: price,", "metric: prize,", "'prize' is no metric"),
        ("gearbox: reference-5-1", "gearbox: reference-6-1", "reference-6-1"),
        ("also: [REF]", "also: [REV]", "REV"),
        ("points: {0: 1, 0.3: 5}, ", "", "a rated criterion needs points"),
        ("draws: 0", "draws: many", "draws"),
    ],
)
def test_bad_plans_are_refused_with_their_place(tmp_path, before, after, told):
    (tmp_path / "tables.yaml").write_text(TABLES)
    text = PLAN.format(scenario=shipped_scenarios() / "wear_rig.yaml")
    assert before in text
    with pytest.raises(TorquerigError) as raised:
        read_plan(parse_document(text.replace(before, after, 1), tmp_path / "plan.yaml"), CATALOG)
    assert told in str(raised.value)
    assert "plan.yaml:" in str(raised.value)


def test_the_command_refuses_before_it_simulates(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("there.html").write_text("kept")
    for name, told in (("there.html", "is there already"), ("page.pdf", ".html or .md")):
        with pytest.raises(SystemExit, match="2"):
            main(["reference-decision", str(SHIPPED), "--out", name])
        assert told in capsys.readouterr().err
    assert Path("there.html").read_text() == "kept"
