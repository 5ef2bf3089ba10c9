"""The SI value of a channel's unit, and its key in a sidecar: ``Nm_per_V: 1.0``, ``counts_per_rev: 16384``."""

from __future__ import annotations

from math import isfinite

from torquerig.errors import did_you_mean
from torquerig.recordings.names.channel_units import unit_meanings
from torquerig.recordings.quantities import KINDS, OTHER
from torquerig.recordings.recording import Channel
from torquerig.units import UNITS


def known_si_per_unit(quantity: str, unit: str) -> float | None:
    """Return the SI value of one ``unit`` of ``quantity``, or None where a scale is required.

    ``None`` for a torque in V and an angle in counts. A tacho's reading is a bare number in any unit, a channel of an
    unknown quantity is not converted, and neither is a temperature in degC (only its differences are in SI).
    """
    if quantity in ("tacho", OTHER):
        return 1.0
    fitting = {one.factor for one in unit_meanings(unit) if one.kind in KINDS[quantity] and one.symbol != "degF"}
    return fitting.pop() if len(fitting) == 1 else None


def si_per_unit_from(key: str, number: float, *, quantity: str, unit: str) -> float:
    """Return the SI value of one ``unit`` from a scale such as ``Nm_per_V: 5.0`` or ``counts_per_rev: 16384``.

    Parameters
    ----------
    key : str
        ``<a>_per_<b>``, where one side is ``unit`` (``counts`` may stand for ``count``) and the other any spelling of
        a unit of ``quantity`` without its ``*`` and with ``_`` for ``/``.
    number : float
        The written scale, not 0.
    quantity, unit : str
        Quantity and unit of the channel.

    Raises
    ------
    ValueError
        When the key does not fit the unit or the quantity, or the number cannot be a scale.
    """
    if isinstance(number, bool) or not isinstance(number, int | float) or not isfinite(number) or number == 0:
        raise ValueError(f"{number!r} cannot be a scale; write a number other than 0")
    if quantity == OTHER:
        raise ValueError("a channel of the quantity 'other' has no scale; leave the scale out, or state the quantity")
    found = _si_per_unit(key, float(number), kind=_kind(quantity), unit=unit)
    if found is not None:
        return found
    message = f"the scale does not give a {_kind(quantity)} per {unit!r}; write {scale_key(quantity, unit)}: NUMBER"
    scaled = [each for each in KINDS if each != OTHER]
    fitting = [each for each in scaled if _si_per_unit(key, 1.0, kind=_kind(each), unit=unit) is not None]
    if fitting:  # a current times its torque constant is the motor's torque
        meant = "motor_torque" if "motor_torque" in fitting and quantity == "current" else fitting[0]
        message += f", or quantity: {meant}, whose scale this is"
    raise ValueError(message)


def _kind(quantity: str) -> str:
    """Return the kind of unit of a quantity; a temperature's scale is one of differences."""
    return "temperature difference" if quantity == "temperature" else KINDS[quantity][0]


def _si_per_unit(key: str, number: float, *, kind: str, unit: str) -> float | None:
    """Return the SI value of one ``unit`` by a scale of this kind of unit; None where the key does not belong to it."""
    over, _, under = key.partition("_per_")
    spellings = {_simple(spelling): factor for spelling, factor in UNITS[kind].items()}
    if under == _simple(unit) and over in spellings:
        return number * spellings[over]
    if over in (_simple(unit), f"{_simple(unit)}s") and under in spellings:
        return spellings[under] / number
    return None


def scale_key(quantity: str, unit: str) -> str:
    """Return the scale's key in a sidecar: ``Nm_per_V``; ``counts_per_rev`` for an encoder."""
    if _kind(quantity) == "angle" and unit == "count":
        return "counts_per_rev"
    si = {"torque": "Nm"}.get(_kind(quantity)) or _simple(next(iter(UNITS[_kind(quantity)])))
    return f"{si}_per_{_simple(unit)}"


def missing_scale(quantity: str, unit: str) -> str:
    """Return the error text for a unit whose required scale is missing."""
    hint = ""
    kind = _kind(quantity)
    if unit not in ("V", "mV", "mA", "count", "FS"):
        hint = f"; as a unit of {kind}, {did_you_mean(unit, UNITS[kind])}"
    return f"a {quantity} in {unit} needs its scale; add {scale_key(quantity, unit)}: NUMBER{hint}"


def written_scale(channel: Channel) -> dict[str, float]:
    """Return the scale entry for a sidecar, empty where the unit needs none; it reads back to the same float."""
    if known_si_per_unit(channel.quantity, channel.unit) == channel.si_per_unit:
        return {}
    key = scale_key(channel.quantity, channel.unit)
    if key != "counts_per_rev":
        return {key: channel.si_per_unit}
    counts = round(UNITS["angle"]["rev"] / channel.si_per_unit)
    if counts and UNITS["angle"]["rev"] / counts == channel.si_per_unit:
        return {key: counts}
    return {"rad_per_count": channel.si_per_unit}


def _simple(unit: str) -> str:
    return unit.replace("*", "").replace("·", "").replace("/", "_")
