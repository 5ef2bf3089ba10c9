"""``python -m proof.confidence_fit FOLDER ...``: fit the coefficients of a finding's confidence to blind trials.

Each folder holds opened trials and their diagnoses. The seeds must not be those of a published page.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click
import numpy as np
from scipy.optimize import minimize

from proof.scoring.trial import read_trials
from proof.sealed import unseal
from torquerig.diagnosis.choosing.confidence import COEFFICIENTS, terms

_PRIOR_SD = 1.0  # [1] of each coefficient about the present one: with few wrong findings a free fit diverges


@click.command()
@click.argument("folders", type=click.Path(path_type=Path), nargs=-1, required=True)
def main(folders: tuple[Path, ...]) -> None:
    """Fit the logistic confidence to the right and wrong findings."""
    rows = [row for folder in folders for row in _rows(folder)]
    values, right = np.array([row[0] for row in rows]), np.array([row[1] for row in rows], dtype=np.float64)
    present = np.array(COEFFICIENTS)

    def loss(coefficients: np.ndarray) -> float:
        score = values @ coefficients
        fit = np.logaddexp(0.0, score) - right * score
        return float(fit.sum() + 0.5 * (((coefficients - present) / _PRIOR_SD) ** 2).sum())

    found = minimize(loss, present).x
    click.echo(f"{len(rows)} findings, {int(right.sum())} right")
    click.echo("COEFFICIENTS = (" + ", ".join(f"{each:.2f}" for each in found) + ")")


def _rows(folder: Path) -> Iterator[tuple[tuple[float, ...], bool]]:
    """Yield the terms of every fitted finding, and whether it was right."""
    for trial in read_trials(unseal(folder), folder):
        path = folder / "diagnoses" / f"{trial.name}.json"
        if trial.claim is None or not path.is_file():
            continue
        findings = json.loads(path.read_text(encoding="utf-8"))["findings"]
        for finding, match in zip(findings, trial.matches, strict=True):
            evidence = finding.get("evidence") or {}
            if finding["mechanism"] in ("clipping", "quantization", "signal_dropout") or not evidence:
                continue
            best_other = max((each["gain"] for each in finding["alternatives"]), default=0.0)
            yield terms(gain=evidence["gain"], share=evidence["share"], rival=best_other), match.effect is not None


if __name__ == "__main__":
    main()
