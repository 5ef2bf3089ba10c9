"""``python -m proof.real [RIG ...]``: diagnoses of the real recordings, as a table."""

from __future__ import annotations

import sys

import click

from proof.real.figures import ERROR_MEASURES, RIGS, diagnosed, figures


def main(rigs: list[str]) -> int:
    """Print the diagnosis and the held-out residuals of each rig; return 2 if recordings are missing."""
    failed = 0
    for rig in rigs or list(RIGS):
        if rig not in RIGS:
            click.echo(f"{rig!r} is not a real rig; choose from {', '.join(RIGS)}", err=True)
            return 2
        try:
            outcome = diagnosed(rig)
        except (FileNotFoundError, ValueError) as error:
            click.echo(f"{rig}: {error}", err=True)
            failed = 2
            continue
        click.echo(f"{rig}: {outcome.diagnosis.verdict}; held-out residual in {ERROR_MEASURES[rig].unit}")
        for figure in figures(rig, outcome):
            click.echo(f"  {'found' if figure.named else '':6}{figure.model:36}{figure.held_out:9.4g}")
        for finding in outcome.diagnosis.findings:
            stated = ", ".join(f"{name} {each.value:.4g} {each.unit}" for name, each in finding.parameters.items())
            click.echo(f"  {finding.mechanism}: {stated}")
        for remark in outcome.diagnosis.remarks:
            click.echo(f"  {remark}")
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
