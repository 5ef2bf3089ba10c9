"""Bare text: two columns of numbers, time [s] and volts, as in the reference report, Appendix A."""

from __future__ import annotations

from pathlib import Path

from torquerig.recordings.files.csv import read_csv
from torquerig.recordings.files.number_table import Table


def read_text(path: Path) -> Table:
    """Read a text file of two columns, ``time_s`` and ``torque_V``; a single column is the volts.

    Blanks, tabs, commas or semicolons separate the columns. A text file with a header is read like a CSV file.

    Source: the reference report, Appendix A, lines 1-2 (``time``, ``volt``, 1 V = 1 N m).
    """
    return read_csv(path)
