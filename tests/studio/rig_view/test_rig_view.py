"""The parts of every shipped scenario in the drawing, also of text with mistakes; the values that a part may state."""

from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
import yaml

from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.scenario.reading import read_scenario
from torquerig.studio.rig_view.drawing import drawing
from torquerig.studio.rig_view.part_values import part_values
from torquerig.studio.rig_view.placed_parts import placed_parts

SCENARIOS = Path(__file__).resolve().parents[3] / "scenarios"
RIGS = sorted(one for one in SCENARIOS.glob("*.yaml") if "\nrig:" in one.read_text(encoding="utf-8"))
WEAR_RIG = yaml.safe_load((SCENARIOS / "wear_rig.yaml").read_text(encoding="utf-8"))["rig"]


def read(path):
    return read_scenario(read_document(path), catalog_for(path), seed=1)


def boxes(text):
    return [one for one in ET.fromstring(text) if "data-part" in one.attrib]


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_parts_on_a_shaft_follow_those_that_the_scenario_fixes_them_to(path):
    made = read(path)
    written = yaml.safe_load(path.read_text(encoding="utf-8"))["rig"]
    placed = {one.name: one for one in placed_parts(written)}
    assert list(placed) == list(written)
    for part in made.rig.parts:
        if part.name not in placed:
            continue  # an effect that the catalog brings
        one = placed[part.name]
        assert (one.column >= 0) == part.on_shaft, part.name
        if part.on_shaft:
            assert one.after == (part.after or ""), part.name
            assert not part.after or placed[part.after].column == one.column - 1
        elif part.host is not None:
            assert one.host == part.host, part.name
    taken = [(one.column, one.row) for one in placed.values() if one.column >= 0]
    assert len(set(taken)) == len(taken)


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_every_part_is_one_button_and_no_two_boxes_meet(path):
    parts = placed_parts(yaml.safe_load(path.read_text(encoding="utf-8"))["rig"])
    found = boxes(drawing(parts, chosen=parts[0].name, problems={parts[1].name: 2}, read=(parts[2].name,)))
    assert sorted(one.get("data-part") for one in found) == sorted(one.name for one in parts)
    assert all(one.get("role") == "button" and one.get("tabindex") == "0" for one in found)
    rects = [one.find("rect") for one in found]
    areas = [[float(one.get(key)) for key in ("x", "y", "width", "height")] for one in rects]
    for at, (x, y, width, height) in enumerate(areas):
        for left, top, wide, high in areas[at + 1 :]:
            assert x + width <= left or left + wide <= x or y + height <= top or top + high <= y


def test_the_drawing_says_what_is_chosen_measured_and_wrong():
    parts = placed_parts(WEAR_RIG)
    found = boxes(drawing(parts, chosen="gearbox", problems={"motor": 2}, read=("torque_sensor",)))
    said = {one.get("data-part"): one.get("aria-label") for one in found}
    assert said["torque_sensor"] == "torque_sensor, torque_sensor, measured"
    assert said["motor"] == "motor, motor, 2 problems"
    assert [one.get("data-part") for one in found if one.get("aria-pressed") == "true"] == ["gearbox"]


@pytest.mark.parametrize(
    "rig",
    [{}, None, 3, [], {"a": None}, {"a": {"kind": "no such"}, "b": {"kind": "motor", "after": 3}}, {1: {"kind": 2}}],
)
def test_a_rig_with_mistakes_is_drawn_with_what_can_be_read(rig):
    parts = placed_parts(rig)
    assert len(boxes(drawing(parts, chosen="", problems={}, read=()))) == (len(rig) if isinstance(rig, dict) else 0)


def test_names_of_a_file_do_not_become_elements_of_the_page():
    text = drawing(placed_parts({'<script>"\x1b[2J': {"kind": "motor"}}), chosen="", problems={}, read=())
    assert "<script" not in text
    assert "\x1b" not in text


def test_a_part_shows_what_is_stated_what_the_catalog_gives_and_what_must_be_stated():
    made = read(SCENARIOS / "wear_rig.yaml")
    gearbox = {one.key: one for one in part_values("gearbox", WEAR_RIG["gearbox"], made)}
    assert gearbox["stiffness"].label == "stiffness [N*m/rad]"
    assert gearbox["stiffness"].hint.endswith("N*m/rad (catalog)")
    assert not gearbox["stiffness"].is_required
    bare = {one.key: one for one in part_values("gearbox", {"kind": "gear"}, None)}
    assert bare["stiffness"].is_required
    assert bare["stiffness"].hint == "must be stated"
    assert bare["efficiency"].hint == "1"
    wear_part = part_values("wear_part", WEAR_RIG["wear_part"], made)
    assert [one.key for one in wear_part if one.is_stated] == ["inertia", "viscous"]
    wrong = part_values("gearbox", {"kind": "gear", "ration": 5}, None)
    assert next(one for one in wrong if one.key == "ration").is_stated


def test_names_of_other_parts_and_words_are_offered():
    load = {one.key: one for one in part_values("load", WEAR_RIG["load"], None)}
    assert load["at"].names_part
    speed = {one.key: one for one in part_values("speed_controller", WEAR_RIG["speed_controller"], None)}
    assert speed["motor"].names_part
