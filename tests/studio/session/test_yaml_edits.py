"""Edits by key path: the data is what was asked for, and no other sign of the file changes."""

from __future__ import annotations

import copy
import difflib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.studio.session.yaml_edits import moved, with_entry, with_text, with_value, without
from torquerig.studio.session.yaml_values import entry_text, flow_text, value_from_text

PATH = Path("file.yaml")
WEAR_RIG = (shipped_scenarios() / "wear_rig.yaml").read_text(encoding="utf-8")
SHIPPED = sorted([*shipped_scenarios().glob("*.yaml"), *sorted(shipped_folder().glob("*/*.yaml"))[::9]])


def read(text):
    return parse_document(text, PATH).data


def changed(before, after):
    """Lines that differ, without those that are the same."""
    lines = difflib.ndiff(before.splitlines(), after.splitlines())
    return [line for line in lines if line[:1] in "+-"]


def leaves(data, keys=()):
    if isinstance(data, dict):
        for key, value in data.items():
            yield from leaves(value, (*keys, key))
    elif isinstance(data, list):
        for place, value in enumerate(data):
            yield from leaves(value, (*keys, place))
    else:
        yield keys


def removed_between(before, after):
    """What lies between the longest common beginning and end of two texts."""
    head = next(at for at, pair in enumerate(zip(before, after, strict=False)) if len(set(pair)) > 1)
    tail = next(at for at, pair in enumerate(zip(before[::-1], after[::-1], strict=False)) if len(set(pair)) > 1)
    return before[head : len(before) - tail]


def value_at(data, keys):
    for key in keys:
        data = data[key]
    return data


def put(data, keys, value):
    held = copy.deepcopy(data)
    inside = held
    for key in keys[:-1]:
        inside = inside[key]
    inside[keys[-1]] = value
    return held


