import csv
import html
import re
from dataclasses import replace
from pathlib import Path

import pytest

from torquerig.decide.verdict import Certainty
from torquerig.errors import InputError
from torquerig.reporting.study import report as study_report
from torquerig.reporting.study.answers import limits
from torquerig.reporting.study.page import study_page
from torquerig.reporting.study.report import write_study_report
from torquerig.study.answer.what_to_do import NOBODY
from torquerig.study.what_if import Change


@pytest.fixture(scope="module")
def written(runs, decided, answer, tmp_path_factory):
    folder = tmp_path_factory.mktemp("reports") / "wear_rig"
    return write_study_report(runs, decided, answer, folder)


@pytest.mark.long
def test_the_page_comes_first_and_nothing_else_is_left_beside(written):
    assert [path.name for path in written] == ["index.html", "combinations.csv", "shares.csv", "matrices.xlsx"]
    assert sorted(path.name for path in written[0].parent.iterdir()) == sorted(path.name for path in written)
    assert [path.name for path in written[0].parent.parent.iterdir()] == ["wear_rig"]


@pytest.mark.long
def test_the_same_study_gives_the_same_bytes(runs, decided, answer, written, tmp_path):
    again = write_study_report(runs, decided, answer, tmp_path / "elsewhere")
    assert [path.read_bytes() for path in again] == [path.read_bytes() for path in written]


