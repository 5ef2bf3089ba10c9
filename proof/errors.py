"""What can go wrong at the proof's own boundary."""

from __future__ import annotations

import click


class ProofError(click.ClickException):
    """A folder or a file is not what the proof can use; told in one sentence, exit code 2."""

    exit_code = 2
