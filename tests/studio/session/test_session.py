"""Working documents of a tab: problems at their field, the last good result, undo, saving, the disk, the catalog."""

from __future__ import annotations

import shutil

import pytest

from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.errors import InputError
from torquerig.studio.session.studio_lock import studio_lock
from torquerig.studio.session.tab_session import Session

RIG = "wear_rig.yaml"
RATIO = ("rig", "gearbox", "ratio")


def ratio_of(scenario):
    return next(one.ratio for one in scenario.rig.parts if one.name == "gearbox")


@pytest.fixture
def folder(tmp_path):
    for name in (RIG, "filters.yaml", "matrix_example.yaml"):
        shutil.copy(shipped_scenarios() / name, tmp_path / name)
    (tmp_path / "run.yaml").write_text("sample_rate_Hz: 100\nchannels:\n  u: {quantity: torque, unit: N*m}\n")
    (tmp_path / "run.csv").write_text("u\n1\n2\n3\n")
    return tmp_path


@pytest.fixture
def session(folder):
    return Session(folder)


def test_the_files_of_a_folder_by_what_they_are(session):
    found = session.files()
    assert [one.name for one in found.scenarios] == [RIG]
    assert [one.name for one in found.sheets] == ["run.yaml"]
    assert [one.name for one in found.matrices] == ["matrix_example.yaml"]
    assert [one.name for one in found.filters] == ["filters.yaml"]
    assert [one.name for one in found.recordings] == ["run.csv"]


@pytest.mark.parametrize("name", [RIG, "filters.yaml", "matrix_example.yaml", "run.yaml"])
def test_each_kind_opens_without_problems(session, name):
    document = session.open(name)
    assert document.is_valid
    assert document.is_saved
    assert document.good is not None


def test_a_problem_is_at_its_field_and_the_last_good_result_stays(session):
    good = session.edit_text(RIG, RATIO, "7").good
    assert ratio_of(good) == 7
    document = session.edit_text(RIG, RATIO, "7 kg")
    assert [one.field for one in document.problems] == ["rig.gearbox.ratio"]
    assert document.problems[0].part == "gearbox"
    assert document.problems_at("rig", "gearbox") == document.problems
    assert document.problems_at("rig", "motor") == ()
    assert document.good is good
    assert document.value(*RATIO) == "7 kg"
    assert session.edit_text(RIG, RATIO, "8").is_valid


@pytest.mark.parametrize(
    ("keys", "value", "field", "part"),
    [
        (("rig", "motor", "catalog"), "bldc-12n14q", "rig.motor.catalog", "motor"),
        (("rig", "wear_part", "inertia"), "3 N", "rig.wear_part.inertia", "wear_part"),
        (("rig", "wear_part", "inertai"), "3 kg*m^2", "rig.wear_part.inertai", "wear_part"),
        (("rig", "shaft", "at"), "nowhere", "rig.shaft", "shaft"),
        (("operating_point", "output_speed"), "200 kg", "operating_point.output_speed", "output_speed"),
        (("study", "filters", "names"), ["nonsense"], "study.filters.names", "filters"),
        (("nonsense",), 1, "nonsense", None),
    ],
)
def test_where_a_problem_is(session, keys, value, field, part):
    document = session.edit(RIG, keys, value)
    assert [(one.field, one.part) for one in document.problems] == [(field, part)]
    assert document.problems[0].line is not None
    assert "Traceback" not in document.problems[0].sentence


def test_a_matrix_and_a_sheet_have_their_problems_too(session):
    criterion = next(iter(session.open("matrix_example.yaml").value("criteria")))
    document = session.edit("matrix_example.yaml", ("criteria", criterion, "weight"), -1)
    assert [one.field for one in document.problems] == [f"criteria.{criterion}.weight"]
    document = session.edit("run.yaml", ("channels", "u", "unit"), "kg")
    assert [(one.field, one.part) for one in document.problems] == [("channels.u.unit", "u")]


def test_a_text_that_is_no_yaml_keeps_the_last_good_one(session):
    document = session.replace_text(RIG, "rig: [")
    assert document.kind == "scenario"
    assert "not YAML" in document.problems[0].sentence
    assert document.good.title == "wear_rig"
    assert document.value("rig", "motor", "kind") == "motor"
    with pytest.raises(InputError, match="not YAML"):
        session.edit(RIG, RATIO, 3)
    assert session.undo(RIG).is_valid


def test_a_fault_of_a_check_is_a_sentence(session, monkeypatch):
    def broken(*_, **__):
        raise KeyError("x")

    session.open(RIG)
    monkeypatch.setattr("torquerig.scenario.reading.read_scenario", broken)
    document = session.edit(RIG, RATIO, 3)
    assert "fault of torquerig" in document.problems[0].sentence
    assert document.good is not None


def test_undo_and_redo_give_back_every_text(session):
    texts = [session.open(RIG).text]
    texts += [session.edit(RIG, RATIO, ratio).text for ratio in (6, 7, "x")]
    for text in reversed(texts[:-1]):
        assert session.undo(RIG).text == text
    assert not session.open(RIG).past
    assert session.undo(RIG).text == texts[0]
    for text in texts[1:]:
        assert session.redo(RIG).text == text
    assert ratio_of(session.undo(RIG).good) == 7
    session.edit(RIG, RATIO, 9)
    assert not session.open(RIG).future


