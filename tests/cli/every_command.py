"""All commands of the command line, those below a group too."""

from __future__ import annotations

import click


def every_command(command: click.Command, path: tuple[str, ...] = ()) -> dict[tuple[str, ...], click.Command]:
    """Return all commands below a group by their words; a group that runs by itself too."""
    if not isinstance(command, click.Group):
        return {path: command}
    found = {path: command} if path and command.invoke_without_command else {}
    context = click.Context(command)
    for name in command.list_commands(context):
        below = command.get_command(context, name)
        assert below is not None
        found |= every_command(below, (*path, name))
    return found
