"""The command line: one command per file, each imported only when it is called.

init  catalog  orders  ordermap  modes  simulate  duty  size  synth  info  sheet  join  filter  matrix  diagnose  differ
batch  cache  schema  completion  reference-results  reference-decision  study  optimise  studio  compare
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Sequence
from importlib import import_module

import click

from torquerig.errors import TorquerigError
from torquerig.harmless import harmless
from torquerig.version import __version__

COMMANDS = {
    "init": "copy the shipped catalogs and scenarios into a folder",
    "catalog": "list motors, gearboxes, sensors and couplings with their known values",
    "orders": "list the order lines of a motor and gearbox, and which coincide",
    "ordermap": "separate the order lines of a recording from its fixed frequencies",
    "modes": "compute natural frequencies, stability margins and critical speeds of a rig",
    "simulate": "simulate one rig and write the recording of its sensor",
    "duty": "compute torque, speed and winding temperature of a motor over a duty cycle",
    "size": "check whether motor, gearbox and sensor are large enough for a duty cycle",
    "synth": "make test signals from known components, or with known faults",
    "info": "show channels, levels and faults of recordings",
    "sheet": "draft the sidecar of a recording: units, scales and test conditions",
    "join": "bring columns of several rates or files to one recording",
    "filter": "apply filter chains to a recording and show their effect",
    "matrix": "compute elimination, Pugh and Kesselring matrices and check them for errors",
    "diagnose": "find physics that recordings show and the model of the rig lacks",
    "differ": "find what changed between two recordings of one rig",
    "batch": "run filter, ordermap or info on every recording of a folder",
    "cache": "show or clear the results that are kept between calls",
    "schema": "print the JSON Schema of a file, for editors and other programs",
    "completion": "print the script with which a shell completes commands, names and files",
    "reference-results": "compare the simulated rig with the results of the reference report",
    "reference-decision": "compute the motor decision of the reference report again, cell by cell",
    "study": "repeat a study for many draws of what data sheets leave open",
    "optimise": "find the best gearbox, speed loop and filter for one motor",
    "studio": "open a local page that answers what-if questions",
    "compare": "simulate and rank every motor x gearbox x filter of a study",
}
MOST_NEW_OBJECTS = 50_000  # before unused objects are sought: 700 would take 0.1 s of a short command
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
    """Simulate, filter, compare and diagnose rigs that measure torque.

    Start with: torquerig compare scenarios/wear_rig.yaml
    """


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line; exit code 0 on success, 2 with one sentence for bad input, 130 when interrupted."""
    run(group, arguments, name="torquerig")


def run(command: click.Command, arguments: Sequence[str] | None, *, name: str) -> None:
    """Run a command by this name; exit codes as in :func:`main`."""
    from torquerig.cli.console import close_output, harmless_streams, system_sentence

    gc.set_threshold(MOST_NEW_OBJECTS)
    try:
        with harmless_streams():
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
    except (KeyboardInterrupt, click.Abort) as stop:  # click raises its Abort from what stopped the command
        what = next(
            (str(one) for one in (stop, stop.__cause__) if str(one or "")), "interrupted; no file is incomplete"
        )
        _say(f"torquerig: {what}")
        sys.exit(130)
    except OSError as error:
        close_output()
        _say(f"torquerig: {system_sentence(error)}")
        sys.exit(2)
    except MemoryError:
        _say("torquerig: there is not enough memory for this; shorten the recording or run, or close other programs")
        sys.exit(2)


def _sentence(error: click.ClickException) -> str:
    """Return a usage error in one sentence, with the help command to read."""
    message = error.format_message().rstrip(".")
    message = message[0].lower() + message[1:]
    context = error.ctx if isinstance(error, click.UsageError) else None
    if context is None or "did you mean" in message.lower():
        return message
    return f"{message}; see {context.command_path} --help"


def _say(text: str) -> None:
    click.echo(harmless(text), err=True)
