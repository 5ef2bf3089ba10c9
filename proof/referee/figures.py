"""Figures of a set: counted shares with exact bounds, sizes, calibration, chi-square."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from proof.referee.judging import Size, Verdict
from proof.scoring.calibration import calibration_of
from proof.scoring.summary import Share


@dataclass(frozen=True)
class SizeFigures:
    """Number of sizes, median relative error, share of 95 % intervals that hold the truth, median half-width."""

    count: int
    error: float
    covered: Share
    half_width: float | None


@dataclass(frozen=True)
class SetFigures:
    """All figures of one set; ``groups`` has exactly right, and with a false name, by kind of case."""

    name: str
    cases: int
    answered: Share
    exact: Share
    false_names: Share
    accused: Share
    located: Share
    modelled: Share
    setup_reported: Share
    unchanged: Share
    sizes: SizeFigures | None
    calibration_error: float | None
    findings: int
    chi_square: float | None
    groups: Mapping[str, tuple[Share, Share]]


def figures_of(name: str, verdicts: Sequence[Verdict]) -> SetFigures:
    """Return the figures of the verdicts of one set, or of several together."""
    calibration = calibration_of(pair for one in verdicts for pair in one.confidences)
    chi_squares = [one.clean_chi_square for one in verdicts if one.clean_chi_square is not None]
    groups = sorted({one.group for one in verdicts})
    return SetFigures(
        name=name,
        cases=len(verdicts),
        answered=_share(verdicts, lambda one: bool(one.said)),
        exact=_share(verdicts, lambda one: one.exact),
        false_names=_share(verdicts, lambda one: bool(one.false_names)),
        accused=_share(verdicts, lambda one: one.accused),
        located=_share(verdicts, lambda one: one.located),
        modelled=_share(verdicts, lambda one: one.modelled),
        setup_reported=_share(verdicts, lambda one: one.setup_reported),
        unchanged=_share(verdicts, lambda one: unchanged(one, verdicts)),
        sizes=size_figures([size for one in verdicts for size in one.sizes]),
        calibration_error=None if calibration is None else calibration.expected_error,
        findings=0 if calibration is None else calibration.count,
        chi_square=float(np.mean(chi_squares)) if chi_squares else None,
        groups={group: _pair([one for one in verdicts if one.group == group]) for group in groups},
    )


def size_figures(sizes: Sequence[Size]) -> SizeFigures | None:
    """Return the figures of sizes, or None without any."""
    if not sizes:
        return None
    known = [one.covered for one in sizes if one.covered is not None]
    widths = [one.half_width for one in sizes if one.half_width is not None]
    return SizeFigures(
        count=len(sizes),
        error=float(np.median([one.error for one in sizes])),
        covered=Share(sum(known), len(known)),
        half_width=float(np.median(widths)) if widths else None,
    )


def unchanged(one: Verdict, verdicts: Sequence[Verdict]) -> bool | None:
    """Return whether a changed case has the answer of the rig as it is; None where there is no pair of answers."""
    if not one.change or one.change == "as_is":
        return None
    rig = one.name.removesuffix(f"-{one.change}")
    plain = next((other for other in verdicts if other.name == f"{rig}-as_is"), None)
    return None if plain is None or not plain.said else one.signature == plain.signature


def _pair(verdicts: Sequence[Verdict]) -> tuple[Share, Share]:
    return _share(verdicts, lambda one: one.exact), _share(verdicts, lambda one: bool(one.false_names))


def _share(verdicts: Iterable[Verdict], fact: Callable[[Verdict], bool | None]) -> Share:
    """Return the share of the cases for which a fact holds, of those that have it."""
    facts = [one for one in map(fact, verdicts) if one is not None]
    return Share(sum(facts), len(facts))
