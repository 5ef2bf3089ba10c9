"""The command line: one command per file, each imported only when it is called.

init  catalog  orders  ordermap  modes  simulate  duty  size  synth  info  filter  matrix  diagnose
reference-results  reference-decision  compare
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module

import click

from torquerig.errors import TorquerigError
from torquerig.version import __version__

COMMANDS = {
    "init": "copy the shipped catalogs and scenarios into a folder of your own",
    "catalog": "show what can be bought, with what is known and what is not",
    "orders": "show where the lines of a motor and gearbox stand, and which coincide",
    "ordermap": "show a recording's lines over the order of its shaft, told from fixed frequencies",
    "modes": "show at what frequencies a rig rings, its speed loop's margins, and which line meets which mode",
    "simulate": "simulate one rig and write what its sensor records",
    "duty": "tell what a duty cycle asks of a motor and how hot it becomes",
    "size": "tell whether motor, gearbox and sensor are large enough for a duty cycle",
    "synth": "make test signals whose every part is known",
    "info": "show what is in a recording",
    "filter": "put a recording through filter chains and say what they changed",
    "matrix": "work out elimination, Pugh and Kesselring matrices and what is wrong with them",
    "diagnose": "say where recordings and model differ, and which physics was left out",
    "reference-results": "set the simulated rig beside the reference report's tables and figures",
    "reference-decision": "make the reference report's motor decision again, cell by cell beside its tables",
    "compare": "simulate and rank every motor x gearbox x filter of a study",
}
_RENAMED = {"seed-results": "reference-results", "seed-decision": "reference-decision"}


class _Lazy(click.Group):
    """A group that imports a command's file when it is called, so that --help is instant."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = import_module(f"torquerig.cli.{cmd_name.replace('-', '_')}").command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from torquerig.errors import did_you_mean
        from torquerig.renamed import current_name

        args = [current_name(word, _RENAMED, what="command") for word in args[:1]] + args[1:]
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            ctx.fail(f"there is no command {args[0]!r}; {did_you_mean(args[0], COMMANDS)}")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


@click.group(cls=_Lazy, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="torquerig")
def group() -> None:
    """Tell what a torque sensor will read, what disturbs it, and which drive to buy.

    Start with: torquerig compare scenarios/wear_rig.yaml
    """


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line; exit 0 when it went well, 2 with one sentence for bad input, 130 when interrupted."""
    run(group, arguments, name="torquerig")


def run(command: click.Command, arguments: Sequence[str] | None, *, name: str) -> None:
    """Run a command by this name; exit 0 when it went well, 2 with one sentence for bad input, 130 when interrupted."""
    try:
        command.main(args=None if arguments is None else list(arguments), prog_name=name, standalone_mode=False)
    except TorquerigError as error:
        _say(f"torquerig: {error}")
        sys.exit(2)
    except click.exceptions.NoArgsIsHelpError as error:
        _say(error.format_message())
        sys.exit(2)
    except click.ClickException as error:
        _say(f"torquerig: {_sentence(error)}")
        sys.exit(2)
    except (KeyboardInterrupt, click.Abort):
        _say("torquerig: interrupted; nothing was left half-written")
        sys.exit(130)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(0)


def _sentence(error: click.ClickException) -> str:
    """Return a usage error in one sentence, with the help that would answer it."""
    told = error.format_message().rstrip(".")
    told = told[0].lower() + told[1:]
    context = error.ctx if isinstance(error, click.UsageError) else None
    return f"{told}; see {context.command_path} --help" if context and "did you mean" not in told.lower() else told


def _say(text: str) -> None:
    click.echo(text, err=True)
