"""The result of ``torquerig differ``: what changed between two recordings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.metrics.changes.change import Change
from torquerig.metrics.changes.comparison import Changes
from torquerig.reporting.json_results.values import Interval, Missing, known

_NO_PERCENT = "what was there before does not exceed its random error"


@dataclass(frozen=True)
class TestedQuantity:
    """A line, level or band before and after; ``change`` is after minus before with its 95 % interval.

    ``smallest_seen`` is the smallest change that this test would have shown, in the same unit. ``at`` is in
    ``at_unit``; ``frequency_Hz`` is that of an order at a constant speed; a band extends to ``until``.
    """

    kind: str
    at: float
    until: float
    at_unit: str
    frequency_Hz: float | Missing  # noqa: N815 (the unit in the key)
    cause: str
    before: float
    after: float
    change: Interval
    change_percent: float | Missing
    is_change: bool
    smallest_seen: float


@dataclass(frozen=True)
class DifferResult:
    """The comparison of two recordings.

    Parameters
    ----------
    before, after : str
        Names of the recordings.
    sentences : tuple of str
        The answer.
    changed : tuple of TestedQuantity
        Changes that exceed the random error, the largest first.
    tested : tuple of TestedQuantity
        All that was tested.
    remarks : tuple of str
        What differs in the conditions, and what could not be compared.
    written : tuple of str
    """

    before: str
    after: str
    unit: str
    sentences: tuple[str, ...]
    changed: tuple[TestedQuantity, ...]
    tested: tuple[TestedQuantity, ...]
    remarks: tuple[str, ...]
    written: tuple[str, ...]


def differ_result(
    found: Changes, *, sentences: Sequence[str], remarks: Sequence[str], written: Sequence[str]
) -> DifferResult:
    """Return the result of a comparison."""
    return DifferResult(
        before=found.before.recording.name, after=found.after.recording.name, unit=found.unit,
        sentences=tuple(sentences), changed=tuple(_tested(one, found.unit) for one in found.changed),
        tested=tuple(_tested(one, found.unit) for one in found.tested), remarks=tuple(remarks),
        written=tuple(written),
    )  # fmt: skip


def _tested(one: Change, unit: str) -> TestedQuantity:
    return TestedQuantity(
        kind=one.kind, at=one.at, until=one.until, at_unit="1/rev" if one.kind == "order" else "Hz", cause=one.cause,
        frequency_Hz=known(one.frequency if one.kind == "order" else one.at, "the speed is not one constant speed"),
        before=one.before, after=one.after, change=Interval(one.difference, one.low, one.high, unit),
        change_percent=known(one.percent, _NO_PERCENT), is_change=one.is_change,
        smallest_seen=float(one.smallest_seen),
    )  # fmt: skip
