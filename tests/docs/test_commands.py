"""Every ``torquerig`` command that the README and the docs print is one that the command line takes."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from torquerig.cli import group

ROOT = Path(__file__).resolve().parents[2]
PAGES = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
FENCED = re.compile(r"^```\w*\n(.*?)^```", re.MULTILINE | re.DOTALL)
INLINE = re.compile(r"`(torquerig [^`]+)`")
PROGRAM = re.compile(r"^(?:\S*[/\\])?torquerig(?:\.exe)?$")


def commands_of(page: Path) -> Iterator[list[str]]:
    """Yield the arguments of each command of a page: in fenced blocks, and in code within a line."""
    text = page.read_text(encoding="utf-8")
    blocks = [block.replace("\\\n", " ") for block in FENCED.findall(text)]
    lines = [line for block in blocks for line in block.splitlines()] + INLINE.findall(FENCED.sub("", text))
    for line in lines:
        for one in re.split(r"&&|;|\|\|", line):
            words = one.split(maxsplit=1)
            if words and PROGRAM.match(words[0]):
                yield shlex.split(one.replace("\\", "/"), comments=True)[1:]


def parsed(arguments: list[str]) -> click.Context:
    """Return the context of a command line that has been read, options and all, and not run."""
    with click.Context(group) as context:
        name, command, rest = group.resolve_command(context, arguments)
        assert command is not None
        return command.make_context(name, list(rest), parent=context)


PRINTED = [(page.name, arguments) for page in PAGES for arguments in commands_of(page) if arguments != ["--help"]]


@pytest.mark.parametrize(
    ("page", "arguments"), PRINTED, ids=[f"{page} {' '.join(arguments)}" for page, arguments in PRINTED]
)
def test_printed_command_is_one_that_the_command_line_takes(page: str, arguments: list[str]) -> None:
    if len(arguments) == 1:  # `torquerig compare` in a sentence names the command
        assert group.get_command(click.Context(group), arguments[0]) is not None
        return
    parsed(arguments)


def test_the_pages_print_commands_at_all() -> None:
    found = {page for page, _ in PRINTED}
    assert {"README.md", "tutorial.md", "howto-add-a-motor.md", "howto-describe-your-own-rig.md"} <= found
    assert {arguments[0] for _, arguments in PRINTED} >= {"init", "compare", "orders", "simulate", "info", "filter"}


@pytest.mark.parametrize(
    "wrong", [["compare", "x.yaml", "--sett", "a=1"], ["orders", "--harmonics", "0"], ["filter"], ["init", "a", "b"]]
)
def test_a_wrong_command_is_found(wrong: list[str]) -> None:
    with pytest.raises(click.UsageError):
        parsed(wrong)
