"""Why a computed cell differs from the published one: one sentence, from what differs."""

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
    """What a difference rests on."""

    AGREES = "agrees"
    VALUE = "value"
    READING = "reading"
    DATUM = "datum"
    POLARITY = "polarity"
    MISSING = "missing datum"


@dataclass(frozen=True)
class Reason:
    """The cause and its sentence."""

    cause: Cause
    sentence: str = ""


AGREED = Reason(Cause.AGREES)
NOTHING = Figure()


@dataclass(frozen=True, kw_only=True)
class Compared:
    """One cell with all that its reason is told from.

    Parameters
    ----------
    published : str or float
    computed : str
        The mark as computed.
    figure, datum : Figure
        Of the alternative, and of the datum (Pugh).
    criterion : Criterion
    otherwise : str
        The mark of the other reading; empty where there is none.
    other_purpose : str
    other_figure : Figure
    same_gearbox : str
        The sign against the datum on the table's own gearbox.
    polarity : bool
        Whether more cells of the row agree when its direction is turned round.
    """

    published: Entry
    computed: str
    figure: Figure
    criterion: Criterion
    datum: Figure = NOTHING
    otherwise: str = ""
    other_purpose: str = ""
    other_figure: Figure = NOTHING
    same_gearbox: str = ""
    polarity: bool = False

    @property
    def shown(self) -> str:
        """The figure with its unit."""
        return with_unit(self.figure, self.criterion.unit)


def reason_of_demand(cell: Compared) -> Reason:
    """Return why an elimination's mark differs."""
    if cell.published == cell.computed:
        return AGREED
    rule = (
        cell.criterion.requirement.rule("it", cell.criterion.unit).removeprefix("it ")
        if cell.criterion.requirement
        else ""
    )
    if cell.computed == "?":
        told = "Not known" if cell.figure.unknown else f"It is {cell.shown}, and asked is {rule}"
        return Reason(Cause.MISSING, f"{told}: nobody can say without {_missing(cell.figure)}.")
    if cell.otherwise == cell.published:
        told = with_unit(cell.other_figure, cell.criterion.unit)
        return Reason(
            Cause.READING,
            f"Asked is {rule}, and it is {cell.shown} ({cell.criterion.purpose}); {cell.published} holds only where "
            f"{cell.other_purpose}, which is {told}.",
        )
    known = "The catalog knows it" if cell.published == "?" else "The value says otherwise"
    return Reason(Cause.VALUE, f"{known}: it is {cell.shown}, and asked is {rule}.")


def reason_of_sign(cell: Compared) -> Reason:
    """Return why a sign of a Pugh matrix differs."""
    published, unit = canonical(cell.published), cell.criterion.unit
    if published == cell.computed:
        return AGREED
    told = f"{cell.shown} against {with_unit(cell.datum, unit)} of the datum{_band(cell.criterion)}"
    if cell.computed == Sign.UNKNOWN:
        wider = cell.figure if _width(cell.figure) >= _width(cell.datum) else cell.datum
        return Reason(Cause.MISSING, f"{told} cannot be told apart without {_missing(wider)}.")
    if published == "?":
        return Reason(Cause.VALUE, f"Known by now: {told}.")
    return _reason_of_known(cell, published, told)


def _reason_of_known(cell: Compared, published: Entry, told: str) -> Reason:
    """Return why two known signs differ: another datum or another reading gives the printed one, or nothing does."""
    if cell.same_gearbox == published:
        return Reason(
            Cause.DATUM,
            f"{told}; with the datum on this table's own gearbox it would be {cell.published}, but it stands on "
            "another one.",
        )
    if cell.otherwise == published:
        other = with_unit(cell.other_figure, cell.criterion.unit)
        return Reason(
            Cause.READING,
            f"{told} ({cell.criterion.purpose}); {cell.published} holds for {cell.other_purpose}: {other}.",
        )
    if cell.computed == Sign.SAME and published == Sign.BETTER:
        return Reason(Cause.DATUM, f"The datum has it too, so that S is the best possible: {told}.")
    if cell.polarity:
        turned = _turned(cell.criterion)
        return Reason(Cause.POLARITY, f"{told}; the row agrees better where {turned} counts as better.")
    return Reason(Cause.VALUE, f"The value says otherwise: {told}.")


def reason_of_points(cell: Compared, *, low: float, high: float, within: float) -> Reason:
    """Return why points differ; they agree where the published ones lie within ``within`` of what the data allow."""
    if isinstance(cell.published, str):
        return Reason(Cause.VALUE, f"Lost in the source; computed from {cell.shown}.")
    if low - within <= cell.published <= high + within:
        return AGREED
    given = f"{low:.2g}" if high - low < 0.05 else f"{low:.2g}..{high:.2g}"
    worth = f"is worth {given} on the stated scale, and {cell.published:g} is printed"
    told = f"{cell.shown} ({cell.criterion.purpose}) {worth}"
    if cell.polarity:
        return Reason(Cause.POLARITY, f"{told}; the row agrees better where a high mark is bad.")
    return Reason(Cause.VALUE, f"{told}.")


def turned_round(published: list[Entry], computed: list[str], criterion: Criterion) -> bool:
    """Return whether more signs of a row agree when its direction is turned; a band has none to turn."""
    if criterion.better is Better.BAND:
        return False
    pairs = [(canonical(said), found) for said, found in zip(published, computed, strict=True)]
    kept = sum(said == found for said, found in pairs)
    turned = sum(said == FLIPPED.get(Sign(found), Sign(found)) for said, found in pairs)
    return turned > kept


def points_turned(published: list[Entry], result: KesselringResult, column: int, rows: list[int]) -> bool:
    """Return whether the points of a row come nearer to the published ones when the scale is turned round."""
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
    return figure.missing.split(", ")[0] if figure.missing else "a sharper value"


def _width(figure: Figure) -> float:
    """Return how wide a figure is in proportion; infinite where nothing is known."""
    if figure.unknown:
        return float("inf")
    if figure.low is None or figure.high is None:
        return 0.0
    return (figure.high - figure.low) / max(abs(figure.high), abs(figure.low), 1e-300)


def _band(criterion: Criterion) -> str:
    return "" if criterion.band is None else f", wanted is {criterion.band[0]:g} to {criterion.band[1]:g}"


def _turned(criterion: Criterion) -> str:
    return "less" if criterion.better is Better.MORE else "more"
