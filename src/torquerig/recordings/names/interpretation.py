"""Quantity, unit and scale of a column from its name and the unit that the file states."""

from __future__ import annotations

import re
from dataclasses import dataclass

from torquerig.recordings.names.channel_units import unit_meanings
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.words import close_quantity, not_measured, quantity_by_words, words_of
from torquerig.recordings.quantities import KINDS, OTHER
from torquerig.units import Meaning

_BY_KIND = {
    "torque": "torque", "force": "force", "speed": "speed", "angle": "angle", "length": "position",
    "linear speed": "velocity", "voltage": "voltage", "current": "current", "temperature": "temperature",
    "temperature difference": "temperature", "acceleration": "acceleration", "pressure": "pressure", "power": "power",
}  # fmt: skip
_OF_MOTOR = {"torque": "motor_torque", "speed": "motor_speed", "angle": "motor_angle"}
_VOLTAGE_INPUT = re.compile(r"^(?:(?:Voltage|Spannung)(?:[_ ]\d+)?|(?:.*/)?ai\d+|AI ?\d+)$")
_MEASURED = "what the voltage measures, with its scale"
_FACTOR = re.compile(r"(?:[*×]|\bx)\s*\d+(?:[.,]\d+)?\s*$", re.IGNORECASE)  # "Torque*100", "Speed x10"
_OUTPUTS = ("voltage", "current", "count", "bare")  # what a sensor gives that is not scaled yet


@dataclass(frozen=True, kw_only=True)
class Interpretation:
    """What a column is taken for.

    Parameters
    ----------
    name : str
        The channel's name: the header cell without the unit that stands in brackets or behind a separator.
    quantity : str
        One of ``QUANTITIES``; ``other`` where name and unit do not determine it.
    unit : str
        As ``torquerig`` spells it; as the file writes it where it is not known, ``""`` where there is none.
    si_per_unit : float
        SI quantity per unit; 1 for ``other``.
    reason : str
        Why, in a few words.
    missing : str
        What a sidecar must add before the column can be used; empty where nothing is missing.
    """

    name: str
    quantity: str
    unit: str
    si_per_unit: float
    reason: str
    missing: str = ""


def interpret(cell: str, unit: str | None) -> Interpretation:
    """Return what the column with the header ``cell`` and the unit of its file (None where it states none) is.

    A unit is never guessed. A torque in V, and an angle in counts, need a scale: the column is the voltage or ``other``
    until a sidecar states it. ``torque_V`` alone is read as 1 V = 1 N m.

    Source of that scale: the reference report, Appendix A, line 2.
    """
    name, written = split_header(cell)
    kept = cell.strip() if written and cell.strip() == f"{name}_{written.replace('/', '_')}" else name
    written = (unit if unit and unit.strip() else written) or _unit_as_name(name)
    if kept.lower() == "torque_v" and written.strip() in ("V", "v"):
        return Interpretation(
            name=kept, quantity="torque", unit="V", si_per_unit=1.0, reason="a column torque_V has 1 V = 1 N*m"
        )
    by_words = quantity_by_words(name)
    if not written.strip():
        return _without_unit(kept, name, by_words)
    derived = not_measured(name)
    factor = _FACTOR.search(name)
    if factor is not None:
        return Interpretation(
            name=kept, quantity=OTHER, unit=written.strip(), si_per_unit=1.0,
            reason=f"its name states the factor {factor[0].strip()!r}", missing="its quantity and scale",
        )  # fmt: skip
    if derived is not None:
        return Interpretation(
            name=kept, quantity=OTHER, unit=written.strip(), si_per_unit=1.0,
            reason=f"the word {derived!r} in its name says that it is not the measured signal of the shaft",
            missing="its quantity, if it is the measured signal",
        )  # fmt: skip
    return _with_unit(kept, written.strip(), by_words, words_of(name))


