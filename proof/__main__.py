"""``python -m proof``: blind trials of the diagnosis on rigs of an independent program, sealed and scored."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.cli import run
from torquerig.errors import InputError

if TYPE_CHECKING:
    from proof.prove.jobs import Progress


@click.command("proof")
@click.option("--seed", "seeds", type=click.IntRange(0), multiple=True, required=True,
              help="Of the trials; may be given several times.")  # fmt: skip
@click.option("--cases", type=click.IntRange(1), default=100, show_default=True, help="Rigs of each seed.")
@click.option("--out", required=True, type=click.Path(path_type=Path, file_okay=False),
              help="Folder of everything; what an earlier call left there is not done again.")  # fmt: skip
@click.option("--workers", type=click.IntRange(1), default=1, show_default=True, help="Processes.")
@click.option("--same-laws", is_flag=True, help="The same rigs once more with the reference's own laws.")
@click.option("--riddle", is_flag=True, help="The twelve rigs of the 280 Hz riddle as well.")
@click.option("--oracle-cases", type=click.IntRange(0), default=None, metavar="N",
              help="Oracle and gains of clean rigs for the first N rigs of each seed; all of them unless given. "
              "0: a third of the time.")  # fmt: skip
@click.option("--duration", type=click.FloatRange(2.0), default=12.0, show_default=True, help="Of each run, in s.")
@click.option("--practice", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
              help="Practice rigs with their answers.yaml.")  # fmt: skip
@click.option("--real", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
              help="Real recordings, one folder per source.")  # fmt: skip
def command(
    *, seeds: Sequence[int], cases: int, out: Path, workers: int, same_laws: bool, riddle: bool,
    oracle_cases: int | None, duration: float, practice: Path | None, real: Path | None,
) -> None:  # fmt: skip
    """Make blind trials, seal their answers, diagnose them, open the answers and write what came of it.

    The SHA-256 of the answers is printed before the first diagnosis starts. proof.html and proof.md in the folder hold
    every figure with its exact bounds, the baselines on the same trials, and every case that was not right.
    """
    if real is not None and not real.is_dir():
        raise InputError(f"{real}: there is no such folder; --real takes one with a folder for each real rig")
    from proof.page.proof_page import write_pages
    from proof.page.real import real_chapters
    from proof.prove.campaign import prove
    from proof.prove.plan import Plan
    from proof.scoring.lines import lines_of
    from torquerig.cli.progress import drive_progress

    plan = Plan(
        seeds=tuple(dict.fromkeys(seeds)), cases=cases, out=out, workers=workers, same_laws=same_laws, riddle=riddle,
        oracle_cases=oracle_cases, duration=duration, practice=practice, real=real,
    )  # fmt: skip
    with ExitStack() as shown:

        def stage(name: str) -> Progress:
            shown.close()
            return shown.enter_context(drive_progress(name))

        proved = prove(plan, tell=click.echo, stage=stage)
    written = write_pages(proved, more=real_chapters(plan.real))
    click.echo("\n".join(lines_of(written.summary)))
    click.echo(f"wrote {written.html} and {written.markdown}", err=True)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command; exit 0 when the proof was written, 2 with one sentence for bad input, 130 when interrupted."""
    run(command, arguments, name="python -m proof")


if __name__ == "__main__":
    main()
