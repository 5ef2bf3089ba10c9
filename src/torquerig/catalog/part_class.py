"""Classes of parts: intervals for what a data sheet never states, filled in where an entry says ``like: CLASS``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, TypeAdapter, ValidationInfo, create_model, field_validator

from torquerig.catalog.coupling import Coupling
from torquerig.catalog.derived_keys import with_derived_keys
from torquerig.catalog.entry import UNKNOWN, Entry, Record, Text, estimates
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.sensor import Sensor
from torquerig.document import Document
from torquerig.errors import InputError, did_you_mean
from torquerig.parameter import Estimate

KINDS: dict[str, type[Entry]] = {"motor": Motor, "gearbox": Gearbox, "sensor": Sensor, "coupling": Coupling}
OF_ONE_WINDING = frozenset({"torque_constant", "rated_current", "phase_resistance", "phase_inductance"})
"""Filled together or not at all: a motor that is wound for another voltage has other values of all four."""


class PartClass(Record):
    """One class of motors, gearboxes, sensors or couplings.

    Parameters
    ----------
    of : str
        ``motor``, ``gearbox``, ``sensor`` or ``coupling``.
    kinds : tuple of str
        The kinds of parts to which it applies (``[pmsm]``); empty where it applies to all.
    values : mapping
        Fields of such an entry as they are written, each an interval or a choice with evidence and source.

    Raises
    ------
    ValueError
        When a kind does not exist.
    """

    name: Text
    title: Text
    note: str = ""
    of: Literal["motor", "gearbox", "sensor", "coupling"]
    kinds: tuple[Text, ...] = ()
    values: dict[str, Any]

    @field_validator("kinds")
    @classmethod
    def _exist(cls, kinds: tuple[str, ...], info: ValidationInfo) -> tuple[str, ...]:
        field = KINDS[info.data["of"]].model_fields.get("kind") if "of" in info.data else None
        known = get_args(field.annotation) if field else ()
        for kind in kinds:
            if kind not in known:
                raise ValueError(f"there is no kind {kind!r} of {info.data.get('of')}; {did_you_mean(kind, known)}")
        return kinds

    def known(self) -> dict[str, Estimate]:
        """Return the intervals of the class by dotted field."""
        values = values_adapter(KINDS[self.of]).validate_python(self.values)
        return {name: value for name, value in estimates(values) if value.source}


@cache
def values_adapter(kind: type[Entry]) -> TypeAdapter[Record]:
    """Return the schema of the values of a class: every estimated field of ``kind``, none of them required."""
    return TypeAdapter(_partial(kind))


def _partial(record: type[BaseModel]) -> type[Record]:
    fields: dict[str, Any] = {}
    for name, field in record.model_fields.items():
        if field.annotation is Estimate:
            fields[name] = (Annotated[(Estimate, *field.metadata)], UNKNOWN)
        elif inner := next((one for one in _records(field.annotation) if _has_estimates(one)), None):
            fields[name] = (_partial(inner) | None, None)
    return create_model(f"{record.__name__}Values", __base__=Record, **fields)


def _records(annotation: Any) -> Iterator[type[BaseModel]]:
    for one in (annotation, *get_args(annotation)):
        if isinstance(one, type) and issubclass(one, BaseModel):
            yield one


def _has_estimates(record: type[BaseModel]) -> bool:
    return any(field.annotation is Estimate for field in record.model_fields.values())


def completed(document: Document, kind: type[Entry], classes: Mapping[str, PartClass]) -> Document:
    """Return the document of an entry with what it does not state filled from the class that ``like`` names.

    Filled values have the evidence CLASS, and the name of the class in their source. The torque constant, current,
    resistance and inductance of a motor are filled only where none of them is stated.

    Raises
    ------
    InputError
        With file, line and key: where the class does not exist, or is one of other parts.
    """
    data = document.data
    if not isinstance(data, dict) or "like" not in data:
        return document
    part = _class_of(document, kind, classes)
    filled = dict(data)
    stated = OF_ONE_WINDING & data.keys()
    without = OF_ONE_WINDING if stated else frozenset()
    names = list(_fill(filled, part.values, part.name, without))
    return with_derived_keys(document, filled, origins=dict.fromkeys(names, ("like",)))


def _class_of(document: Document, kind: type[Entry], classes: Mapping[str, PartClass]) -> PartClass:
    wanted, place = document.data["like"], document.place(("like",))
    of = next(word for word, known in KINDS.items() if known is kind)
    part = classes.get(wanted) if isinstance(wanted, str) else None
    if part is None:
        fitting = [name for name, one in classes.items() if one.of == of]
        raise InputError(f"{place}: there is no class {wanted!r}; {did_you_mean(str(wanted), fitting)}")
    own = document.data.get("kind")
    if part.of != of or (part.kinds and own not in part.kinds):
        here = of if part.of != of else f"{of} of kind {own}"
        fitting = [name for name, one in classes.items() if one.of == of and (not one.kinds or own in one.kinds)]
        raise InputError(f"{place}: {wanted!r} is a class of {_applies(part)}, and this is a {here}; "
                         f"the classes for it are {', '.join(sorted(fitting)) or 'none'}")  # fmt: skip
    return part


def _applies(part: PartClass) -> str:
    return ("gearboxes" if part.of == "gearbox" else f"{part.of}s") + (
        f" of kind {' or '.join(part.kinds)}" if part.kinds else ""
    )


def _fill(
    data: dict[str, Any], values: Mapping[str, Any], name: str, without: Iterable[str]
) -> Iterator[tuple[str, ...]]:
    """Put the values that ``data`` lacks into it; yield their paths."""
    for field, value in values.items():
        if field in without:
            continue
        if isinstance(value, Mapping) and "evidence" not in value:
            inner = data.get(field)
            if field in data and not isinstance(inner, dict):
                continue  # a wrong value is refused when the entry is validated
            if isinstance(inner, dict) and "known_lines" in inner:
                continue  # lines that are known one by one replace the shares of a class
            data[field] = dict(inner or {})
            yield from ((field, *path) for path in _fill(data[field], value, name, without))
        elif field not in data:
            source = f"class {name}: {value['evidence']}, {value['source']}"
            data[field] = {**value, "evidence": "CLASS", "source": source}
            yield (field,)