def _unit_as_name(name: str) -> str:
    """Return the name itself where it is a unit of torque or speed of two letters or more (``RPM``), else nothing."""
    kinds = {one.kind for one in unit_meanings(name)}
    return name if len(name) > 1 and kinds and kinds <= {"torque", "speed"} else ""


def _without_unit(kept: str, name: str, by_words: str | None) -> Interpretation:
    if _VOLTAGE_INPUT.match(name):
        return Interpretation(
            name=kept, quantity="voltage", unit="V", si_per_unit=1.0, reason="the default name of a voltage input",
            missing=_MEASURED,
        )  # fmt: skip
    if by_words == "tacho":
        return Interpretation(name=kept, quantity="tacho", unit="1", si_per_unit=1.0, reason="its name")
    if by_words is not None:
        reason = f"its name says {_said(by_words)}, and no unit is stated"
        return Interpretation(name=kept, quantity=OTHER, unit="", si_per_unit=1.0, reason=reason,
                              missing=f"quantity: {by_words}, with its unit")  # fmt: skip
    return Interpretation(name=kept, quantity=OTHER, unit="", si_per_unit=1.0, reason="neither name nor unit is known",
                          missing="its quantity and unit")  # fmt: skip


def _with_unit(kept: str, written: str, by_words: str | None, words: list[str]) -> Interpretation:
    spelled = unit_meanings(written)
    found = {one.kind: one for one in spelled if one.symbol != "degF"}  # whose zero is not that of K or degC
    if by_words == "tacho":
        symbol = next((one.symbol for one in found.values()), written)
        return Interpretation(name=kept, quantity="tacho", unit=symbol, si_per_unit=1.0, reason="its name")
    agreed = next((found[kind] for kind in KINDS[by_words or OTHER] if kind in found), None)
    if by_words is not None and agreed is not None and not _VOLTAGE_INPUT.match(kept):
        return _known(kept, by_words, agreed, "its name and unit")
    if len(found) == 1 and next(iter(found)) in _BY_KIND:
        return _by_unit(kept, next(iter(found.values())), by_words, words)
    symbol = spelled[0].symbol if len(spelled) == 1 else written
    if by_words is not None and any(kind in found for kind in _OUTPUTS):
        reason, missing = f"its name says {_said(by_words)}, and its scale is not stated", _scale_missing(by_words)
    else:
        reason = f"its unit {written!r} is " + ("not that of a known quantity" if spelled else "not known")
        missing = "its quantity, if it is to be used"
    return Interpretation(name=kept, quantity=OTHER, unit=symbol, si_per_unit=1.0, reason=reason, missing=missing)


def _by_unit(kept: str, meaning: Meaning, by_words: str | None, words: list[str]) -> Interpretation:
    """Return what a unit of one kind says; a sensor's output stays one, whatever its name says."""
    quantity = _BY_KIND[meaning.kind]
    if "motor" in words or (by_words or "").startswith("motor_"):
        quantity = _OF_MOTOR.get(quantity, quantity)
    missing = ""
    if meaning.kind == "voltage" and _VOLTAGE_INPUT.match(kept):
        missing = _MEASURED
    elif meaning.kind in _OUTPUTS:
        meant = by_words or close_quantity(kept)
        missing = "" if meant in (None, quantity) else _scale_missing(meant)
    return _known(kept, quantity, meaning, "its unit", missing=missing)


def _said(quantity: str) -> str:
    return quantity.replace("_", " ")


def _known(name: str, quantity: str, meaning: Meaning, reason: str, *, missing: str = "") -> Interpretation:
    return Interpretation(
        name=name, quantity=quantity, unit=meaning.symbol, si_per_unit=meaning.factor, reason=reason, missing=missing
    )


def _scale_missing(quantity: str) -> str:
    scale = "counts_per_rev" if KINDS[quantity] == ("angle",) else "its SI value per unit"
    return f"the scale, if it is the {_said(quantity)}: quantity: {quantity} and {scale}"
