"""What the lines above a table state: the sample rate and the units."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from torquerig.recordings.files.text_tables.cells import Dialect, form_of, signs_of, two_readings
from torquerig.recordings.files.text_tables.lines import TextLine
from torquerig.recordings.files.timing import shortest_rate

_ENTRY = re.compile(r"^[\s#%/\"';*]*(?P<key>[^:=\t;,|]{1,60}?)\s*(?:[:=\t;,|]\s*)+(?P<value>[^\s].*?)[\s\"';,|]*$")
# Abtastzeit 500 us, without a sign between
_BARE = re.compile(r"^[\s#%/\"';*]*(?P<key>[A-Za-z][A-Za-z ._-]*?)\s+(?P<value>[0-9][0-9.,]*\s*[^0-9\s]\S*)\s*$")
_BRACKET = re.compile(r"^(?P<name>.*?)\s*[\[(](?P<unit>[^\])]*)[\])]$")
_NUMBER = re.compile(r"^(?P<number>[+-]?[0-9][0-9.,' ]*(?:[eE][+-]?[0-9]+)?)\s*(?P<unit>[^0-9\s].*)?$")
_ONE_PER = re.compile(r"\s1/(?=s)")
_PER_SECOND = {
    "hz": 1.0, "1/s": 1.0, "/s": 1.0, "1/sec": 1.0, "/sec": 1.0, "per second": 1.0, "k": 1e3,
    "s/s": 1.0, "sps": 1.0, "samples/s": 1.0, "samples/sec": 1.0, "samples/second": 1.0,
    "samples per second": 1.0, "hertz": 1.0, "khz": 1e3, "ks/s": 1e3, "ksps": 1e3, "kilohertz": 1e3, "mhz": 1e6,
    "ms/s": 1e6,
}  # fmt: skip
_SECONDS = {
    "s": 1.0, "sec": 1.0, "second": 1.0, "seconds": 1.0, "ms": 1e-3, "msec": 1e-3, "milliseconds": 1e-3,
    "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0,
}  # fmt: skip
_RATE = re.compile(
    r"(?:(?:data |daq )?(?:sample|sampling|scan|acquisition|acq\.?|recording|logging|log|measurement|measuring|data)"
    r"[ _-]?(?:rate|frequency|freq\.?)|samplerate|samplingrate|fs|abtastrate|abtastfrequenz|messrate|messfrequenz)"
)
_COUNTED = re.compile(r"(?:samples?|scans?|readings?|points|measurements|werte|messwerte) ?(?:per|/|pro) ?"
                      r"(?:s|sec|second|sekunde)")  # fmt: skip
_INTERVAL = re.compile(
    r"(?:(?:sample|sampling|scan|acquisition|recording|logging|log|data|measurement|time)[ _-]?"
    r"(?:interval|period|time|step)|interval|delta[ _]?(?:t|x)|dt|abtastzeit|abtastintervall|messintervall)"
)
_UNITS = re.compile(r"(?:units?|einheit(?:en)?)")


@dataclass(frozen=True, kw_only=True)
class Preamble:
    """The sample rate [Hz] (None where it is not stated), the units as written in order, and what was understood."""

    rate: float | None = None
    units: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    named_units: Mapping[str, str] = field(default_factory=dict)


def read_preamble(lines: Sequence[TextLine], *, decimal: str = "") -> Preamble:
    """Return what the lines above the names state.

    ``decimal`` is the decimal sign of the table, empty where it is not known: 2.000 Hz may be 2000 Hz.

    A rate needs its unit in the value or in the key (``Samples per second: 960``, ``Sample rate [Hz] = 1000``); a
    sampling frequency without a unit is in Hz. An interval without a unit, and two rates that differ, are not used.
    """
    rates: list[tuple[float, int]] = []
    units: tuple[str, ...] = ()
    named: dict[str, str] = {}
    notes: list[str] = []
    for line in lines:
        match = _ENTRY.match(line.text) or _BARE.match(line.text)
        if match is None:
            continue
        key, value = " ".join(match["key"].split()), match["value"].strip()
        rate = _rate(key, value, decimal)
        if isinstance(rate, str):
            notes.append(f"{rate} in line {line.number} is not used")
        elif rate is not None:
            rates.append((rate, line.number))
        elif _UNITS.fullmatch(key.lower()):
            units = tuple(part for part in re.split(r"[\t;,|\s]+", value) if part)
            notes.append(f"the unit in line {line.number} is {value}")
        elif (unit_of := re.fullmatch(r"(.+?)[ _-]units?", key, re.IGNORECASE)) is not None:
            named[unit_of[1].lower()] = value
    if not rates:
        return Preamble(units=units, notes=tuple(notes), named_units=named)
    rate, number = rates[0]
    other = next((one for one in rates if abs(one[0] - rate) > 1e-3 * rate), None)
    if other is not None:
        notes.append(f"line {number} states {rate:g} Hz and line {other[1]} {other[0]:g} Hz, and neither is used")
        return Preamble(units=units, notes=tuple(notes), named_units=named)
    notes.append(f"line {number} states {rate:g} samples per second")
    return Preamble(rate=rate, units=units, notes=tuple(notes), named_units=named)


def _rate(key: str, value: str, decimal: str) -> float | str | None:
    """Return the rate [Hz] of an entry, a text where it states one that cannot be used, None where it states none."""
    bracket = _BRACKET.match(key)
    name, unit = (bracket["name"].lower(), bracket["unit"].strip()) if bracket else (key.lower(), "")
    is_rate, is_interval = _RATE.fullmatch(name), _INTERVAL.fullmatch(name)
    if not (is_rate or is_interval or _COUNTED.fullmatch(name) or name == "rate"):
        return None
    match = _NUMBER.match(_ONE_PER.sub(" /", value))
    written = "" if match is None else match["number"].strip(" ,")
    number = _number(written, decimal)
    if match is None or number is None or not number > 0:
        both = two_readings(written)
        return f"the {name} {value} ({both}?)" if both else None
    # a separator may stand between number and unit
    unit = ((match["unit"] or "").strip(' \t;|,"') or unit).strip().rstrip(".").lower()
    if is_interval:
        step = _SECONDS.get(unit)
        return f"the {name} {value} without a known unit" if step is None else _inverse(number * step)
    if _COUNTED.fullmatch(name) or (is_rate and not unit):
        return number
    factor = _PER_SECOND.get(unit)
    return None if factor is None else number * factor


def _inverse(step: float) -> float | None:
    rate = 1 / step if step > 1e-12 else 0.0  # [s]: no logger samples faster than once a picosecond
    return shortest_rate(rate, tolerance=1e-9) if rate > 0 else None


def _number(text: str, decimal: str) -> float | None:
    form = form_of(text)
    signs = signs_of([form])
    # 1,000 Hz above decimal commas stays unclear: the lines above the table are often not in its language
    if (form == "one group by point" and decimal) or (form == "one group" and decimal == "."):
        signs = decimal, "," if decimal == "." else "."
    number = None if signs is None else Dialect("", *signs).number(text)
    return number if number is not None and abs(number) < float("inf") else None
