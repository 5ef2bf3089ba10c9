"""Reading of tooth counts from a scenario: one mapping per stage; its keys determine the kind of stage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

from torquerig.errors import InputError, did_you_mean
from torquerig.orders.kinematics.teeth import Planetary, Spur

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler
    from pydantic_core import CoreSchema

EXAMPLE = "write for example {sun: 21, ring: 84, planets: 3} or {pinion: 20, wheel: 50}"


def read_teeth(written: Any) -> tuple[Planetary | Spur, ...]:
    """Return the stages that a mapping, or a list of mappings, states; InputError for a faulty one."""
    listed = written if isinstance(written, list | tuple) else [written]
    return tuple(one if isinstance(one, Planetary | Spur) else _stage(one) for one in listed)


@dataclass(frozen=True)
class TeethList:
    """Annotation of a field of tooth counts: pydantic reads it by :func:`read_teeth` and reports faults with place."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        from pydantic_core import core_schema

        def validator(written: Any) -> Any:
            try:
                return read_teeth(written)
            except InputError as error:
                raise ValueError(str(error)) from None

        return core_schema.no_info_plain_validator_function(validator)


def _stage(written: Any) -> Planetary | Spur:
    if not isinstance(written, Mapping):
        raise InputError(f"{written!r} is no set of teeth; {EXAMPLE}")
    kind: type[Planetary | Spur] = Planetary if {"sun", "ring"} & set(written) else Spur
    known = [one.name for one in fields(kind)]
    for key, value in written.items():
        if key not in known:
            raise InputError(f"{key!r} is no key of a set of teeth; {did_you_mean(str(key), known)}")
        whole = isinstance(value, int) and not isinstance(value, bool)
        if key not in ("fixed", "internal") and not whole and value is not None:
            raise InputError(f"{key}: {value!r} is no tooth count; write a whole number")
    if "internal" in written and not isinstance(written["internal"], bool):
        raise InputError(f"internal: {written['internal']!r} is no yes or no; write true or false")
    for key in ("sun", "ring") if kind is Planetary else ("pinion", "wheel"):
        if written.get(key) is None:
            raise InputError(f"the set of teeth {dict(written)!r} has no {key}; {EXAMPLE}")
    return kind(**written)
