"""The slider of a sweep: it stops at computed points, and figures, reading, ranking and matrices follow it."""

from dataclasses import replace

import pytest

from torquerig.reporting.study.report import write_study_report
from torquerig.study.sweep import SweptPoint, least_error


def scaled(runs, factor):
    """The same drives with other reading errors."""

    def chain(one):
        error = one.truth_error
        ends = {name: factor * getattr(error, name) for name in ("value", "low", "high")}
        return replace(one, truth_error=replace(error, **ends))

    drives = (replace(one, chains={name: chain(each) for name, each in one.chains.items()}) for one in runs.drives)
    return replace(runs, drives=tuple(drives))


@pytest.fixture(scope="module")
def swept(runs):
    return tuple(SweptPoint({"load.occupancy": text}, scaled(runs, size)) for text, size in (("5 %", 1), ("21 %", 4)))


@pytest.fixture(scope="module")
def swept_file(runs, decided, answer, swept, tmp_path_factory):
    folder = tmp_path_factory.mktemp("swept")
    return write_study_report(runs, decided, answer, folder / "report", swept=swept)[0]


MOVED = """async () => {
  const slider = document.querySelector('#sweep-controls input');
  document.getElementById('try').open = true;
  slider.value = 1;
  slider.dispatchEvent(new Event('input'));
  const shown = [...document.querySelectorAll('#sweep .point')].filter((one) => !one.hidden);
  const { state } = torquerigMatrices, solved = solveMatrices(state.model);
  const baseline = solved.rows.indexOf(state.model.baseline);
  return {
    steps: [slider.min, slider.max, slider.step], said: slider.getAttribute('aria-valuetext'),
    points: shown.map((one) => one.dataset.text), sentence: shown[0].querySelector('p').innerText,
    share: solved.overall.share, names: solved.rows.map((row) => state.model.rows[row].name),
    point: document.getElementById('matrix-point').innerText, baseline,
  };
}"""


def test_answer_reading_and_matrices_follow_the_slider(open_page, swept_file, swept):
    shown = open_page(swept_file)
    found = shown.js(MOVED)
    assert found["steps"] == ["0", "1", "1"]
    assert found["said"] == "21 %"
    assert found["points"] == ["load.occupancy 21 %"]
    assert found["sentence"] == swept[1].verdict.answer.sentences[0]
    assert "load.occupancy 21 %" in found["point"]
    overall = swept[1].decided.overall
    known = dict(zip(overall.alternatives, overall.share.tolist(), strict=True))
    shares = dict(zip(found["names"], found["share"], strict=True))
    assert known == pytest.approx({name: shares[name] for name in known}, abs=1e-9)
    assert shown.errors == []


def test_set_weights_stay_when_the_slider_moves(open_page, swept_file):
    shown = open_page(swept_file)
    weight = shown.js(
        "() => { torquerigMatrices.changed(() => { torquerigMatrices.state.model.criteria[0].weight = 0.9; }); }"
    )
    shown.js(MOVED)
    weight = shown.js("torquerigMatrices.state.model.criteria[0].weight")
    assert weight == 0.9


def test_the_reading_of_a_point_is_drawn_when_its_turn_comes(open_page, swept_file):
    shown = open_page(swept_file)
    assert shown.js("plotsOnPage.has('plot-sweep_reading_2')") is False
    shown.js(MOVED)
    shown.js("document.querySelector('#sweep_reading_2').scrollIntoView()")
    shown.js("new Promise((done) => setTimeout(done, 500))")
    assert shown.js("plotsOnPage.has('plot-sweep_reading_2')") is True


def test_the_table_and_the_csv_have_every_drive_at_every_point(open_page, swept_file, swept):
    shown = open_page(swept_file)
    rows = shown.js(
        "[...document.querySelectorAll('#sweep > .scroll:last-of-type tbody tr')].map((row) => row.innerText)"
    )
    names = {drive.candidate.name for point in swept for drive in point.runs.drives}
    assert {row.split("\t")[0] for row in rows} == names
    lines = (swept_file.parent / "sweep.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "load.occupancy,drive,filter,reading error [N*m]"
    assert len(lines) == 1 + sum(len(drive.chains) for point in swept for drive in point.runs.drives)
    first = swept[0].runs.drives[0]
    name, error = least_error(first)
    assert f"5 %,{first.candidate.name},{name},{error:.6g}" in lines
