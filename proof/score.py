"""``python -m proof.score FOLDER``: open the sealed answers and score the diagnoses in ``FOLDER/diagnoses``."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import click

from proof.scoring.lines import lines_of, wrong_lines
from proof.scoring.summary import summarise
from proof.scoring.trial import read_trials
from proof.sealed import unseal


@click.command()
@click.argument("folder", type=click.Path(path_type=Path))
@click.option("--answers", type=click.Path(path_type=Path), help="file of the sealed answers; default: in the folder")
@click.option("--json", "json_path", type=click.Path(path_type=Path), help="also write the scores to this file")
@click.option("--wrong", is_flag=True, help="list every wrong case")
def main(folder: Path, *, answers: Path | None, json_path: Path | None, wrong: bool) -> None:
    """Score a folder of blind trials with one JSON per case in its folder diagnoses."""
    trials = read_trials(unseal(folder, apart=answers), folder)
    summary = summarise(trials)
    click.echo("\n".join(lines_of(summary)))
    if wrong:
        click.echo("\n".join(["", "wrong:", *wrong_lines(trials)]))
    if json_path is not None:
        json_path.write_text(json.dumps(asdict(summary), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
