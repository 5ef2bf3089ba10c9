"""The same rig in other units of torque and time: every datum with a dimension scaled, angles and volts kept.

A torque scales by ``torque``, a speed and a frequency by ``speed``; a length does not. So a mass scales by
``torque / speed^2``. Volts, amperes, euros and kelvins are kept: a sensitivity scales by ``1 / torque``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from math import isinf
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig

# powers of mass, length and time
_DIMENSIONS = {
    "kg": (1, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "Hz": (0, 0, -1), "N": (1, 1, -2), "rad": (0, 0, 0),
    "V": (0, 0, 0), "A": (0, 0, 0), "1": (0, 0, 0),
}  # fmt: skip


@dataclass(frozen=True)
class Scale:
    """``torque`` and ``speed`` of the scaled rig relative to the original [1]."""

    torque: float
    speed: float

    def of(self, unit: str) -> float:
        """Return the factor of a number with this unit."""
        top, _, bottom = unit.partition("/")
        powers = [0, 0, 0]
        for text, sign in ((top, 1), (bottom.strip("()"), -1)):
            for symbol, power in re.findall(r"([A-Za-z1]+)(?:\^(\d+))?", text):
                powers = [p + sign * int(power or 1) * d for p, d in zip(powers, _DIMENSIONS[symbol], strict=True)]
        mass, _, time = powers
        return float((self.torque / self.speed**2) ** mass * (1 / self.speed) ** time)


def scaled_rig(rig: Rig, scale: Scale) -> Rig:
    """Return the rig with every datum scaled."""
    run = rig.run if rig.run.speed is None else replace(rig.run, speed=rig.run.speed * scale.speed)
    run = replace(run, wander_cutoff=run.wander_cutoff * scale.speed)
    parts = tuple(scaled_part(part, scale, in_a_line=rig.in_a_line(part)) for part in rig.parts)
    return replace(rig, parts=parts, run=run)


def scaled_part(part: Part, scale: Scale, *, in_a_line: bool) -> Part:
    """Return the part with every field scaled by the unit that it declares."""
    hints = get_type_hints(type(part), include_extras=True)
    found = {one.name: _scaled(getattr(part, one.name), hints[one.name], scale, in_a_line) for one in fields(part)}
    return replace(part, **found)


def _scaled(value: Any, hint: Any, scale: Scale, in_a_line: bool) -> Any:
    if value is None or get_origin(hint) in (Union, UnionType):
        inner = [option for option in get_args(hint) if option is not type(None)]
        return value if value is None or not inner else _scaled(value, inner[0], scale, in_a_line)
    declared = next((note for note in getattr(hint, "__metadata__", ()) if isinstance(note, Parameter)), None)
    if declared is not None and isinstance(value, int | float):
        unit = declared.in_a_line.unit if in_a_line else declared.unit
        return value if isinf(value) else value * scale.of(unit)
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    inner = list(get_args(hint))
    if isinstance(value, Mapping):
        return {
            _scaled(key, inner[0], scale, in_a_line): _scaled(one, inner[1], scale, in_a_line)
            for key, one in value.items()
        }
    if isinstance(value, tuple | list) and inner:
        return type(value)(_scaled(one, inner[0], scale, in_a_line) for one in value)
    if is_dataclass(value) and not isinstance(value, type):
        hints = get_type_hints(type(value), include_extras=True)
        return replace(value, **{
            one.name: _scaled(getattr(value, one.name), hints[one.name], scale, in_a_line) for one in fields(value)
        })  # fmt: skip
    return value
