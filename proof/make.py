"""``python -m proof.make --seed N --cases K --out FOLDER``: make blind trials and seal their answers."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

import click

from proof.errors import ProofError
from proof.riddle import draw_riddle
from proof.rig_program.draw import Case, answer_of, record_case
from proof.sealed import seal
from proof.trials import draw_trials

RECORDINGS = "recordings"


@click.command()
@click.option("--seed", type=click.IntRange(0), required=True, help="seed of the trials")
@click.option("--cases", type=click.IntRange(1), default=20, show_default=True, help="number of rigs")
@click.option("--out", type=click.Path(path_type=Path), required=True, help="folder to create")
@click.option("--answers", type=click.Path(path_type=Path), help="file for the sealed answers; default: in the folder")
@click.option(
    "--same-laws", is_flag=True, help="use the friction, contact and load laws and the integrator of the simulator"
)
@click.option("--riddle", is_flag=True, help="make the twelve rigs with a 280 Hz line instead")
@click.option(
    "--duration", type=click.FloatRange(1.0), default=12.0, show_default=True, help="length of each recording [s]"
)
@click.option("--workers", type=click.IntRange(1), default=1, show_default=True, help="number of processes")
def main(
    seed: int,
    cases: int,
    out: Path,
    *,
    answers: Path | None,
    same_laws: bool,
    riddle: bool,
    duration: float,
    workers: int,
) -> None:
    """Record rigs with none, one or two hidden effects, and seal the answers."""
    if riddle:
        drawn = draw_riddle(seed, duration=duration)
    else:
        drawn = draw_trials(seed, cases, same_laws=same_laws, duration=duration)
    digest = make_trials(drawn, out, answers=answers, workers=workers)
    click.echo(f"{len(drawn)} rigs in {out / RECORDINGS}")
    click.echo(f"answers sealed, SHA-256 {digest}")


def make_trials(cases: list[Case], out: Path, *, answers: Path | None = None, workers: int = 1) -> str:
    """Seal the answers of the cases, record the cases, and return the seal.

    Raises
    ------
    ProofError
        If the folder is not empty.
    """
    if out.exists() and any(out.iterdir()):
        raise ProofError(f"{out}: the folder is not empty; choose another folder")
    digest = seal({case.name: answer_of(case) for case in cases}, out, apart=answers)
    recorded = partial(record_case, folder=out / RECORDINGS)
    if workers == 1:
        for case in cases:
            recorded(case)
        return digest
    with ProcessPoolExecutor(workers) as pool:
        list(pool.map(recorded, cases))
    return digest


if __name__ == "__main__":
    main()
