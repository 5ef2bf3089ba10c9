"""Old names that are still read, each with one notice on standard error."""

from __future__ import annotations

import sys
from collections.abc import Mapping

_NOTED: set[tuple[str, str]] = set()


def current_name(written: str, renamed: Mapping[str, str], *, what: str) -> str:
    """Return the present name of ``written``; an old name gives one notice on standard error per process.

    Parameters
    ----------
    written : str
        Name as a user wrote it.
    renamed : mapping of str to str
        Present name by old name.
    what : str
        Kind of the name in the notice: ``command``, ``filter chain``.
    """
    if written not in renamed:
        return written
    if (what, written) not in _NOTED:
        _NOTED.add((what, written))
        sys.stderr.write(f"torquerig: notice: the {what} {written} is now named {renamed[written]}\n")
    return renamed[written]
