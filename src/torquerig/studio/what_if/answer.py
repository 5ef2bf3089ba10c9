"""What a what-if shows: reading errors, lines with their causes, sizing, and the plots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, kw_only=True)
class LineRow:
    """A line of the reading: cause, output order [1/rev], frequency [Hz], amplitudes before and after [N m]."""

    cause: str
    family: str
    order: float
    frequency: float
    before: float
    after: float


@dataclass(frozen=True, kw_only=True)
class Simulated:
    """What the sensor of the changed rig records.

    Parameters
    ----------
    title : str
        Motor, ratio and operating point.
    unit : str
        Of what is measured: ``N*m``, or ``N`` in a line.
    mean, std : float
        Of the unfiltered reading [``unit``].
    error_before, error_after : float or None
        Rms of the reading minus the true load, without and with the filter [``unit``]; None where no load is known.
    lines : tuple of LineRow
        Largest first; empty for a run that is not steady.
    left_out : tuple of str
        Lines that the filter chain names and this drive does not have.
    warnings : tuple of str
        What is doubtful of the run.
    signal, spectrum : mapping
        For the page.
    """

    title: str
    unit: str
    mean: float
    std: float
    error_before: float | None
    error_after: float | None
    lines: tuple[LineRow, ...]
    left_out: tuple[str, ...]
    warnings: tuple[str, ...]
    signal: Mapping[str, Any] = field(repr=False)
    spectrum: Mapping[str, Any] = field(repr=False)


@dataclass(frozen=True, kw_only=True)
class Sized:
    """Whether the changed drive is large enough.

    Parameters
    ----------
    verdict : str
        ``holds``, ``exceeds``, ``unsure`` or ``unknown``.
    sentence : str
    rows : tuple of tuple of str
        A header, then a row per figure.
    values : mapping of str to float
        The figures with one value, by their names, in SI units.
    """

    verdict: str
    sentence: str
    rows: tuple[tuple[str, ...], ...]
    values: Mapping[str, float]
