"""``python -m proof``: blind trials of the diagnosis on rigs of an independent program, with sealed answers."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.cli import run

if TYPE_CHECKING:
    from proof.prove.jobs import Progress


@click.command("proof")
@click.option("--seed", "seeds", type=click.IntRange(0), multiple=True, required=True,
              help="Seed of a set of trials; can be repeated.")  # fmt: skip
@click.option("--cases", type=click.IntRange(1), default=100, show_default=True, help="Number of rigs per seed.")
@click.option("--out", required=True, type=click.Path(path_type=Path, file_okay=False),
              help="Folder of all results; finished cases of an earlier call are kept.")  # fmt: skip
@click.option("--workers", type=click.IntRange(1), default=1, show_default=True, help="Number of processes.")
@click.option(
    "--same-laws", is_flag=True, help="Repeat the rigs with the friction, contact and load laws of the simulator."
)
@click.option("--riddle", is_flag=True, help="Add twelve rigs with a 280 Hz line: mesh, comb or resonance.")
@click.option("--oracle-cases", type=click.IntRange(0), default=None, metavar="N",
              help="Run the oracle for the first N rigs of each seed; default: all. "
              "0 saves two thirds of the time.")  # fmt: skip
@click.option(
    "--duration", type=click.FloatRange(2.0), default=12.0, show_default=True, help="Length of each recording [s]."
)
@click.option("--practice", type=click.Path(path_type=Path), default=None, metavar="FOLDER",
              help="Folder of practice rigs with answers.yaml.")  # fmt: skip
def command(
    *, seeds: Sequence[int], cases: int, out: Path, workers: int, same_laws: bool, riddle: bool,
    oracle_cases: int | None, duration: float, practice: Path | None,
) -> None:  # fmt: skip
    """Record blind trials, seal the answers, diagnose the recordings, open the answers and write the scores.

    The SHA-256 of the answers is printed before the first diagnosis. The files proof.html and proof.md hold all scores
    with exact confidence bounds, the baselines on the same trials, and every wrong case.

    `python -m proof fleet` does the same for drawn rigs of many designs; see its --help.
    """
    from proof.page.proof_page import write_pages
    from proof.prove.campaign import prove
    from proof.prove.plan import Plan
    from proof.scoring.lines import lines_of
    from torquerig.cli.progress import drive_progress

    plan = Plan(
        seeds=tuple(dict.fromkeys(seeds)), cases=cases, out=out, workers=workers, same_laws=same_laws, riddle=riddle,
        oracle_cases=oracle_cases, duration=duration, practice=practice,
    )  # fmt: skip
    with ExitStack() as shown:

        def stage(name: str) -> Progress:
            shown.close()
            return shown.enter_context(drive_progress(name))

        proved = prove(plan, report=click.echo, stage=stage)
    written = write_pages(proved)
    click.echo("\n".join(lines_of(written.summary)))
    click.echo(f"wrote {written.html} and {written.markdown}", err=True)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command; exit 0 if the results were written, 2 with one sentence for bad input, 130 if interrupted."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words[:1] == ["fleet"]:
        from proof.referee.command import command as fleet

        run(fleet, words[1:], name="python -m proof fleet")
        return
    run(command, words, name="python -m proof")


if __name__ == "__main__":
    main()
