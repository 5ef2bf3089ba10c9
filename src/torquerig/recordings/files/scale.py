"""What one of a channel's units is in SI, and how a sidecar writes it: ``Nm_per_V: 1.0``, ``counts_per_rev: 16384``."""

from __future__ import annotations

from math import isfinite

from torquerig.errors import UnitError, did_you_mean
from torquerig.recordings.recording import Channel
from torquerig.units import UNITS, parse_quantity

# which kind of unit (of units.UNITS) each quantity is measured in; the reading of a tacho is a bare number
KINDS = {
    "torque": "torque",
    "motor_torque": "torque",
    "force": "force",
    "current": "current",
    "voltage": "voltage",
    "motor_angle": "angle",
    "angle": "angle",
    "position": "length",
    "motor_speed": "speed",
    "speed": "speed",
    "velocity": "linear speed",
    "temperature": "temperature difference",
    "tacho": "share",
}


def known_si_per_unit(quantity: str, unit: str) -> float | None:
    """Return what one ``unit`` of ``quantity`` is in SI by itself, or None where only a scale can tell.

    ``None`` for a torque in V and an angle in counts. A tacho's reading is a bare number whatever its unit, and a
    temperature in degC stays in degC (only its differences are in SI).
    """
    if quantity == "tacho" or (quantity == "temperature" and unit == "degC"):
        return 1.0
    try:
        return parse_quantity(f"1 {unit}", next(iter(UNITS[KINDS[quantity]])))
    except UnitError:
        return None


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
        Of the channel.

    Raises
    ------
    ValueError
        When the key does not fit the unit or the quantity, or the number cannot be a scale.
    """
    if isinstance(number, bool) or not isinstance(number, int | float) or not isfinite(number) or number == 0:
        raise ValueError(f"{number!r} cannot be a scale; write a number other than 0")
    found = _si_per_unit(key, float(number), kind=KINDS[quantity], unit=unit)
    if found is not None:
        return found
    told = f"the scale does not give a {KINDS[quantity]} for each {unit!r}; write {scale_key(quantity, unit)}: NUMBER"
    fitting = [each for each, kind in KINDS.items() if _si_per_unit(key, 1.0, kind=kind, unit=unit) is not None]
    if fitting:  # a current with its torque constant is the torque that the motor makes of it
        meant = "motor_torque" if "motor_torque" in fitting and quantity == "current" else fitting[0]
        told += f", or quantity: {meant}, which it is the scale of"
    raise ValueError(told)


def _si_per_unit(key: str, number: float, *, kind: str, unit: str) -> float | None:
    """Return what a scale makes of one ``unit`` in SI of this kind of unit; None where the key is none of it."""
    over, _, under = key.partition("_per_")
    spellings = {_simple(spelling): factor for spelling, factor in UNITS[kind].items()}
    if under == _simple(unit) and over in spellings:
        return number * spellings[over]
    if over in (_simple(unit), f"{_simple(unit)}s") and under in spellings:
        return spellings[under] / number
    return None


def scale_key(quantity: str, unit: str) -> str:
    """Return the key that a sidecar needs for this unit: ``Nm_per_V``; ``counts_per_rev`` for an encoder."""
    if KINDS[quantity] == "angle" and unit == "count":
        return "counts_per_rev"
    si = {"torque": "Nm"}.get(KINDS[quantity]) or _simple(next(iter(UNITS[KINDS[quantity]])))
    return f"{si}_per_{_simple(unit)}"


def missing_scale(quantity: str, unit: str) -> str:
    """Return the sentence for a unit that needs a scale and has none."""
    hint = ""
    kind = KINDS[quantity]
    if unit not in ("V", "mV", "mA", "count", "FS"):
        hint = f"; as a unit of {kind}, {did_you_mean(unit, UNITS[kind])}"
    return f"a {quantity} in {unit} needs its scale; add {scale_key(quantity, unit)}: NUMBER{hint}"


def written_scale(channel: Channel) -> dict[str, float]:
    """Return the scale entry for a sidecar, empty where the unit says it all; it reads back to the same float."""
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
