"""Units of channels: those of ``torquerig.units``, encoder counts, degrees Celsius, bare numbers."""

from __future__ import annotations

from torquerig.units import Meaning, meanings

_COUNT_WORDS = (
    "count", "counts", "cnt", "cnts", "inc", "incs", "increment", "increments", "inkr", "inkremente", "tick", "ticks",
    "pulse", "pulses", "impulse", "impulses", "impulse(s)", "step", "steps", "lsb", "digit", "digits",
)  # fmt: skip
# of column headers only: in a data sheet "Grad" and "C" would be read without a context
_HEADER_WORDS = {"Grad": ("angle", "deg"), "C": ("temperature", "degC"), "F": ("temperature", "degF")}
_TEMPERATURES = {"degc": "degC", "°c": "degC", "celsius": "degC", "degf": "degF", "°f": "degF", "fahrenheit": "degF"}
_BARE = ("", "-", "--", "1", "[-]", "(-)", "none", "n/a", "unitless", "dimensionless", "a.u.", "au", "raw", "num")
# upper and lower case of the newton metre are mixed up often enough; only a torque can be meant
_ONLY_TORQUE = ("nm", "NM", "nM", "n*m", "N*M", "N-M", "N.M")


def unit_meanings(text: str) -> tuple[Meaning, ...]:
    """Return what the unit ``text`` of a column may mean, one entry a kind; empty where it is not known.

    The kinds are those of ``torquerig.units.UNITS``, and ``count``, ``temperature`` and ``bare`` (no unit).
    A count, a degree Celsius and a bare number have the factor 1.
    """
    plain = text.strip()
    if plain.lower() in _BARE:
        return (Meaning(kind="bare", symbol="1", factor=1.0),)
    if plain.lower() in _COUNT_WORDS:
        return (Meaning(kind="count", symbol="count", factor=1.0),)
    temperature = _TEMPERATURES.get(plain.lower())
    if temperature:
        return (Meaning(kind="temperature", symbol=temperature, factor=1.0),)
    found = list(meanings(plain))
    if plain in _HEADER_WORDS:
        kind, symbol = _HEADER_WORDS[plain]
        found.append(Meaning(kind=kind, symbol=symbol, factor=meanings("deg")[0].factor if kind == "angle" else 1.0))
    if plain in _ONLY_TORQUE and all(one.kind != "torque" for one in found):
        found.append(Meaning(kind="torque", symbol="N*m", factor=1.0))
    return tuple(found)


def known_unit(text: str) -> str | None:
    """Return the first spelling of the unit ``text`` as ``torquerig`` writes it, or None where it is not known.

    Words that are also names (``count``, ``min``) are units here; the caller knows from the place of the cell.
    """
    found = unit_meanings(text)
    return found[0].symbol if found else None
