"""Seeded mutation of the shipped files: numbers, lines, characters and bytes that people and programs get wrong."""

from __future__ import annotations

import re
import zipfile
from io import BytesIO

import numpy as np

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
NUMBERS = (
    "0", "-1", "1e300", "-1e300", "1e400", "1e-300", "1e15", "1e-15", "1e9", "1e-9", "-0.0", "5000000", "99999999999",
    "1e29", "1e-29", "9" * 400, ".nan", ".inf", "nan", "5,000", "1.234.567", "null", "true", "", "abc", "0x10", "1_000",
)  # fmt: skip
VALUES = (
    "[]", "{}", "[1, 2]", "{a: 1}", "[[1, 2], [3]]", "null", "~", "true", "''", "' '", "'\\x1b[31m'", '"\\e[31mred"',
    "=1+1", "<script>alert(1)</script>", "$\\frac$", "[bold]", "'{x}'", "!!int abc", "&a [*a]", "*nothing", "../../x",
    "/dev/zero", "con", "x" * 500, "\u202eabc", "2024-01-01", "12:30:45", "1e5", "%", "1 %", "3 N", "3 furlongs",
)  # fmt: skip
LINES = (
    "a: 1",
    "- x",
    "  - [",
    "}",
    "? [a]",
    ": 1",
    "\t",
    "---",
    "...",
    "%YAML 9.9",
    "<<: *a",
    "# x",
    "'",
    '"',
    "|",
    ">",
)


def mutated_text(text: str, rng: np.random.Generator) -> str:
    """Return YAML text with one to three mutations."""
    for _ in range(1 if rng.random() < 0.7 else 3):
        text = TEXT_MUTATIONS[int(rng.integers(len(TEXT_MUTATIONS)))](text, rng)
    return text


def _other_number(text: str, rng: np.random.Generator) -> str:
    found = [one for one in NUMBER.finditer(text) if not text[text.rfind("\n", 0, one.start()) + 1 :].startswith("#")]
    if not found:
        return text
    chosen = found[int(rng.integers(len(found)))]
    return text[: chosen.start()] + str(rng.choice(NUMBERS)) + text[chosen.end() :]


def _scaled_number(text: str, rng: np.random.Generator) -> str:
    found = [one for one in NUMBER.finditer(text) if not text[text.rfind("\n", 0, one.start()) + 1 :].startswith("#")]
    if not found:
        return text
    chosen = found[int(rng.integers(len(found)))]
    scaled = float(chosen[0]) * 10.0 ** int(rng.choice([-9, -6, -3, -1, 1, 3, 6, 9])) * float(rng.choice([1, 1, 1, -1]))
    return f"{text[: chosen.start()]}{scaled:g}{text[chosen.end() :]}"


def _other_value(text: str, rng: np.random.Generator) -> str:
    lines = text.splitlines()
    places = [place for place, line in enumerate(lines) if re.match(r"\s*(- )?[\w ]+:", line)]
    if not places:
        return text
    place = places[int(rng.integers(len(places)))]
    lines[place] = re.match(r"\s*(- )?[\w ]+:", lines[place])[0] + " " + str(rng.choice(VALUES))
    return "\n".join(lines) + "\n"


def _other_lines(text: str, rng: np.random.Generator) -> str:
    lines = text.splitlines()
    place = int(rng.integers(len(lines) + 1))
    what = int(rng.integers(4))
    if what == 0:
        lines.insert(place, str(rng.choice(LINES)))
    elif what == 1:
        del lines[place : place + int(rng.integers(1, 5))]
    elif what == 2:
        lines[place:place] = lines[place : place + int(rng.integers(1, 4))]
    elif place < len(lines):
        lines[place] = " " * int(rng.integers(0, 9)) + lines[place].lstrip()
    return "\n".join(lines) + "\n"


def _other_characters(text: str, rng: np.random.Generator) -> str:
    place = int(rng.integers(len(text) + 1))
    inserted = str(rng.choice(list("[]{}:,-&*!|>'\"%@`#\t\x00\x1b\x85é🙂 \n09eE.")))
    return text[:place] + inserted + text[place + int(rng.integers(0, 3)) :]


TEXT_MUTATIONS = (
    _scaled_number,
    _scaled_number,
    _scaled_number,
    _scaled_number,
    _other_number,
    _other_value,
    _other_lines,
    _other_characters,
)  # fmt: skip


def mutated_bytes(content: bytes, rng: np.random.Generator) -> bytes:
    """Return bytes with flips, a cut, or a part repeated."""
    changed = bytearray(content)
    what = int(rng.integers(4))
    if what == 0:
        return bytes(changed[: int(rng.integers(len(changed) + 1))])
    if what == 1:
        place = int(rng.integers(len(changed)))
        changed[place:place] = changed[place : place + int(rng.integers(1, 4000))]
        return bytes(changed)
    for place in rng.integers(len(changed), size=int(rng.integers(1, 20))):
        changed[place] = int(rng.integers(256))
    return bytes(changed)


def mutated_workbook(content: bytes, rng: np.random.Generator) -> bytes:
    """Return a workbook with a mutation of its archive, or of the XML of one part."""
    if rng.random() < 0.3:
        return mutated_bytes(content, rng)
    with zipfile.ZipFile(BytesIO(content)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    chosen = str(rng.choice([name for name in parts if "sheet" in name or "shared" in name.lower()] or [*parts]))
    xml = parts[chosen].decode()
    numbers = [*re.finditer(r"(?<=<v>)[^<]*(?=</v>)|(?<=<t>)[^<]*(?=</t>)", xml)]
    if numbers and rng.random() < 0.6:
        one = numbers[int(rng.integers(len(numbers)))]
        xml = xml[: one.start()] + str(rng.choice(NUMBERS)) + xml[one.end() :]
    elif rng.random() < 0.3:
        parts.pop(chosen)
        return _archive(parts)
    else:
        xml = mutated_bytes(xml.encode(), rng).decode("utf-8", "replace")
    return _archive({**parts, chosen: xml.encode()})


def _archive(parts: dict[str, bytes]) -> bytes:
    made = BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return made.getvalue()
