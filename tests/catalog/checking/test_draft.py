"""A new file is a commented entry with blanks, and is read once they are filled; what exists is not overwritten."""

import re

import pytest
from click.testing import CliRunner

from torquerig.catalog.checking.draft import FIRST, draft
from torquerig.catalog.checking.entry_check import check_file, files_in, kind_of_file
from torquerig.catalog.entry import estimates
from torquerig.catalog.part_class import KINDS
from torquerig.catalog.reading import read_classes, read_entry
from torquerig.catalog.shipped import shipped_folder
from torquerig.cli import group
from torquerig.errors import InputError
from torquerig.units import si_unit, written_quantity

CLASSES = read_classes(shipped_folder())
VALUES = {"N*m": 5, "kg*cm^2": 0.4, "V/(N*m)": 1}


def filled(text, part):
    """Fill every blank that is not commented out, with the middle of the class where it has one."""
    known = part.known()
    lines = []
    for line in (one for one in text.splitlines() if not one.startswith("#")):
        found = re.match(r"(\w+): \{value: (____ ?(.*?)),", line)
        written = line
        if found and found[1] in known:
            unit = si_unit(found[3] or "1")
            written = line.replace(found[2], written_quantity(known[found[1]].nominal(), unit), 1)
        elif found:
            written = line.replace("____", str(VALUES[found[3]]), 1)
        written = written.replace("ratio: ____", "ratio: 5").replace("kind: ____", "kind: belt")
        written = written.replace("starts: ____", "starts: 4").replace("wheel_teeth: ____", "wheel_teeth: 20")
        lines.append(written.replace("____", "p. 1"))
    return "\n".join(lines)


@pytest.mark.parametrize("part", CLASSES.values(), ids=CLASSES)
def test_a_draft_is_read_once_its_blanks_are_filled(tmp_path, part):
    path = tmp_path / "mine.yaml"
    path.write_text(filled(draft(part.of, "mine", CLASSES, like=part.name), part), encoding="utf-8")
    entry = read_entry(path, KINDS[part.of], CLASSES)
    known = dict(estimates(entry))
    first = [field for field in FIRST[part.of] if field != "slots" or part.kinds != ("induction",)]
    assert all(known[field].documented for field in first)


@pytest.mark.parametrize("of", KINDS)
def test_a_draft_names_every_field_of_its_schema_and_every_class(of):
    text = draft(of, "mine", CLASSES)
    for field, declared in KINDS[of].model_fields.items():
        if "Estimate" in str(declared.annotation):
            assert re.search(rf"(?m)^(# )?{field}: ", text), field
    assert all(name in text for name, one in CLASSES.items() if one.of == of)


def test_a_blank_that_is_left_is_refused_with_its_line(tmp_path):
    path = tmp_path / "mine.yaml"
    path.write_text(draft("motor", "mine", CLASSES, like="servo-60mm-400W"), encoding="utf-8")
    with pytest.raises(InputError, match=r"mine\.yaml:6: title: a blank is left; fill it, or delete the line"):
        read_entry(path, KINDS["motor"], CLASSES)


def run(*arguments):
    return CliRunner().invoke(group, ["catalog", *map(str, arguments)], catch_exceptions=True)


def test_the_commands_write_check_and_never_overwrite(tmp_path):
    path = tmp_path / "motors" / "mine.yaml"
    assert run("new", path, "--like", "servo-60mm-400W").exit_code == 0
    before = path.read_text(encoding="utf-8")
    again = run("new", path)
    assert "is there already" in str(again.exception)
    assert path.read_text(encoding="utf-8") == before
    assert "a blank is left" in run("check", path).output
    text = re.sub(r"(?m)^(rated|peak|max|rotor|pole|slots).*\n", "", before).replace('"____"', '"mine"', 1)
    path.write_text(text, encoding="utf-8")
    checked = run("check", tmp_path).output
    assert "nothing contradicts" in checked
    assert "CLASS" in checked
    assert "1 checked, 0 with contradictions or errors" in checked
    assert "coulomb_friction" in run("show", "mine", "--catalog", tmp_path).output
    assert run("mine", "--catalog", tmp_path).output == run("show", "mine", "--catalog", tmp_path).output


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("new", "mine.txt"), "a catalog file ends in .yaml"),
        (("new", "mine.yaml", "--like", "servo-60mm-450W"), "did you mean"),
        (
            ("new", "mine.yaml", "--kind", "gearbox", "--like", "servo-60mm-400W"),
            "no class 'servo-60mm-400W' of a gearbox",
        ),
        (("check", "nowhere"), "there is no such file or folder"),
    ],
)
def test_a_wrong_call_is_refused_with_the_remedy(tmp_path, monkeypatch, arguments, sentence):
    monkeypatch.chdir(tmp_path)
    assert sentence in str(run(*arguments).exception)
    assert not list(tmp_path.iterdir())


def test_a_loose_file_is_recognised_by_its_kind(tmp_path):
    path = tmp_path / "mine.yaml"
    for text, of in (("kind: spur", "gearbox"), ("kind: jaw", "coupling"), ("range_torque: 1", "sensor")):
        path.write_text(text + "\n", encoding="utf-8")
        assert kind_of_file(path) is KINDS[of]
    path.write_text("title: x\n", encoding="utf-8")
    with pytest.raises(InputError, match="is it a motor, gearbox, sensor or coupling"):
        kind_of_file(path)
    assert "is it a motor" in check_file(path, CLASSES).problem
    with pytest.raises(InputError, match="has no catalog files"):
        files_in(tmp_path)
