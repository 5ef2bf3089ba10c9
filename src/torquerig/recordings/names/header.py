"""One header cell, split into the name of the column and its unit."""

from __future__ import annotations

import re

from torquerig.recordings.names.channel_units import unit_meanings
from torquerig.recordings.names.words import TIME_WORDS, close_quantity, quantity_by_words, words_of

_BRACKETS = re.compile(r"^(?P<name>.*?)\s*[\[<{](?P<unit>[^\]>}]*)[\]>}]\s*$")
_PREFIX = re.compile(r"^\s*[\[(](?P<unit>[^\])]*)[\])]\s*(?P<name>\S.*)$")  # "[Nm] Torque"
_INNER = re.compile(r"^(?P<name>.*?\S)\s*\[(?P<unit>[^\]]*)\]\s*(?P<rest>\S.*)$")  # "Torque [Nm] (filtered 1 kHz)"
_ROUND = re.compile(r"^(?P<name>.*?)\s*\((?P<unit>[^()]*(?:\([^()]*\)[^()]*)*)\)\s*$")
_BLANK = re.compile(r"^(?P<name>.+)\s+(?P<unit>[^\s_(][^\s_]*)$")
# what separates a unit without brackets from the name: "Torque / Nm", "Torque, Nm", "Drehmoment in Nm", "torque_Nm"
_SEPARATED = (
    re.compile(r"^(?P<name>[^/]+?)\s*/\s*(?P<unit>.+)$"),
    re.compile(r"^(?P<name>.+?)\s*[,;:|]\s*(?P<unit>[^,;:|]+)$"),
    re.compile(r"^(?P<name>.+?)\s+in\s+(?P<unit>\S+(?:\s\S+)?)$", re.IGNORECASE),
    _BLANK,
)


def split_header(cell: str) -> tuple[str, str | None]:
    """Return the name and the unit text of a header cell; the unit is None where the cell states none.

    What stands in square brackets is a unit even if it is not known. Behind a slash, comma, ``in``, blank or
    underscore, and in round brackets, only a known unit counts: ``Torque (filtered)`` and ``Dev1/ai0`` are names.

    ``"Torque [Nm]"`` gives ``("Torque", "Nm")``, ``"speed_rad_s"`` ``("speed", "rad/s")``.
    """
    text = " ".join(cell.split())
    bracket = _BRACKETS.match(text)
    if bracket and bracket["name"]:
        return bracket["name"].rstrip("_/ ,:"), bracket["unit"].strip()
    for pattern in (_PREFIX, _INNER):
        match = pattern.match(text)
        if match and _is_unit(match["unit"]):
            return " ".join(part for part in (match["name"], match.groupdict().get("rest")) if part), match[
                "unit"
            ].strip()
    matches = [match for pattern in (_ROUND, *_SEPARATED) if (match := pattern.match(text))]
    units = [match for match in matches if match["name"] and _fits(match) and not _is_label(match)]
    if units:
        longest = max(units, key=lambda match: len(match["unit"]))  # "Drehzahl U/min": U/min, not min
        return longest["name"].rstrip("_/ ,:"), longest["unit"].strip()
    return _underscored(text)


def _underscored(text: str) -> tuple[str, str | None]:
    """Split ``speed_rad_s`` and ``torque_Nm``: the longest tail that is a unit, with ``_`` for ``/``."""
    parts = text.split("_")
    for first in range(1, len(parts)):
        unit = "/".join(parts[first:])
        name = "_".join(parts[:first])
        # one letter is a unit behind a quantity (force_N), and a label elsewhere (phase_A)
        if name and _is_unit(unit) and (len(unit) > 1 or _is_quantity(name)):
            return name, unit
    return text, None


def _fits(match: re.Match[str]) -> bool:
    """Return whether a unit stands behind the name; of a time in capitals too: ``TIME (MS)``."""
    if _is_unit(match["unit"]):
        return True
    is_time = any(word in TIME_WORDS for word in words_of(match["name"]))
    return is_time and any(one.kind == "time" for one in unit_meanings(match["unit"].lower()))


def _is_quantity(name: str) -> bool:
    words = words_of(name)
    is_time = name.strip().lower() == "t" or any(word in TIME_WORDS for word in words)
    return is_time or quantity_by_words(name) is not None or close_quantity(name) is not None


def _is_label(match: re.Match[str]) -> bool:
    """Return whether what stands behind a blank is a label of one letter: ``Channel A``, ``Sensor C``."""
    return match.re is _BLANK and match["unit"].isalpha() and len(match["unit"]) == 1


def _is_unit(text: str) -> bool:
    found = unit_meanings(text)
    return bool(found) and found[0].kind != "bare"