def test_an_error_halfway_leaves_the_old_report_and_no_other_folder(runs, decided, answer, tmp_path, monkeypatch):
    folder = tmp_path / "report"
    folder.mkdir()
    (folder / "index.html").write_text("old")

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(study_report, "study_page", lambda *_, **__: "new")
    monkeypatch.setattr(study_report, "write_workbook", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_study_report(runs, decided, answer, folder)
    assert (folder / "index.html").read_text() == "old"
    assert list(tmp_path.iterdir()) == [folder]


def test_files_that_are_no_part_of_the_report_are_kept(runs, decided, answer, tmp_path, monkeypatch):
    monkeypatch.setattr(study_report, "study_page", lambda *_, **__: "new")
    folder = tmp_path / "report"
    folder.mkdir()
    (folder / "notes.txt").write_text("mine")
    (folder / "index.html").write_text("old")
    write_study_report(runs, decided, answer, folder)
    assert (folder / "notes.txt").read_text() == "mine"
    assert (folder / "index.html").read_text() == "new"
    assert list(tmp_path.iterdir()) == [folder]


def test_a_file_in_the_place_of_the_folder_is_not_overwritten(runs, decided, answer, tmp_path):
    place = tmp_path / "report"
    place.write_text("a file")
    with pytest.raises(InputError, match="is a file; name a folder"):
        write_study_report(runs, decided, answer, place)
    assert place.read_text() == "a file"


@pytest.mark.long
def test_the_page_holds_everything_itself(written):
    page = written[0].read_text(encoding="utf-8")
    assert "default-src 'none'" in page  # the browser then refuses every request to the net
    assert not re.search(r'<(script|link|img|iframe)[^>]*(src|href)="(?!data:)', page)
    assert all(target.startswith(("#", "data:")) for target in re.findall(r'<a href="([^"]+)"', page))
    assert page.count('src="data:image/svg+xml;base64,') == page.count("<img ") > 5
    assert len(page) < 10_000_000
    assert str(Path.cwd()) not in page


def test_the_page_answers_in_order(written, answer):
    page = html.unescape(written[0].read_text(encoding="utf-8"))
    parts = [*answer.answer.sentences, "<dt>best in</dt>", "<h2>How sure is this?", "Uncertainty of one reading",
             "<h2>What would change", "<h2>Try other weights", "<h2>Ranked combinations",
             "Reading error of each drive</h2>", "<h2>Readings before and after", "<h2>Shares of the reading",
             "Drives out of reach", "Elimination: requirements", "Pugh: comparison", "Kesselring: weighted points",
             "Calculation of every cell", "Effect of the filters", "Assumed values", "Missing values to ask",
             "Question and conditions", "<h2>Limits of validity", "Files and command",
             "torquerig compare wear_rig.yaml"]  # fmt: skip
    places = [page.find(part) for part in parts]
    assert -1 not in places
    assert places == sorted(places)


def test_the_cells_of_the_matrices_lead_to_their_way(written):
    page = written[0].read_text(encoding="utf-8")
    targets = set(re.findall(r'href="#(way-[^"]+)"', page))
    assert targets == {"way-bldc-12n14p-5-1", "way-HDS6A-0104A-5-1", "way-GP-71M-20-1"}
    assert all(f'id="{target}"' in page for target in targets)
    way = page[page.index('id="way-HDS6A-0104A-5-1"') :]
    assert (
        way.index("from the catalog to the points")
        < way.index("rotor inertia of HDS6A-0104A")
        < way.index("</details>")
    )


def test_the_page_says_what_is_out_of_reach_and_marks_unknowns(written):
    page = written[0].read_text(encoding="utf-8")
    assert "needs 4000 rpm, reaches at most 3000 rpm" in page
    assert "20 notched lines" in page
    assert 'class="number unknown"' in page or ">?<" in page


def test_the_mesh_is_named_as_a_limit_until_the_scenario_states_one(runs):
    assert any("Gear mesh lines are absent" in one for one in limits(runs))
    rig = {
        **runs.study.document.data["rig"],
        "mesh": {"kind": "gear_mesh", "order_output": 84, "transmission_error": ["10 urad"]},
    }
    document = replace(runs.study.document, data={**runs.study.document.data, "rig": rig})
    meshed = replace(runs, study=replace(runs.study, document=document))
    assert not any("Gear mesh lines are absent" in one for one in limits(meshed))


@pytest.mark.long
def test_a_study_that_nothing_survives_has_a_page_too(runs, decided, answer):
    nobody = replace(answer.answer, sentences=NOBODY, figures=(), certainty=Certainty.NOBODY, questions=())
    page = study_page(runs, decided, replace(answer, winner="", certainty=Certainty.NOBODY, facts=(), answer=nobody))
    assert '<p class="sentence">No drive meets the requirements.</p>' in page
    assert "No value is missing." in page


@pytest.mark.long
def test_markup_in_names_is_escaped(runs, decided, answer):
    change = Change(
        before="<b>x</b>", after="<b>x</b>", chain_before="none", chain_after="none", error_before=0.1,
        error_after=None, disturbance_before=None, disturbance_after=0.2,
    )  # fmt: skip
    page = study_page(runs, decided, answer, changes=[change], edits=["load.occupancy=21"])
    assert "&lt;b&gt;x&lt;/b&gt;" in page
    assert "<b>x</b>" not in page
    assert "--set load.occupancy=21" in page


def test_combinations_has_a_row_per_motor_gearbox_and_filter(written, runs):
    rows = _rows(written[1])
    filters = runs.study.settings.filters.names
    assert len(rows) == len(runs.drives) * len(filters)
    assert len({(row["motor"], row["gearbox"], row["filter"]) for row in rows}) == len(rows)
    present = next(row for row in rows if (row["motor"], row["filter"]) == ("bldc-12n14p", "none"))
    # sines of 0.2 and 0.1 N m beside the load: rms sqrt(0.2^2 / 2 + 0.1^2 / 2), six digits are written
    assert float(present["reading error [N*m]"]) == pytest.approx((0.025) ** 0.5, rel=2e-3)
    assert float(present["reading error low [N*m]"]) == pytest.approx(0.9 * (0.025) ** 0.5, rel=2e-3)
    lost = next(row for row in rows if row["motor"] == "GP-71M")
    assert lost["reading error [N*m]"] == "?"
    assert lost["out of reach"].startswith("needs 4000 rpm")


def test_shares_csv_adds_up_to_a_hundred(written):
    rows = _rows(written[2])
    assert float(rows[0]["load [% of power]"]) == pytest.approx(36)  # 0.3^2 of 0.3^2 + 0.4^2
    assert float(rows[0]["cogging [% of power]"]) == pytest.approx(64)
    assert rows[2]["load rms [N*m]"] == "?"


def _rows(path):
    return list(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))
