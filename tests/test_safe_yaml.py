"""No YAML text hangs, fills the memory or ends in a traceback; each bad one is one sentence with its line."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.safe_yaml import DEEPEST, LONGEST_TEXT, MOST_REPEATED

BOMB = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"a{one}: &a{one} [{', '.join([f'*a{one - 1}'] * 10)}]\n" for one in range(1, 9)
)
MAPPING_BOMB = "a0: &a0 {k: x}\n" + "".join(
    f"a{one}: &a{one} {{{', '.join(f'k{key}: *a{one - 1}' for key in range(10))}}}\n" for one in range(1, 9)
)
BAD = {
    "aliases that grow": (BOMB, ":5: the aliases repeat more than"),
    "aliases of mappings that grow": (MAPPING_BOMB, "the aliases repeat more than"),
    "a long list of aliases": ("a: &a [1, 2, 3]\nb: [" + "*a, " * MOST_REPEATED + "]\n", ":2: the aliases repeat"),
    "a list inside of itself": ("a: &a [*a]\n", ":1: the alias *a is inside of what it repeats"),
    "a mapping inside of itself": ("b: 1\na: &a {b: *a}\n", ":2: the alias *a is inside of what it repeats"),
    "the file inside of itself": ("&a\nb: *a\n", "the alias *a is inside of what it repeats"),
    "a list as key": ("[a]: 1\n", ":1: the key before ':' is a list"),
    "a list as written key": ("a: 1\n? [a, b]\n: 1\n", ":2: the key before ':' is a list"),
    "a mapping as key": ("a:\n  {b: 1}: 1\n", ":2: the key before ':' is a mapping"),
    "an empty key": ("? \n: 1\n", "the key before ':' is empty"),
    "an integer of 5000 digits": (
        f"a: {'9' * 5000}\n",
        ":1: 99999999999999999999... (5000 characters) is out of range",
    ),
    "an integer of 20 digits": ("a: 99999999999999999999\n", "is more than the largest whole number"),
    "a negative integer of 30 digits": (f"a: -{'9' * 29}\n", "is more than the largest whole number"),
    "a number above all": ("a: 1e400\n", ":1: 1e400 is out of range"),
    "a weight of 1e308": ("a:\n- 1e308\n", ":2: 1e308 is out of range"),
    "a number below all": ("a: 1e-400\n", "1e-400 is too small to be held as a number; write 0"),
    "a tag of an integer": ("a: !!int abc\n", ":1: !!int is a tag; delete it"),
    "a tag of a time": ("a: !!timestamp abc\n", "!!timestamp is a tag"),
    "a tag of a set": ("a: !!set {x, y}\n", "!!set is a tag"),
    "a tag of Python": ("a: !!python/object/apply:os.system [ls]\n", "!!python/object/apply:os.system is a tag"),
    "a tag of one's own": ("a: !mine 1\n", "!mine is a tag"),
    "lists in lists": (f"a: {'[' * 200}{']' * 200}\n", f"is nested more than {DEEPEST} levels deep"),
    "mappings in mappings": ("\n".join(f"{' ' * one}a:" for one in range(2000)) + " 1\n", "is nested more than"),
    "lists without end": (f"a: {'[' * 100_000}\n", "a.yaml:1: "),
    "a NUL character": ("a: 1\nb: \0\n", ":2: holds the control character 0x00"),
    "a terminal escape": ("a: \x1b[31m\n", ":1: holds the control character 0x1b"),
    "the escape of a NUL character": ('a: "b\\0c"\n', "holds the escape of a NUL character"),
    "half a character": ('a: "\\ud800"\n', "not YAML"),
    "two documents": ("a: 1\n---\nb: 2\n", "found another document"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_yaml_is_one_sentence_with_its_line(case: str) -> None:
    text, said = BAD[case]
    with pytest.raises(InputError) as refused:
        parse_document(text, Path("a.yaml"))
    assert said in str(refused.value)
    assert str(refused.value).startswith("a.yaml")
    assert "\n" not in str(refused.value)
    assert str(refused.value).isprintable()


def test_plain_values_and_aliases_are_read_as_before() -> None:
    text = "a: &a {b: 1, c: [no, 0123, 1e5, .5, 'x\\ty']}\nd: *a\ne: [*a, *a]\n1: 2\n9223372036854775807: ok\n"
    data = parse_document(text, Path("a.yaml")).data
    assert data["a"] == {"b": 1, "c": ["no", "0123", 1e5, 0.5, "x\\ty"]}
    assert data["d"] == data["e"][0] == data["e"][1] == data["a"]
    assert data[1] == 2
    assert data[2**63 - 1] == "ok"


def test_a_file_without_end_is_refused(tmp_path: Path) -> None:
    long = tmp_path / "long.yaml"
    long.write_bytes(b"a" * (LONGEST_TEXT + 1))
    with pytest.raises(InputError, match="has more than 4 MB, too much for a YAML file"):
        read_document(long)
    if Path("/dev/zero").exists():
        with pytest.raises(InputError, match="has more than 4 MB"):
            read_document(Path("/dev/zero"))
