"""Files that are dropped, what is in them, and the form of their sidecar."""

from __future__ import annotations

import pytest

from tests.own_loop import awaited
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar_choice import sidecar_target
from torquerig.studio.data.received import arrival_sentence, checked_name, received
from torquerig.studio.data.sheet_form import set_field, sheet_form
from torquerig.studio.data.shown_file import HEAD, shown_file
from torquerig.studio.session.tab_session import Session

TABLE = "time_s,u [V],enc\n" + "".join(f"{at / 1000},{at % 7},{at}\n" for at in range(200))


async def pieces(*parts, fails=False):
    for one in parts:
        yield one
    if fails:
        raise OSError(28, "No space left on device")


def drop(folder, name, *parts, **how):
    return awaited(received(folder, name, pieces(*parts, **how)))


def test_a_dropped_file_is_written_whole(tmp_path):
    path = drop(tmp_path, "run.csv", TABLE[:50].encode(), TABLE[50:].encode())
    assert path.read_text() == TABLE
    with pytest.raises(InputError, match="is there already"):
        drop(tmp_path, "run.csv", b"other")
    assert path.read_text() == TABLE


def test_nothing_is_left_of_a_file_that_did_not_arrive_whole(tmp_path):
    with pytest.raises(InputError, match="No space left"):
        drop(tmp_path, "run.csv", b"half", fails=True)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["", "..", ".hidden", "a\x1b[2J.csv", "a:b.csv", "x" * 300])
def test_a_bad_name_is_refused(name):
    with pytest.raises(InputError, match="cannot be the name"):
        checked_name(name)


def test_a_folder_in_a_name_is_left_out():
    assert checked_name("../../etc/run.csv") == checked_name("C:\\data\\run.csv") == "run.csv"


@pytest.fixture
def session(tmp_path):
    (tmp_path / "run.csv").write_text(TABLE)
    return Session(tmp_path)


def test_each_column_says_what_it_is_taken_for(session):
    path = session.folder / "run.csv"
    found = shown_file(path, sidecar_target(path))
    rows = {row[0]: dict(zip(HEAD, row, strict=True)) for row in found.rows}
    assert rows["u"]["taken for"] == "voltage"
    assert rows["u"]["rate"] == "1000 Hz"
    assert found.draft
    assert "no such file" in shown_file(session.folder / "none.csv", path).problem


def test_a_sheet_is_completed_in_its_form_and_the_recording_opens(session):
    path = session.folder / "run.csv"
    target = sidecar_target(path)
    document = session.new(target.name, shown_file(path, target).draft)
    for keys, written in (
        (("channels", "u", "quantity"), "torque"), (("channels", "u", "unit"), "V"),
        (("run", "speed_rpm"), "1000"), (("run", "profile"), "steady"), (("run", "occupancy_percent"), "5"),
    ):  # fmt: skip
        document = set_field(session, document, keys, written)
    scale = next(
        one for group in sheet_form(document, parts=["torque_sensor"], motors=[]) for one in group.fields
        if one.label.startswith("scale")
    )  # fmt: skip
    assert [one.field for one in document.problems] == ["channels.u.unit"]
    document = set_field(session, document, scale.keys, "5.0")
    document = set_field(session, document, ("channels", "u", "of"), "torque_sensor")
    assert document.is_valid
    assert session.save(target.name).written
    read = read_recording(path)
    assert read.torque()[6] == 30.0
    assert read.run.occupancy_percent == 5.0
    comments = [line for line in document.text.splitlines() if line.startswith("#")]
    assert any("Sidecar of run.csv" in line for line in comments)


def test_an_empty_field_takes_the_key_out_and_a_wrong_one_says_why(session):
    (session.folder / "run.yaml").write_text("channels:\n  u: {quantity: voltage, unit: V, of: motor}\n")
    document = session.open("run.yaml")
    document = set_field(session, document, ("channels", "u", "of"), "")
    assert document.value("channels", "u") == {"quantity": "voltage", "unit": "V"}
    assert set_field(session, document, ("run", "motor"), " ") is document
    document = set_field(session, document, ("run", "occupancy_percent"), "500")
    assert [one.field for one in document.problems] == ["run.occupancy_percent"]
    groups = sheet_form(document, parts=(), motors=("a",))
    assert [one.title for one in groups] == ["channel u", "conditions of the run", "the file"]
    assert next(one.value for one in groups[1].fields if one.keys[-1] == "occupancy_percent") == "500"


def test_a_file_that_no_reader_takes_is_named_as_such():
    assert arrival_sentence("run.csv") == "run.csv: received"
    assert arrival_sentence("run.yaml") == "run.yaml: received"
    assert "not listed: no recording ends in .exe; known are" in arrival_sentence("x.exe")
