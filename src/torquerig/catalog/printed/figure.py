"""One figure of a data sheet as it is printed: number or range, unit, and the words that decide what it means."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from torquerig.catalog.printed.words import DUTY, TEMPERATURE, TOLERANCE, taken_apart
from torquerig.errors import UnitError
from torquerig.units import meanings, parse_quantity
from torquerig.units.remedies import separated_number

_NUMBER_AND_UNIT = re.compile(r"^\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(?P<unit>.*)$")
_THOUSAND_TURNS = re.compile(r"(?<![\w])[kK](?:rpm|RPM|min-1|min⁻¹)(?![\w])")
_KEYS = {"value", "low", "high", "as", "evidence", "source", "note"}


@dataclass(frozen=True)
class Figure:
    """A printed figure.

    Parameters
    ----------
    text : str
        As it is written in the file, for the shown conversion.
    low, high : str
        Number and unit, without the words; equal but for a range or a tolerance.
    words : frozenset of str
        ``rms``, ``peak``, ``dc``, ``line``, ``phase``, ``star``, ``delta``, ``peak-to-peak``, ``amplitude``,
        ``of rated``.
    spread : float
        Printed tolerance [1], 0 where none.
    duty : tuple of str and float
        Duty type (IEC 60034-1) and cyclic duration factor [1]; ``("S1", 1.0)`` where none is printed.
    celsius : float or None
        Temperature at which it holds [C]; None where none is printed.
    evidence, source, note : str
        Of this figure; empty where those of the sheet hold.
    """

    text: str
    low: str
    high: str
    words: frozenset[str] = frozenset()
    spread: float = 0.0
    duty: tuple[str, float] = ("S1", 1.0)
    celsius: float | None = None
    evidence: str = ""
    source: str = ""
    note: str = ""

    def quantity(self, unit: str) -> tuple[float, float]:
        """Return the range [SI] of a figure in ``unit``; UnitError where the unit is another."""
        return self._spread(parse_quantity(self.low, unit), parse_quantity(self.high, unit))

    def ratio(self, over: str, under: str, *, like: str = "") -> tuple[float, float]:
        """Return the range [SI] of a figure such as ``27.8 V/krpm``, of ``over`` per ``under``.

        ``like`` is a kind of quantity of the table of units with the same meaning (``flux linkage`` for V*s/rad).
        """
        ends = [_ratio(end, over=over, under=under, like=like) for end in (self.low, self.high)]
        return self._spread(ends[0], ends[1])

    def _spread(self, low: float, high: float) -> tuple[float, float]:
        if low > high:
            raise UnitError(f"{self.text!r} has its low end above the high one; exchange them")
        return low * (1 - self.spread), high * (1 + self.spread)

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(_validated)


def read_figure(written: Any) -> Figure:
    """Return the figure written as text, or as a mapping with value (or low and high), as, source, evidence, note.

    Raises
    ------
    UnitError
        Where nothing, a bare number, an unknown key or an impossible duty or tolerance is written.
    """
    if not isinstance(written, Mapping):
        return _from_texts(_text(written), _text(written), "", {})
    extra = sorted(set(map(str, written)) - _KEYS)
    if extra:
        raise UnitError(f"unknown key {extra[0]!r}; allowed are {', '.join(sorted(_KEYS))}")
    further = {key: str(written.get(key, "")) for key in ("evidence", "source", "note")}
    words = str(written.get("as", ""))
    if "value" in written and "low" not in written and "high" not in written:
        return _from_texts(_text(written["value"]), _text(written["value"]), words, further)
    if "low" in written and "high" in written and "value" not in written:
        return _from_texts(_text(written["low"]), _text(written["high"]), words, further)
    raise UnitError("write either value, or low and high, as they are printed")


def _validated(written: Any) -> Figure:
    try:
        return written if isinstance(written, Figure) else read_figure(written)
    except UnitError as error:
        raise ValueError(str(error)) from None


def _text(written: Any) -> str:
    if isinstance(written, bool) or not isinstance(written, str) or not written.strip():
        raise UnitError(
            f"{written!r} is no figure with a unit; write it as printed, such as '27.8 V/krpm line-to-line rms'"
        )
    return written


def _from_texts(low: str, high: str, words: str, further: Mapping[str, str]) -> Figure:
    said = f"{low} {words}".strip() if low == high else f"{low} .. {high} {words}".strip()
    for text in (low, high):
        if problem := separated_number(text):
            raise UnitError(problem)
    spread, duty = _tolerance(said), _duty(said)
    ends, found = [], set(taken_apart(_without_marks(words))[1])
    for text in (low, high):
        left, there = taken_apart(_without_marks(text))
        match = _NUMBER_AND_UNIT.match(left)
        ends.append(f"{match['number']} {match['unit']}".strip() if match else left)
        found |= there
    left = taken_apart(_without_marks(words))[0]
    if left:
        raise UnitError(
            f"{left!r} is not understood; known words are line-to-line, per phase, rms, peak, dc, star, delta, "
            "peak-to-peak, amplitude, of rated torque, S3 40 %, unstated"
        )
    for one, other in (("rms", "peak"), ("line", "phase"), ("star", "delta"), ("peak-to-peak", "amplitude")):
        if {one, other} <= found:
            raise UnitError(f"{said!r} is both {one} and {other}; keep one of them")
    return Figure(said, ends[0], ends[1], frozenset(found), spread, duty, _celsius(said), **further)


def _without_marks(text: str) -> str:
    return DUTY.sub(" ", TOLERANCE.sub(" ", TEMPERATURE.sub(" ", text)))


def _celsius(text: str) -> float | None:
    found = TEMPERATURE.search(text)
    return float(found[1]) if found else None


def _tolerance(text: str) -> float:
    found = TOLERANCE.search(text)
    spread = float(found[1]) / 100 if found else 0.0
    if spread >= 1:
        raise UnitError(f"{text!r} has a tolerance of 100 % or more; write low and high")
    return spread


def _duty(text: str) -> tuple[str, float]:
    found = DUTY.search(text)
    if found is None:
        return "S1", 1.0
    kind, share = found[1], found[2]
    if kind not in ("S1", "S3"):
        raise UnitError(f"{text!r}: ratings for {kind} are not converted; write the S1 or S3 rating of the sheet")
    if kind == "S1":
        return "S1", 1.0
    if share is None or not 0 < float(share) < 100:
        raise UnitError(f"{text!r}: S3 needs its cyclic duration factor below 100 %, such as 'S3 40 %'")
    return "S3", float(share) / 100


def _ratio(text: str, *, over: str, under: str, like: str) -> float:
    match = _NUMBER_AND_UNIT.match(text)
    if match is None:
        raise UnitError(f"{text!r} does not start with a number; write it as printed")
    unit = _THOUSAND_TURNS.sub("krpm", match["unit"].strip())
    known = [one.factor for one in meanings(unit) if like and one.kind == like]
    if known:
        return float(match["number"]) * known[0]
    above, _, below = unit.partition("/") if over == "V" else unit.rpartition("/")
    above, below = (one.strip().removeprefix("(").removesuffix(")").strip() for one in (above, below))
    if not above or not below:
        raise UnitError(
            f"{text!r} has no unit of the kind {over} per {under}; write it as printed, such as {_SUCH[over]!r}"
        )
    divisor = below if re.match(r"\d+(?:\.\d+)?\s*[A-Za-z]|\d+(?:\.\d+)?\s+1/", below) else f"1 {below}"
    return parse_quantity(f"{match['number']} {above}", over) / parse_quantity(divisor, under)


_SUCH = {"V": "27.8 V/krpm line-to-line rms", "rad/s": "340 rpm/V dc", "N*m": "0.46 N*m/A rms"}
