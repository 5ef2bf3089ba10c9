"""Units as data loggers and data sheets spell them: ``lb-ft``, ``Newton-meters``, ``U/min``, ``mN·m/A``, ``m/s²``.

A unit is taken apart into its symbols, so that order, separators and exponents may be written in any way. Upper and
lower case count for symbols (``mN`` is not ``MN``), and not for words (``RPM``, ``Volts``).
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from itertools import product

Signature = frozenset[tuple[str, int]]
"""The symbols of a unit with their exponents: N*m/A is {(N, 1), (m, 1), (A, -1)}."""

# symbols, of which case counts -> what they may mean
_SYMBOLS: dict[str, tuple[str, ...]] = {
    **{
        one: (one,)
        for one in (
            "N", "mN", "uN", "cN", "dN", "daN", "kN", "MN",
            "m", "mm", "cm", "um", "nm", "ft", "in", "rad", "mrad", "urad", "deg",
            "rev", "s", "ms", "us", "ns", "min", "h", "V", "mV", "uV", "kV", "A", "mA", "uA", "W", "mW", "kW", "MW",
            "hp", "Pa", "hPa", "kPa", "MPa", "GPa", "bar", "mbar", "psi", "Hz", "kHz", "MHz", "K", "J", "kJ", "Wh",
            "ohm", "Ohm", "mohm", "kohm", "H", "mH", "uH", "Wb", "mWb", "rpm", "arcmin", "arcsec", "kip", "lbf",
            "lbm", "ozf", "ozm", "kgf", "gf", "PS", "dyn", "bit", "Arms", "mArms", "percent", "ppm",
            "degC", "degF", "EUR",
        )
    },
    "g": ("g", "gf", "g0"),
    "g0": ("g0",),
    "kg": ("kg", "kgf"),
    "lb": ("lbf", "lbm"),
    "lbs": ("lbf", "lbm"),
    "oz": ("ozf", "ozm"),
    "kp": ("kgf",),
    "p": ("gf",),
    "Nm": ("N*m",),
    "mNm": ("mN*m",),
    "uNm": ("uN*m",),
    "cNm": ("cN*m",),
    "dNm": ("dN*m",),
    "daNm": ("daN*m",),
    "MNm": ("MN*m",),
    "kpcm": ("kgf*cm",),
    "krpm": ("krpm",),
    "kNm": ("kN*m",),
    "Ncm": ("N*cm",),
    "Nmm": ("N*mm",),
    "Nms": ("N*m*s",),
    "Vs": ("V*s",),
    "Ws": ("W*s",),
    "U": ("rev",),
    "%": ("percent",),
    '"': ("in",),
    "°": ("deg",),
    "°C": ("degC",),
    "°F": ("degF",),
    "'": ("arcmin",),
}  # fmt: skip

# words, of which case does not count -> the symbol
_WORDS: dict[str, str] = {
    **dict.fromkeys(("newton", "newtons"), "N"),
    **dict.fromkeys(("millinewton", "millinewtons"), "mN"),
    **dict.fromkeys(("kilonewton", "kilonewtons"), "kN"),
    **dict.fromkeys(("newtonmeter", "newtonmeters", "newtonmetre", "newtonmetres"), "N*m"),
    **dict.fromkeys(("meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("millimeter", "millimeters", "millimetre", "millimetres"), "mm"),
    **dict.fromkeys(("centimeter", "centimeters", "centimetre", "centimetres"), "cm"),
    **dict.fromkeys(("inch", "inches"), "in"),
    **dict.fromkeys(("foot", "feet", "ft"), "ft"),
    **dict.fromkeys(("pound", "pounds", "lb", "lbs", "lbf", "poundforce"), "lbf"),
    **dict.fromkeys(("ounce", "ounces", "oz", "ozf"), "ozf"),
    **dict.fromkeys(("kilogram", "kilograms", "kgs"), "kg"),
    **dict.fromkeys(("kilopond", "kgf"), "kgf"),
    **dict.fromkeys(("radian", "radians"), "rad"),
    **dict.fromkeys(("degree", "degrees", "degs", "deg"), "deg"),
    **dict.fromkeys(("rev", "revs", "revolution", "revolutions", "turn", "turns", "umdrehung", "umdrehungen", "umdr",
                     "umdr.", "tr", "obr"), "rev"),
    **dict.fromkeys(("mn",), "min"),
    **dict.fromkeys(("rpm", "upm", "u/min", "umin", "r.p.m.", "r.p.m"), "rpm"),
    **dict.fromkeys(("krpm",), "krpm"),
    **dict.fromkeys(("rps",), "rev/s"),
    **dict.fromkeys(("sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden"), "s"),
    **dict.fromkeys(("msec", "msecs", "millisecond", "milliseconds", "millisekunden"), "ms"),
    **dict.fromkeys(("usec", "usecs", "microsecond", "microseconds", "mikrosekunden"), "us"),
    **dict.fromkeys(("min", "mins", "minute", "minutes", "minuten"), "min"),
    **dict.fromkeys(("hour", "hours", "hr", "hrs", "stunden"), "h"),
    **dict.fromkeys(("volt", "volts"), "V"),
    **dict.fromkeys(("millivolt", "millivolts"), "mV"),
    **dict.fromkeys(("amp", "amps", "ampere", "amperes"), "A"),
    **dict.fromkeys(("milliamp", "milliamps", "milliampere", "milliamperes"), "mA"),
    **dict.fromkeys(("watt", "watts"), "W"),
    **dict.fromkeys(("kilowatt", "kilowatts", "kw"), "kW"),
    **dict.fromkeys(("psi",), "psi"),
    **dict.fromkeys(("horsepower", "hp"), "hp"),
    **dict.fromkeys(("pascal", "pascals"), "Pa"),
    **dict.fromkeys(("bar", "bars"), "bar"),
    **dict.fromkeys(("hertz", "hz"), "Hz"),
    **dict.fromkeys(("khz",), "kHz"),
    **dict.fromkeys(("kelvin",), "K"),
    **dict.fromkeys(("celsius", "degc", "deg_c"), "degC"),
    **dict.fromkeys(("fahrenheit", "degf", "deg_f"), "degF"),
    **dict.fromkeys(("ohm", "ohms"), "ohm"),
    **dict.fromkeys(("percent", "prozent"), "percent"),
    **dict.fromkeys(("ftlb", "ftlbs", "lbft", "ftlbf", "lbfft"), "lbf*ft"),
    **dict.fromkeys(("inlb", "inlbs", "lbin", "inlbf", "lbfin"), "lbf*in"),
    **dict.fromkeys(("ozin", "inoz", "ozfin", "inozf"), "ozf*in"),
    **dict.fromkeys(("kgcm", "kgfcm"), "kgf*cm"),
    **dict.fromkeys(("kgm", "kgfm", "mkp"), "kgf*m"),
}  # fmt: skip

_SAME = str.maketrans(
    {
        **dict.fromkeys("·⋅×•∙・", "*"),
        **dict.fromkeys("µμ", "u"),
        **dict.fromkeys("−–⁻", "-"),
        **dict.fromkeys("\u03a9\u2126", "ohm"),
        **dict(zip("¹²³", "123", strict=True)),
        "º": "°",
        "″": '"',
        "′": "'",
    }
)
_FACTOR = re.compile(r"^(?P<symbol>.*?[^\d^*-])\^?(?P<exponent>-?\d)?$")


def signatures(text: str) -> frozenset[Signature]:
    """Return every combination of symbols that ``text`` may mean as a unit; empty where a part of it is not known.

    ``"lb-ft"`` gives {(lbf, 1), (ft, 1)} and {(lbm, 1), (ft, 1)}; which of them is a unit, a table of units says.
    """
    plain = unicodedata.normalize("NFC", text).translate(_SAME).strip()
    if not plain or len(plain) > 40:
        return frozenset()
    over, *under = re.split(r"\s*/\s*|\s+per\s+", plain)
    sides = [(over, 1), *((side, -1) for side in under)]
    found: list[list[Signature]] = []
    for side, sign in sides:
        options = list(_product(_without_brackets(side), sign))
        if not options:
            return frozenset()
        found.append(options)
    return frozenset(_joined(combination) for combination in product(*found))


def _without_brackets(side: str) -> str:
    """Return ``(N*m)`` as ``N*m``; a bracket without its other half stays, and makes the text no unit."""
    plain = side.strip()
    return plain[1:-1] if plain.startswith("(") and plain.endswith(")") else plain


def _product(side: str, sign: int) -> Iterator[Signature]:
    """Yield the meanings of one side of a fraction."""
    if side == "1":
        yield frozenset()
        return
    whole = list(_factor(side, sign))
    if whole:
        yield from whole
        return
    # "min-1" and "s^-2" keep their minus, which is an exponent and no separator
    parts = [one for one in re.split(r"\s*[*.]\s*|(?<!\^)-(?!\d)|\s+", side) if one]
    if len(parts) < 2:
        return
    options = [list(_factor(part, sign)) for part in parts]
    yield from (_joined(combination) for combination in product(*options))


def _factor(part: str, sign: int) -> Iterator[Signature]:
    """Yield the meanings of one symbol or word with its exponent."""
    for symbol, exponent in _split(part):
        word = _WORDS.get(symbol.lower())
        for meaning in dict.fromkeys((*_SYMBOLS.get(symbol, ()), *((word,) if word else ()))):
            yield _powers(meaning, sign * exponent)


def _split(part: str) -> Iterator[tuple[str, int]]:
    yield part, 1
    match = _FACTOR.match(part)
    if match and match["exponent"]:
        yield match["symbol"].rstrip("^"), int(match["exponent"])


def _powers(meaning: str, exponent: int) -> Signature:
    over, _, under = meaning.partition("/")
    pairs = [(one, exponent) for one in over.split("*")] + [(one, -exponent) for one in under.split("*") if one]
    return frozenset(pairs)


def _joined(parts: tuple[Signature, ...]) -> Signature:
    total: dict[str, int] = {}
    for part in parts:
        for symbol, exponent in part:
            total[symbol] = total.get(symbol, 0) + exponent
    return frozenset((symbol, exponent) for symbol, exponent in total.items() if exponent)