@pytest.mark.parametrize("file", SHIPPED, ids=lambda file: file.name)
def test_each_scalar_of_a_shipped_file_can_be_replaced_and_back(file):
    text = file.read_text(encoding="utf-8")
    places = list(leaves(read(text)))
    for keys in places[:: max(1, len(places) // 5)]:
        try:
            after = with_value(text, keys, "other # 'value'", path=PATH)
        except InputError:  # an anchored value stands for several
            assert "&" in text
            continue
        assert read(after) == put(read(text), keys, "other # 'value'")
        removed = removed_between(text, after)
        assert "\n" not in removed or "|" in text, "more than a value was replaced"
        back = with_value(after, keys, value_at(read(text), keys), path=PATH)
        assert read(back) == read(text)


def test_a_number_of_a_field_stays_as_it_was_written():
    after = with_text(WEAR_RIG, ("operating_point", "slow_speed_wander"), " 3.0e-4 ", path=PATH)
    assert changed(WEAR_RIG, after) == [
        "-   slow_speed_wander: 2.0e-4          # relative rms through a 0.3 Hz low-pass, in steady runs",
        "+   slow_speed_wander: 3.0e-4          # relative rms through a 0.3 Hz low-pass, in steady runs",
    ]


def test_only_the_changed_key_of_a_mapping_is_written():
    part = read(WEAR_RIG)["rig"]["load"] | {"hit_rms": "0.2 N*m"}
    after = with_value(WEAR_RIG, ("rig", "load"), part, path=PATH)
    assert changed(WEAR_RIG, after) == ["-     hit_rms: 0.10", "+     hit_rms: 0.2 N*m"]


def test_a_new_part_stands_where_it_is_wanted():
    gap = {"kind": "backlash", "gap": "4 arcmin"}
    after = with_entry(WEAR_RIG, ("rig", "gap"), gap, after="gearbox", path=PATH)
    assert list(read(after)["rig"])[:3] == ["motor", "gearbox", "gap"]
    assert changed(WEAR_RIG, after) == ["+   gap: {kind: backlash, gap: 4 arcmin}"]
    first = with_entry(WEAR_RIG, ("rig", "gap"), gap, after=None, path=PATH)
    assert next(iter(read(first)["rig"])) == "gap"
    assert without(first, ("rig", "gap"), path=PATH) == WEAR_RIG


def test_a_part_moves_with_its_comment_and_back():
    after = moved(WEAR_RIG, ("rig", "shaft"), after="motor", path=PATH)
    assert list(read(after)["rig"])[:2] == ["motor", "shaft"]
    assert sorted(after.splitlines()) == sorted(WEAR_RIG.splitlines())
    assert after.index("# mechanical lines of the output shaft") < after.index("  gearbox:")
    assert moved(after, ("rig", "shaft"), after="encoder", path=PATH) == WEAR_RIG


def test_items_of_a_list_come_and_go():
    keys = ("operating_point", "duty_cycle", "segments")
    segments = read(WEAR_RIG)["operating_point"]["duty_cycle"]["segments"]
    fewer = with_value(WEAR_RIG, keys, [*segments[:1], *segments[2:]], path=PATH)
    assert changed(WEAR_RIG, fewer) == ["-       - {duration: 120 s, output_speed: 200 rpm, occupancy: 5 %}"]
    more = with_value(fewer, keys, segments, path=PATH)
    assert more == WEAR_RIG
    names = with_value(WEAR_RIG, ("study", "gearboxes"), ["spur-2.5-1", "economy-20-1"], path=PATH)
    assert changed(WEAR_RIG, names) == [
        "-   gearboxes: [spur-2.5-1, reference-5-1, economy-20-1]", "+   gearboxes: [spur-2.5-1, economy-20-1]",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "keys", "value", "expected"),
    [
        ("a:\nb: 1\n", ("a",), 5, "a: 5\nb: 1\n"),
        ("a: # why\nb: 1\n", ("a",), 5, "a: 5 # why\nb: 1\n"),
        ("a: 1", ("b",), 2, "a: 1\nb: 2\n"),
        ("a: {}\n", ("a", "b"), 2, "a: {b: 2}\n"),
        ("a: 1\n", ("b", "c"), 2, "a: 1\nb: {c: 2}\n"),
        ("a: |\n  x\n  y\nb: 1\n", ("a",), "z", "a: z\nb: 1\n"),
        ("a:\n  b: 1  # one\n  # end\nc: 2\n", ("a",), "z", "a: z  # one\n  # end\nc: 2\n"),
        ("- a: 1\n  b: 2\n- c\n", (0, "a"), 9, "- a: 9\n  b: 2\n- c\n"),
        ("- a: 1\n  b: 2\n- c\n", (0,), 9, "- 9\n- c\n"),
        ("- - 1\n  - 2\n- c\n", (0, 1), 9, "- - 1\n  - 9\n- c\n"),
        ("a: 1\r\nb: {c: 2}\r\n", ("d",), 3, "a: 1\r\nb: {c: 2}\r\nd: 3\r\n"),
        ("# é 😀\na: 'x'  # y\n", ("a",), "1e5", '# é 😀\na: "1e5"  # y\n'),
        ("a: [1, 2]\n", ("a",), [1, 2, 3], "a: [1, 2, 3]\n"),
        ("a: [1, # one\n 2]\n", ("a",), [1], "a: [1 # one\n ]\n"),
        ("a: {1: x, 2: y}\n", ("a", 3), "z", "a: {1: x, 2: y, 3: z}\n"),
    ],
)
def test_forms_of_yaml(text, keys, value, expected):
    assert with_value(text, keys, value, path=PATH) == expected


def test_an_alias_is_refused_and_nothing_else_changes():
    text = "a: &x {b: 1}\nc: *x\n"
    with pytest.raises(InputError, match="edit the file as text"):
        with_value(text, ("c", "b"), 2, path=PATH)


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda: without(WEAR_RIG, ("rig", "gearbx"), path=PATH), "did you mean 'gearbox'"),
        (lambda: moved(WEAR_RIG, ("rig", "load"), after="motr", path=PATH), "did you mean 'motor'"),
        (lambda: with_entry(WEAR_RIG, ("rig", "load"), {}, after=None, path=PATH), "is there already"),
        (lambda: with_value(WEAR_RIG, ("scenario", "x"), 1, path=PATH), "no mapping"),
        (lambda: with_value(WEAR_RIG, ("rig", "load", "hit_rms"), float("nan"), path=PATH), "not finite"),
        (lambda: value_from_text("[1, 2"), "close every bracket"),
    ],
)
def test_refusals_are_one_sentence(edit, words):
    with pytest.raises(InputError, match=words) as caught:
        edit()
    assert "\n" not in str(caught.value)


SCALARS = st.one_of(
    st.none(), st.booleans(), st.integers(-(10**12), 10**12), st.floats(-1e29, 1e29),
    st.text(st.characters(blacklist_categories=("Cs", "Cc")), max_size=12),
    st.sampled_from(["no", "1e5", "0x1", "~", "a: b", "- x", "#", "{", "", " x ", "5 %", "*", "&a", "!t"]),
)  # fmt: skip
VALUES = st.recursive(
    SCALARS,
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text("abcde", min_size=1, max_size=3), inner, max_size=3)
    ),
    max_leaves=6,
)


@given(VALUES)
@settings(max_examples=60, deadline=None)
def test_each_value_reads_back(value):
    assert read(f"x: {flow_text(value)}") == {"x": value}
    assert read(entry_text("x", value, indent=0)) == {"x": value}


@given(VALUES, st.data())
@settings(max_examples=25, deadline=None)
def test_what_is_not_edited_stays(value, data):
    keys = data.draw(st.sampled_from(list(leaves(read(WEAR_RIG)))))
    cut = data.draw(st.integers(1, len(keys)))
    after = with_value(WEAR_RIG, keys[:cut], value, path=PATH)
    assert read(after) == put(read(WEAR_RIG), keys[:cut], value)
    comments = [line.strip() for line in WEAR_RIG.splitlines() if line.startswith("#")]
    assert [line.strip() for line in after.splitlines() if line.startswith("#")] == comments
