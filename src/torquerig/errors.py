"""Errors of inputs: five types, each one sentence with a place and a remedy.

An outcome of an analysis ("nothing is missing", "the motor cannot reach the speed") is a result and never raised.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


class TorquerigError(Exception):
    """Base of the five; the command line prints it unchanged and exits with code 2."""


class InputError(TorquerigError):
    """A file, key, option or value that cannot be used: with its place and what to write instead."""


class UnitError(TorquerigError):
    """A quantity without a unit, with an unknown one, or with one of another kind."""


class UnknownNameError(TorquerigError):
    """An unknown name; lists the close matches."""


class RecordingError(TorquerigError):
    """A recording that cannot be used: no samples, not-a-number samples, missing or wrong channels."""


class SimulationError(TorquerigError):
    """A run that cannot be integrated: names the node, the time and the reason."""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return the remedy for an unknown name: the close matches, or else all known names."""
    names = sorted(set(known))
    close = get_close_matches(name.lower(), [known.lower() for known in names], n=3, cutoff=0.6)
    hits = [known for known in names if known.lower() in close]
    if hits:
        return f"did you mean {' or '.join(repr(hit) for hit in hits)}?"
    return f"known are {', '.join(names)}" if names else "there are no names to choose from"
