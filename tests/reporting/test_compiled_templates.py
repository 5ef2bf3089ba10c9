"""Compiled templates: read where they fit, made anew where they do not, and no obstacle where none can be written."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from jinja2 import Environment, FileSystemLoader

from torquerig.reporting.compiled_templates import DIGEST, CompiledTemplates


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(sys, "pycache_prefix", None)
    (tmp_path / "one.html").write_text("{{ name }} 1")
    return tmp_path


def rendered(place: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[str, int]:
    """Return the page, and how many templates were compiled for it."""
    compiled: list[str] = []
    environment = Environment(loader=FileSystemLoader(place), bytecode_cache=CompiledTemplates(place))
    real = environment._generate
    monkeypatch.setattr(environment, "_generate", lambda *given, **named: compiled.append("") or real(*given, **named))
    return environment.get_template("one.html").render(name="page"), len(compiled)


def held(place: Path) -> list[Path]:
    return list((place / "__pycache__").iterdir())


def test_a_template_is_compiled_once(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert rendered(place, monkeypatch) == ("page 1", 1)
    assert rendered(place, monkeypatch) == ("page 1", 0)
    assert len(held(place)) == 1


def test_a_changed_template_is_compiled_again(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rendered(place, monkeypatch)
    (place / "one.html").write_text("{{ name }} 2")
    assert rendered(place, monkeypatch) == ("page 2", 1)
    assert rendered(place, monkeypatch) == ("page 2", 0)


@pytest.mark.parametrize("damage", [lambda one: one[:-1], lambda one: one[:DIGEST], lambda one: b"",
                                    lambda one: one[:-9] + b"\0" + one[-8:]])  # fmt: skip
def test_a_damaged_file_is_made_again(place: Path, monkeypatch: pytest.MonkeyPatch, damage) -> None:
    rendered(place, monkeypatch)
    (file,) = held(place)
    whole = file.read_bytes()
    file.write_bytes(damage(whole))
    assert rendered(place, monkeypatch) == ("page 1", 1)
    assert file.read_bytes() == whole


def test_a_folder_that_takes_no_file_is_no_obstacle(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (place / "__pycache__").write_text("in the way")
    assert rendered(place, monkeypatch) == ("page 1", 1)
    assert rendered(place, monkeypatch) == ("page 1", 1)


def test_nothing_is_written_where_python_shall_write_nothing(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert rendered(place, monkeypatch) == ("page 1", 1)
    assert not (place / "__pycache__").exists()
