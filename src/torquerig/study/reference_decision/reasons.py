"""Reasons why a computed cell differs from the published one, as sentences."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from torquerig.decide.criterion import Better, Criterion
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.matrix_io.matrix_table import Entry, canonical
from torquerig.decide.pugh import PughResult, Sign
from torquerig.metrics.figure import Figure

FLIPPED = {Sign.BETTER: Sign.WORSE, Sign.WORSE: Sign.BETTER}


class Cause(StrEnum):
    """Kind of a difference."""

    AGREES = "agrees"
    VALUE = "value"
    READING = "interpretation"
    BASELINE = "baseline"
    POLARITY = "direction"
    MISSING = "missing value"


@dataclass(frozen=True)
class Reason:
    """The cause and its sentence."""

    cause: Cause
    sentence: str = ""


AGREED = Reason(Cause.AGREES)
NOTHING = Figure()


@dataclass(frozen=True, kw_only=True)
class Compared:
    """One cell with the data that its reason follows from.

    Parameters
    ----------
    published : str or float
    computed : str
        The mark as computed.
    figure, baseline : Figure
        Of the alternative, and of the baseline (Pugh).
    criterion : Criterion
    otherwise : str
        The mark of the other interpretation; empty where there is none.
    other_purpose : str
    other_figure : Figure
    same_gearbox : str
        The sign against the baseline on the gearbox of the table.
    polarity : bool
        Whether more cells of the row agree with the opposite direction.
    """

    published: Entry
    computed: str
    figure: Figure
    criterion: Criterion
    baseline: Figure = NOTHING
    otherwise: str = ""
    other_purpose: str = ""
    other_figure: Figure = NOTHING
    same_gearbox: str = ""
    polarity: bool = False

    @property
    def shown(self) -> str:
        """The figure with its unit."""
        return with_unit(self.figure, self.criterion.unit)


def reason_of_requirement(cell: Compared) -> Reason:
    """Return why an elimination's mark differs."""
    if cell.published == cell.computed:
        return AGREED
    rule = (
        cell.criterion.requirement.rule("it", cell.criterion.unit).removeprefix("it ")
        if cell.criterion.requirement
        else ""
    )
    if cell.computed == "?":
        value = "unknown" if cell.figure.unknown else cell.shown
        return Reason(Cause.MISSING, f"Required is {rule}; the value is {value}. {_missing(cell.figure)} is missing.")
    if cell.otherwise == cell.published:
        other = with_unit(cell.other_figure, cell.criterion.unit)
        return Reason(
            Cause.READING,
            f"Required is {rule}; the value is {cell.shown} ({cell.criterion.purpose}). {cell.published} is "
            f"right only if "
            f"{cell.other_purpose}: {other}.",
        )
    return Reason(Cause.VALUE, f"The value is {cell.shown}, and required is {rule}.")


def reason_of_sign(cell: Compared) -> Reason:
    """Return why a sign of a Pugh matrix differs."""
    published, unit = canonical(cell.published), cell.criterion.unit
    if published == cell.computed:
        return AGREED
    compared = f"{cell.shown} against {with_unit(cell.baseline, unit)} of the baseline{_band(cell.criterion)}"
    if cell.computed == Sign.UNKNOWN:
        wider = cell.figure if _width(cell.figure) >= _width(cell.baseline) else cell.baseline
        return Reason(Cause.MISSING, f"{compared}: the intervals overlap. {_missing(wider)} is missing.")
    if published == "?":
        return Reason(Cause.VALUE, f"The value is known: {compared}.")
    return _reason_of_known(cell, published, compared)


def _reason_of_known(cell: Compared, published: Entry, compared: str) -> Reason:
    """Return why two known signs differ: another baseline or interpretation gives the printed one, or neither does."""
    if cell.same_gearbox == published:
        return Reason(
            Cause.BASELINE,
            f"{compared}; with the baseline on the gearbox of this table it would be {cell.published}, but the "
            f"baseline "
            "has another one.",
        )
    if cell.otherwise == published:
        other = with_unit(cell.other_figure, cell.criterion.unit)
        return Reason(
            Cause.READING,
            f"{compared} ({cell.criterion.purpose}); {cell.published} is right for {cell.other_purpose}: {other}.",
        )
    if cell.computed == Sign.SAME and published == Sign.BETTER:
        return Reason(Cause.BASELINE, f"The baseline has it too, so S is the best possible sign: {compared}.")
    if cell.polarity:
        turned = _turned(cell.criterion)
        return Reason(Cause.POLARITY, f"{compared}; the row agrees better if {turned} counts as better.")
    return Reason(Cause.VALUE, f"{compared}.")


def reason_of_points(cell: Compared, *, low: float, high: float, within: float) -> Reason:
    """Return why points differ; they agree where the published ones lie within ``within`` of what the data allow."""
    if isinstance(cell.published, str):
        return Reason(Cause.VALUE, f"Illegible in the source; computed from {cell.shown}.")
    if low - within <= cell.published <= high + within:
        return AGREED
    given = f"{low:.2g}" if high - low < 0.05 else f"{low:.2g}..{high:.2g}"
    points = f"gives {given} points on the stated scale; {cell.published:g} is printed"
    sentence = f"{cell.shown} ({cell.criterion.purpose}) {points}"
    if cell.polarity:
        return Reason(Cause.POLARITY, f"{sentence}; the row agrees better if a high mark is bad.")
    return Reason(Cause.VALUE, f"{sentence}.")


def turned_round(published: list[Entry], computed: list[str], criterion: Criterion) -> bool:
    """Return whether more signs of a row agree with the opposite direction; a band has no direction."""
    if criterion.better is Better.BAND:
        return False
    pairs = [(canonical(said), found) for said, found in zip(published, computed, strict=True)]
    kept = sum(said == found for said, found in pairs)
    turned = sum(said == FLIPPED.get(Sign(found), Sign(found)) for said, found in pairs)
    return turned > kept


def points_turned(published: list[Entry], result: KesselringResult, column: int, rows: list[int]) -> bool:
    """Return whether the points of a row agree better with the opposite scale."""
    profile = result.profile
    kept = turned = 0.0
    for said, row in zip(published, rows, strict=True):
        if isinstance(said, float):
            middle = float(result.middle[row, column])
            kept += abs(said - middle)
            turned += abs(said - (profile.p_min + profile.p_max - middle))
    return turned < kept - 1e-9


def signs_of(result: PughResult, alternative: str) -> dict[str, str]:
    """Return the signs of one alternative by criterion."""
    return dict(zip(result.criteria, map(str, result.signs(alternative)), strict=True))


def with_unit(figure: Figure, unit: str) -> str:
    """Return a figure with its unit for a sentence."""
    return figure.shown() if unit == "1" or figure.unknown else f"{figure.shown()} {unit}"


def _missing(figure: Figure) -> str:
    return figure.missing.split(", ")[0] if figure.missing else "a narrower interval"


def _width(figure: Figure) -> float:
    """Return the relative width of a figure; infinite where it is unknown."""
    if figure.unknown:
        return float("inf")
    if figure.low is None or figure.high is None:
        return 0.0
    return (figure.high - figure.low) / max(abs(figure.high), abs(figure.low), 1e-300)


def _band(criterion: Criterion) -> str:
    return "" if criterion.band is None else f", required is {criterion.band[0]:g} to {criterion.band[1]:g}"


def _turned(criterion: Criterion) -> str:
    return "less" if criterion.better is Better.MORE else "more"