def test_a_slider_is_one_step_of_undo(session):
    before = session.open(RIG).text
    for ratio in (6, 7, 8):
        session.edit(RIG, RATIO, ratio, merge=True)
    session.edit(RIG, ("rig", "load", "hit_rms"), 0.2, merge=True)
    assert session.undo(RIG).value(*RATIO) == 8
    assert session.undo(RIG).text == before


def test_saving_writes_the_text_and_nothing_else(session, folder):
    before = {file.name: file.read_bytes() for file in folder.iterdir()}
    session.edit(RIG, RATIO, 7)
    assert not session.open(RIG).is_saved
    saved = session.save(RIG)
    assert saved.written
    assert session.open(RIG).is_saved
    after = {file.name: file.read_bytes() for file in folder.iterdir()}
    assert after.pop(RIG) == session.open(RIG).text.encode()
    before.pop(RIG)
    assert after == before


def test_a_file_with_problems_is_saved_and_this_is_said(session):
    session.edit(RIG, RATIO, "x")
    assert "1 problem" in session.save(RIG).sentence


def test_a_file_that_changed_on_disk_is_not_replaced(session, folder):
    session.edit(RIG, RATIO, 7)
    other = (folder / RIG).read_text() + "# by another program\n"
    (folder / RIG).write_text(other)
    assert session.disk_state(RIG) == "changed"
    saved = session.save(RIG)
    assert (saved.written, saved.offers) == (False, ("reload", "save_as"))
    assert "changed on disk" in saved.sentence
    assert (folder / RIG).read_text() == other
    assert session.save_as(RIG, "mine.yaml").written
    assert Session(folder).open("mine.yaml").value(*RATIO) == 7
    assert not [file for file in folder.iterdir() if file.name.startswith(".")]


def test_reload_takes_the_disk_and_undo_gives_the_edits_back(session, folder):
    mine = session.edit(RIG, RATIO, 7).text
    (folder / RIG).write_text((folder / RIG).read_text() + "# new\n")
    document = session.reload(RIG)
    assert document.text.endswith("# new\n")
    assert document.is_saved
    assert session.undo(RIG).text == mine
    assert session.save(RIG).written


def test_a_deleted_file_is_written_again(session, folder):
    session.edit(RIG, RATIO, 7)
    (folder / RIG).unlink()
    assert session.disk_state(RIG) == "gone"
    assert "had been deleted" in session.save(RIG).sentence


def test_a_new_file_is_written_once(session, folder):
    session.new("new.yaml", session.open(RIG).text)
    assert not session.open("new.yaml").is_saved
    assert session.save("new.yaml").written
    with pytest.raises(InputError, match="is there already"):
        session.new("new.yaml", "x: 1")
    assert not session.save_as(RIG, "new.yaml").written
    with pytest.raises(InputError, match="outside of the folder"):
        session.open("../other.yaml")


def test_two_sessions_share_nothing(folder):
    one, two = Session(folder), Session(folder)
    one.edit(RIG, RATIO, 7)
    assert two.open(RIG).value(*RATIO) is None
    two.edit(RIG, RATIO, 9)
    assert one.open(RIG).value(*RATIO) == 7
    assert one.save(RIG).written
    assert not two.save(RIG).written
    assert two.open(RIG).value(*RATIO) == 9


def test_a_catalog_file_edited_to_nonsense_is_reported_and_the_last_good_stays(folder):
    shelf = folder / "catalogs" / "gearboxes"
    shelf.mkdir(parents=True)
    shipped = (shipped_folder() / "gearboxes" / "reference-5-1.yaml").read_text()
    (shelf / "mine.yaml").write_text(shipped.replace("reference-5-1", "mine"))
    (shelf / "other.yaml").write_text(shipped.replace("reference-5-1", "other"))
    session = Session(folder)
    assert "mine" in session.catalog.gearboxes
    assert session.edit(RIG, ("rig", "gearbox", "catalog"), "mine").is_valid
    (shelf / "mine.yaml").write_text("ratio: [nonsense\n")
    found = session.catalog_problems()
    assert [one.file.name for one in found] == ["mine.yaml"]
    assert "mine" in session.catalog.gearboxes
    assert session.recheck(RIG).is_valid
    (shelf / "mine.yaml").unlink()
    assert session.catalog_problems() == ()
    assert not session.recheck(RIG).is_valid


def test_one_studio_per_folder(folder):
    with studio_lock(folder) as kept:
        assert kept.is_dir()
        with (
            pytest.raises(InputError, match=r"works on this folder already \(process \d+ on .+\)"),
            studio_lock(folder),
        ):
            pass
    with studio_lock(folder):
        assert [one.name for one in Session(folder).files().scenarios] == [RIG]
    with pytest.raises(InputError, match="no such folder"), studio_lock(folder / "none"):
        pass
