"""``python -m proof fleet``: rounds of the referee on rigs of the fleet."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.errors import InputError

if TYPE_CHECKING:
    from proof.prove.jobs import Progress


@click.command("fleet")
@click.option(
    "--seed", type=click.IntRange(0), required=True, help="Seed of all sets; 7001 to 7099 are for development."
)
@click.option(
    "--set",
    "chosen",
    multiple=True,
    metavar="NAME[:COUNT]",
    help="Set, with its number of cases; can be repeated. Default: all sets.",
)
@click.option("--quick", is_flag=True, help="A tenth of every set.")
@click.option(
    "--out",
    required=True,
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder of all results; what is finished there is kept.",
)
@click.option("--workers", type=click.IntRange(1), default=1, show_default=True, help="Number of processes.")
@click.option(
    "--limit", type=click.FloatRange(min=1.0), default=600.0, show_default=True, help="Time limit of one diagnosis [s]."
)
@click.option("--make-only", is_flag=True, help="Record and seal, do not diagnose.")
@click.option(
    "--option",
    "options",
    multiple=True,
    metavar="OPTION",
    help="Further option of torquerig diagnose; can be repeated.",
)
@click.option("--label", default="", metavar="NAME",
              help="Folder of the results within --out, so that several versions share the recordings.")  # fmt: skip
@click.option(
    "--real",
    type=click.Path(path_type=Path),
    default=None,
    metavar="FOLDER",
    help="Folder of real recordings, one subfolder per bench.",
)
def command(
    *, seed: int, chosen: Sequence[str], quick: bool, out: Path, workers: int, limit: float, make_only: bool,
    options: Sequence[str], label: str, real: Path | None,
) -> None:  # fmt: skip
    """Draw rigs of the fleet, seal their answers, diagnose the recordings and count what is right."""
    from proof.referee.page import reason
    from proof.referee.running import Round, diagnose_all, make, selected, written
    from torquerig.cli.progress import drive_progress

    if real is not None and not real.is_dir():
        raise InputError(f"{real}: there is no such folder; --real needs a folder with one subfolder per bench")
    plan = Round(
        selected(chosen, quick=quick), seed, out, workers=workers, limit=limit, options=tuple(options), label=label
    )
    with ExitStack() as shown:

        def stage(name: str) -> Progress:
            shown.close()
            return shown.enter_context(drive_progress(name))

        seal = make(plan, stage=stage)
        shown.close()
        click.echo(f"answers sealed, SHA-256 {seal}")
        if make_only:
            return
        diagnose_all(plan, stage=stage)
    verdicts, files = written(plan, seal)
    right = sum(one.exact for one in verdicts)
    click.echo(f"{right} of {len(verdicts)} cases exactly right")
    click.echo("\n".join(f"{one.name}: {reason(one)}" for one in verdicts if not one.exact))
    if real is not None:
        from proof.referee.real_benches import real_lines

        click.echo("\n".join(real_lines(real, out, limit=limit, options=tuple(options), label=label)))
    click.echo(f"wrote {files.html}, {files.markdown} and {files.csv}", err=True)
