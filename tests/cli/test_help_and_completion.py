"""Every help text has an example that the command line takes; shells complete commands, options, names and files."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import click
import pytest

from tests.cli.every_command import every_command
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.cli import COMMANDS, group, main

EVERY = every_command(group)


def example_of(command: click.Command) -> list[str]:
    """Return the words of the example in a help text, without the name of the program."""
    _, found, text = (command.help or "").partition("Example: ")
    assert found, command.name
    words = shlex.split(text.split("\n\n")[0])
    assert words[0] == "torquerig"
    return words[1:]


@pytest.mark.parametrize("path", EVERY, ids=" ".join)
def test_every_help_text_has_an_example_that_the_command_takes(path: tuple[str, ...]) -> None:
    words = example_of(EVERY[path])
    assert words[: len(path)] == list(path)
    context: click.Context = click.Context(group, info_name="torquerig")
    command: click.Command = group
    while isinstance(command, click.Group):
        name, found, words = command.resolve_command(context, words)
        assert found is not None
        command = found
        if isinstance(command, click.Group):
            context = click.Context(command, parent=context, info_name=name)
    made = command.make_context(command.name, list(words), parent=context)
    assert made.command.name == command.name


def completed(words: str, incomplete: str, folder: Path) -> list[str]:
    """Return what bash offers after the words; the last word is what is already written of it."""
    line = f"torquerig {words} ".replace("  ", " ")
    count = len(shlex.split(line))
    environment = {
        **os.environ, "_TORQUERIG_COMPLETE": "bash_complete", "COMP_WORDS": line + incomplete,
        "COMP_CWORD": str(count),
    }  # fmt: skip
    script = "from torquerig.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False, env=environment, cwd=folder
    )
    assert done.stderr == ""
    return [line.partition(",")[2] or line for line in done.stdout.splitlines()]


def test_commands_options_and_names_are_completed(tmp_path: Path) -> None:
    assert set(completed("", "", tmp_path)) == set(COMMANDS)
    assert completed("ordermap", "--scen", tmp_path) == ["--scenario"]
    (tmp_path / "catalogs" / "motors").mkdir(parents=True)
    (tmp_path / "catalogs" / "motors" / "my-motor.yaml").write_text("name: my-motor\n", encoding="utf-8")
    assert completed("simulate x.yaml --motor", "my", tmp_path) == ["my-motor"]
    assert "bldc-12n14p" in completed("simulate x.yaml --motor", "", tmp_path)
    assert "reference-5-1" in completed("filter x.csv --gearbox", "ref", tmp_path)
    assert "order_lines_low_pass" in completed("filter x.csv --chain", "order", tmp_path)
    assert completed("catalog show", "T22", tmp_path) == ["T22-10nm"]
    assert completed("schema", "scen", tmp_path) == ["scenario"]


def test_a_shell_completes_files_itself(tmp_path: Path) -> None:
    environment = {
        **os.environ, "_TORQUERIG_COMPLETE": "bash_complete", "COMP_WORDS": "torquerig info ru", "COMP_CWORD": "2"
    }  # fmt: skip
    script = "from torquerig.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, env=environment, cwd=tmp_path
    )
    assert done.stdout.split() == ["file,ru"]


def test_names_of_files_are_names_of_entries() -> None:
    """The completion lists the names of files, so that it need not read the catalog."""
    catalog = load_catalog(shipped_folder())
    for shelf in ("motors", "gearboxes", "sensors", "couplings", "classes"):
        assert {path.stem for path in (shipped_folder() / shelf).glob("*.yaml")} == set(getattr(catalog, shelf))


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_each_shell_calls_torquerig(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    main(["completion", shell])
    script = capsys.readouterr().out
    assert "_TORQUERIG_COMPLETE" in script
    assert "torquerig" in script
    if shutil.which(shell):
        flag = ["-n"] if shell != "fish" else ["--no-execute"]
        done = subprocess.run([shell, *flag], input=script, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


def test_an_unknown_shell_is_one_sentence(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["completion", "cmd"])
    assert left.value.code == 2
    assert "'bash', 'zsh', 'fish'" in capsys.readouterr().err
