"""The matrices of a page, computed in the browser: the same numbers as the engine of torquerig.decide."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from torquerig.decide.cell import Cell, Override
from torquerig.decide.criterion import Better, Criterion, Indifference, Kind, Requirement, ValueFunction
from torquerig.decide.eliminate import eliminate
from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.matrix_file import read_matrix
from torquerig.reporting.matrix.page import matrix_page
from torquerig.reporting.moving.matrix_model import case_model, study_model
from torquerig.study.scoring import combinations, criteria_matrix, decide

EXAMPLE = read_matrix(Path(__file__).resolve().parents[3] / "scenarios" / "matrix_example.yaml")
SLIDE_TO_ZERO = """(place) => {
  const slider = document.querySelector(place);
  slider.value = 0;
  slider.dispatchEvent(new Event('input'));
}"""
SAME = 1e-9  # [1] digits of a double, after sums of some ten terms


@pytest.fixture(scope="module")
def page_file(tmp_path_factory):
    file = tmp_path_factory.mktemp("matrix") / "matrix.html"
    file.write_text(matrix_page(analyse_matrix(EXAMPLE)), encoding="utf-8")
    return file


def solved(shown, model):
    return shown.js("(text) => solveMatrices(JSON.parse(text))", json.dumps(model))


def random_case(rng):
    """Intervals, unknown cells, cells set by hand, all three directions, requirements with and without a question."""
    alternatives = tuple(f"a{at}" for at in range(rng.integers(2, 7)))
    criteria = tuple(_criterion(rng, at) for at in range(rng.integers(2, 6)))
    cells = {(name, one.name): _cell(rng) for name in alternatives for one in criteria}
    matrix = DecisionMatrix(alternatives=alternatives, criteria=criteria, cells=cells)
    return replace(EXAMPLE, matrix=matrix, baseline=alternatives[0], cost=None, draws=50)


def _criterion(rng, at):
    better = Better(rng.choice(["more", "less", "band"]))
    points = np.sort(rng.uniform(EXAMPLE.profile.p_min, EXAMPLE.profile.p_max, 4))
    if better is Better.LESS:
        points = points[::-1]
    if better is Better.BAND:
        points = points[[0, 3, 2, 1]]
    low, high = np.sort(rng.uniform(0, 10, 2))
    limit = Requirement(
        low=low if rng.random() < 0.5 else None, high=high + 3, in_question="why" * int(rng.random() < 0.3)
    )
    return Criterion(
        name=f"c{at}", better=better, band=(3.0, 6.0) if better is Better.BAND else None,
        weight=0.0 if at and rng.random() < 0.2 else float(rng.uniform(0.1, 1)),
        kind=Kind(rng.choice(["technical", "economic"])),
        indifference=Indifference(absolute=float(rng.choice([0, 0.5])), relative=float(rng.choice([0, 0.1, 0.4]))),
        value=ValueFunction(tuple(zip(np.sort(rng.uniform(0, 10, 4)).tolist(), points.tolist(), strict=True))),
        requirement=limit if rng.random() < 0.6 else None,
    )  # fmt: skip


def _cell(rng):
    value, low, high = (float(one) for one in np.sort(rng.uniform(0, 10, 3))[[1, 0, 2]])
    hand = EXAMPLE.profile.p_min + 1.0
    return [
        Cell(value=value), Cell(value=value, low=low, high=high), Cell(low=low, high=high), Cell(),
        Cell(value=value, by_hand=Override(reason="seen", points=hand)),
        Cell(by_hand=Override(reason="seen", value=2.0)),
    ][rng.choice(6, p=[0.35, 0.2, 0.15, 0.1, 0.1, 0.1])]  # fmt: skip


def same_as_engine(found, worked):
    case, overall = worked.case, worked.overall
    names = case.matrix.alternatives
    assert [names[row] for row in found["rows"]] == list(overall.alternatives)
    for key, array in (("low", overall.total_low), ("high", overall.total_high), ("total", overall.total)):
        assert found["overall"][key] == pytest.approx(array.tolist(), abs=SAME)
    assert found["overall"]["share"] == pytest.approx(overall.share.tolist(), abs=SAME)
    points = np.array(found["overall"]["points"])
    for at, array in enumerate((overall.low, overall.high, overall.middle)):
        assert points[..., at] == pytest.approx(array, abs=SAME)
    assert found["overall"]["ranks"] == overall.ranks.tolist()
    assert [found["overall"]["range"][end] for end in ("best", "worst")] == [one.tolist() for one in overall.rank_range]
    same_chart(found, worked.chart)
    assert found["pugh"]["signs"] == [[str(sign) for sign in worked.pugh.signs(name)] for name in names]
    assert (found["pugh"]["netLow"], found["pugh"]["netHigh"]) == (
        worked.pugh.net_low.tolist(),
        worked.pugh.net_high.tolist(),
    )
    assert [found["pugh"]["range"][end] for end in ("best", "worst")] == [
        one.tolist() for one in worked.pugh.rank_range
    ]
    if worked.strength is None:
        assert not (found["technical"] and found["economic"])
        return
    for ours, theirs in ((found["technical"]["share"], worked.strength.technical.value),
                         (found["economic"]["value"], worked.strength.economic.value),
                         (found["economic"]["low"], worked.strength.economic.low),
                         (found["economic"]["high"], worked.strength.economic.high)):  # fmt: skip
        assert ours == pytest.approx(theirs.tolist(), abs=SAME)


def same_chart(found, chart):
    assert [one["marks"] for one in found["chart"]] == [
        [str(mark) for mark in row.marks.values()] for row in chart.rows
    ]
    assert [one["decision"] for one in found["chart"]] == [str(row.decision) for row in chart.rows]


def test_forty_random_matrices_have_the_numbers_of_the_engine(open_page, page_file):
    shown, rng = open_page(page_file), np.random.default_rng(7)
    for case in (EXAMPLE, *(random_case(rng) for _ in range(40))):
        worked = analyse_matrix(case)
        same_as_engine(solved(shown, case_model(case)), worked)


def test_a_study_with_other_weights_limits_and_points_has_the_numbers_of_the_engine(open_page, page_file, runs):
    shown, rng = open_page(page_file), np.random.default_rng(11)
    for _ in range(12):
        edited = _edited(runs, rng)
        decided, made = decide(edited), combinations(edited)
        matrix = criteria_matrix(edited, made)
        drives = {one.name: one.drive.candidate.name for one in made}
        found = solved(shown, study_model(decided.requirements, matrix, baseline=decided.baseline, drive_of=drives))
        same_chart(found, eliminate(decided.requirements))
        assert [matrix.alternatives[row] for row in found["rows"]] == list(decided.overall.alternatives)
        assert found["overall"]["share"] == pytest.approx(decided.overall.share.tolist(), abs=SAME)
        assert found["overall"]["ranks"] == decided.overall.ranks.tolist()
        assert [matrix.alternatives[found["rows"][at]] for at in found["ranked"]] == list(decided.ranked())
        assert found["pugh"]["netLow"] == decided.pugh.net_low.tolist()
        assert found["technical"]["share"] == pytest.approx(decided.technical.share.tolist(), abs=SAME)
        assert found["economic"]["value"] == pytest.approx(decided.economic.share.tolist(), abs=SAME)


def _edited(runs, rng):
    settings, share = runs.study.settings, rng.uniform(0.5, 1)
    criteria = {
        name: row.model_copy(update={
            "weight": float(rng.uniform(0.05, 1)),
            "points": {value: 1 + (points - 1) * float(share) for value, points in row.points.items()},
        })
        for name, row in settings.criteria.items()
    }  # fmt: skip
    torque = settings.requirements["continuous torque"].model_copy(update={"min": float(rng.uniform(1, 7))})
    requirements = {**settings.requirements, "continuous torque": torque}
    changed = settings.model_copy(update={"criteria": criteria, "requirements": requirements})
    return replace(runs, study=replace(runs.study, settings=changed))


def test_a_slider_ranks_anew_and_reset_goes_back(open_page, study_file, decided):
    shown = open_page(study_file)
    shown.unfold()
    winner = "document.getElementById('matrix-winner').innerText"
    stated = shown.js(winner)
    assert decided.ranked()[0] in stated
    for name in ("new parts", "price"):
        shown.js(SLIDE_TO_ZERO, f"[aria-label='weight of {name}']")
    without = replace(decided.matrix, criteria=tuple(
        replace(one, weight=0.0) if one.name in ("new parts", "price") else one for one in decided.matrix.criteria
    ))  # fmt: skip
    found = kesselring(without)
    best = found.alternatives[int(np.argmax(found.total))]
    assert best != decided.ranked()[0]
    assert best in shown.js(winner)
    assert shown.js("document.querySelector('#live-ranking tbody th').innerText") == best
    shown.page.click("#matrix-reset")
    assert shown.js(winner) == stated


def test_a_field_that_cannot_be_used_says_why_and_keeps_the_last_result(open_page, study_file):
    shown = open_page(study_file)
    shown.unfold()
    before = shown.js("document.getElementById('live-ranking').innerText")
    shown.page.fill("[aria-label='points of reading error at 0.05']", "1.2")
    field = shown.page.locator("[aria-label='points of reading error at 0.05']")
    assert field.get_attribute("aria-invalid") == "true"
    assert field.get_attribute("title") == "less is better, so the points may not rise"
    assert shown.js("document.getElementById('live-ranking').innerText") == before


def test_a_limit_eliminates_and_says_so(open_page, study_file):
    shown = open_page(study_file)
    shown.unfold()
    shown.page.fill("[aria-label='at least of continuous torque']", "100")
    assert shown.js("document.getElementById('matrix-winner').innerText") == "No alternative meets these requirements."
    rows = "[...document.querySelectorAll('#live-elimination tbody tr')]"
    decisions = shown.js(f"{rows}.map((row) => row.lastElementChild.innerText)")
    assert set(decisions) == {"eliminate"}


RATIO = """(text) => {
  document.getElementById('try').open = true;
  const slider = document.querySelector('#matrix-controls input[aria-label^="ratio"]');
  const texts = ['all', ...ratiosOf(torquerigMatrices.state.model.groups)];
  slider.value = texts.indexOf(text);
  slider.dispatchEvent(new Event('input'));
  const names = [...document.querySelectorAll('#live-ranking tbody th')].map((one) => one.innerText);
  return [texts, names, document.getElementById('matrix-winner').innerText];
}"""


def test_a_slider_picks_a_ratio_that_the_study_computed(open_page, study_file):
    shown = open_page(study_file)
    texts, every, winner = shown.js(RATIO, "all")
    assert texts[:2] == ["all", "5:1"]
    assert "With ratio" not in winner
    _, names, winner = shown.js(RATIO, "5:1")
    assert names == [one for one in every if "5:1 |" in one]
    assert f"With ratio 5:1: {names[0]}, T/T_max" in winner
    shown.page.click("#matrix-reset")
    assert "With ratio" not in shown.js("document.getElementById('matrix-winner').innerText")
