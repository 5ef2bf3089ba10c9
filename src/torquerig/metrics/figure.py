"""Figure: a value with its interval, unit and source."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from torquerig.parameter import Estimate

if TYPE_CHECKING:
    from torquerig.catalog.entry import Fact


@dataclass(frozen=True, kw_only=True)
class Figure:
    """One metric of one alternative.

    Parameters
    ----------
    value : float or None
        [unit]; None where only the interval, or nothing, is known.
    low, high : float or None
        The interval [unit]; None where the value is certain or nothing is known.
    unit : str
    source : str
        A catalog field with its source, or the simulation.
    missing : str
        The missing values, where the figure is unknown or an interval.
    rests_on : tuple of (str, Estimate)
        The catalog values that it was calculated from, by name.
    """

    value: float | None = None
    low: float | None = None
    high: float | None = None
    unit: str = "1"
    source: str = ""
    missing: str = ""
    rests_on: tuple[tuple[str, Estimate], ...] = field(default=(), repr=False, compare=False)

    @property
    def unknown(self) -> bool:
        """Whether nothing is known."""
        return self.value is None and self.low is None

    def shown(self) -> str:
        """Return the text for a table: ``1.27``, ``0.12..0.31`` or ``?``."""
        if self.unknown:
            return "?"
        if self.low is not None and self.high is not None and self.low < self.high:
            low, high = _plain(self.low), _plain(self.high)
            interval = low if low == high else f"{low}..{high}"
            return interval if self.value is None or low == high else f"{_plain(self.value)} ({interval})"
        return f"{self.low if self.value is None else self.value:.4g}"


def _plain(number: float) -> str:
    """Return three digits, and whole thousands without an exponent."""
    text = f"{number:.3g}"
    return f"{float(text):.0f}" if "e+" in text else text


def scaled(estimate: Estimate, factor: float, *, unit: str, missing: str, inverse: bool = False) -> Figure:
    """Return ``factor * estimate`` (or ``factor / estimate``); an estimate stays an interval without a value.

    ``missing`` names the estimate.
    """
    rests_on = ((missing, estimate),)
    if estimate.unknown:
        return Figure(unit=unit, source=estimate.source, missing=missing, rests_on=rests_on)
    source = f"{estimate.source} ({estimate.evidence})"
    low, high = sorted((factor / end if inverse else factor * end) for end in estimate.bounds)
    if estimate.documented and estimate.value is not None:
        value = factor / estimate.value if inverse else factor * estimate.value
        return Figure(value=value, unit=unit, source=source, rests_on=rests_on)
    return Figure(low=low, high=high, unit=unit, source=source, missing=missing, rests_on=rests_on)


def yes_no(fact: Fact | None, missing: str) -> Figure:
    """Return 1 or 0 for a fact of the catalog; unknown, with the missing fact, where it is not stated."""
    if fact is None:
        return Figure(missing=missing, rests_on=((missing, Estimate()),))
    value, source = float(fact.value), f"{fact.source} ({fact.evidence})"
    known = Estimate(value, evidence=fact.evidence, source=fact.source)
    return Figure(value=value, source=source, rests_on=((missing, known),))


def total(figures: list[Figure], *, unit: str) -> Figure:
    """Return the sum of figures; unknown if one of them is, because a sum without it would be too small."""
    rests_on = tuple(dict.fromkeys(one for figure in figures for one in figure.rests_on))
    if any(figure.unknown for figure in figures):
        missing = ", ".join(figure.missing for figure in figures if figure.unknown)
        return Figure(unit=unit, missing=missing, rests_on=rests_on)
    lows = [figure.value if figure.low is None else figure.low for figure in figures]
    highs = [figure.value if figure.high is None else figure.high for figure in figures]
    low, high = (sum(end for end in ends if end is not None) for ends in (lows, highs))
    source = "; ".join(dict.fromkeys(figure.source for figure in figures if figure.source))
    if low == high:
        return Figure(value=low, unit=unit, source=source, rests_on=rests_on)
    missing = ", ".join(figure.missing for figure in figures if figure.low is not None)
    return Figure(low=low, high=high, unit=unit, source=source, missing=missing, rests_on=rests_on)
