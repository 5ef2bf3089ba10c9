"""Errors of the blind trials."""

from __future__ import annotations

import click


class ProofError(click.ClickException):
    """An unusable folder or file; one sentence, exit code 2."""

    exit_code = 2
