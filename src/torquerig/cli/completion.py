"""``torquerig completion``: the script with which a shell completes commands, options, names and files."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

SHELLS = ("bash", "zsh", "fish")
VARIABLE = "_TORQUERIG_COMPLETE"  # what click looks for in the environment of a program of this name


@click.command("completion")
@click.argument("shell", type=click.Choice(SHELLS))
def command(shell: str) -> None:
    """Print the completion script of SHELL.

    Bash: add `eval "$(torquerig completion bash)"` to ~/.bashrc. Zsh: the same with zsh in ~/.zshrc. Fish: write it to
    ~/.config/fish/completions/torquerig.fish.

    Example: torquerig completion bash
    """
    from torquerig.cli import group

    kind = get_completion_class(shell)
    assert kind is not None  # click has these three
    # the text of click's own template; source() of bash would start a bash to check its version
    made = kind(group, {}, "torquerig", VARIABLE)
    click.echo(made.source_template % made.source_vars())
