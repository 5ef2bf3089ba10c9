"""Remedies for quantities that may be read in two ways: both readings are named, so that following one is right."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import pi, sqrt

COMMON: Mapping[str, tuple[str, ...]] = {"speed": ("rpm", "rad/s"), "angle": ("deg", "rad")}
"""Units to propose for a bare number, the usual one first; the SI unit for other kinds."""

QUESTIONS: Mapping[tuple[str, str], tuple[str, tuple[tuple[str, float], ...]]] = {
    ("torque constant (per rms ampere)", "torque constant"): (
        "per peak or per rms ampere?", (("per rms ampere", 1.0), ("per peak ampere", sqrt(2)))
    ),
    ("torque constant", "torque constant (per rms ampere)"): ("", (("per peak ampere, the same motor", 1 / sqrt(2)),)),
    ("rms current", "current"): ("peak or rms ampere?", (("rms", 1.0), ("peak", 1 / sqrt(2)))),
    ("current", "rms current"): ("", (("as the peak", sqrt(2)),)),
    ("speed", "frequency"): ("", (("turns a second", 2 * pi),)),
    ("speed", "rate"): ("", (("turns", 2 * pi), ("radians", 1.0))),
    ("frequency", "speed"): ("", (("once a turn", 1 / (2 * pi)),)),
}  # fmt: skip
"""(kind wanted, kind written): the question, and each answer with its factor from SI to SI."""

_SPACES = " '’\u00a0\u2009\u202f"
_GROUPED = re.compile(rf"^\s*(?P<number>[+-]?\d{{1,3}}(?P<sign>[,.{_SPACES}])\d{{3}}(?:(?P=sign)\d{{3}})*)"
                      r"(?P<rest>[.,]\d+)?(?![\d.,])(?P<unit>.*)$", re.DOTALL)  # fmt: skip
_DECIMAL_COMMA = re.compile(r"^\s*[+-]?\d+,\d+")


def separated_number(text: str) -> str | None:
    """Return what is wrong with the commas, blanks or apostrophes within a number, and the remedy; None where nothing.

    ``5,000`` may be 5000 or 5.000; ``1,234,567`` and ``1,234.5`` have thousands separators, ``5,2`` and ``0,500`` a
    decimal comma. ``5.000`` has a decimal point.
    """
    match = _GROUPED.match(text)
    if match is None:
        decimal = _DECIMAL_COMMA.match(text)
        return f"{text!r} has a decimal comma; write {text.replace(',', '.', 1)!r}" if decimal else None
    number, sign, rest, unit = match["number"], match["sign"], match["rest"] or "", match["unit"]
    if sign == "." and (rest.startswith(".") or (not rest and number.count(".") == 1)):
        return None
    whole = number.replace(sign, "")
    if sign == "," and not rest and number.count(",") == 1:
        point = number.replace(",", ".")
        if number.lstrip("+-").startswith("0"):
            return f"{text!r} has a decimal comma; write {point + unit!r}"
        return f"{text!r} may be {whole + unit!r} or {point + unit!r}; write the one that is meant, without a comma"
    return f"{text!r} has thousands separators; write {whole + rest.replace(',', '.') + unit!r}"


def halved_between_terminals(key: str, written: object) -> str | None:
    """Return the remedy for a resistance or inductance between two terminals, which is not that of a phase.

    Between two terminals a star winding has two phases in series; a delta winding counts as its equivalent star.
    """
    match = re.fullmatch(r"(?:(?P<place>.+)_)?(?P<what>resistance|inductance)(?:_.*)?", key.lower())
    if match is None or (match["place"] or "") in ("thermal", "phase", "stator"):
        return None
    what, place = match["what"], match["place"] or ""
    stated = str(written.get("value", "")) if isinstance(written, Mapping) else str(written)
    number = re.match(r"\s*(\d+\.?\d*(?:[eE][+-]?\d+)?)\s*(.*)", stated)
    half = f"'{float(number[1]) / 2:.6g} {number[2]}'" if number and number[2] else "half of it"
    if re.search(r"line|terminal|ll|winding|phase_to_phase|phase_phase|between", place) or key.lower().endswith("_ll"):
        return f"the {what} between two terminals is that of two phases in star; write phase_{what}: {half}"
    if place:
        return None
    same = f"'{number[1]} {number[2]}'" if number and number[2] else "as it is"
    return f"of one phase or between two terminals? write phase_{what}: {same} or {half}"
