"""The values of a part: what its kind may state, what the file states, and what applies where it states nothing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, Field, dataclass, fields
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args, get_origin, get_type_hints

from torquerig.parameter import Parameter
from torquerig.rig.assembly import HOST_FIELDS, Part
from torquerig.scenario.kinds import KINDS

if TYPE_CHECKING:
    from torquerig.scenario.model import Scenario

SHELVES: Mapping[str, str] = {
    "motor": "motors", "gear": "gearboxes", "planetary_gear": "gearboxes", "fixed_axis_gear": "gearboxes",
    "worm_gear": "gearboxes", "induction_drive": "motors", "torque_sensor": "sensors", "coupling": "couplings",
}  # fmt: skip
"""The shelf of the catalog for each kind of part that is bought."""
NOT_VALUES = ("name", "kind", "group")
DIGITS = 5  # of a value from the catalog, shown as a hint


@dataclass(frozen=True, kw_only=True)
class PartValue:
    """One value that a part may state.

    Parameters
    ----------
    key : str
        In the file.
    label : str
        Name with its unit.
    meaning : str
    hint : str
        What applies where nothing is stated: from the catalog, by default, or that it must be stated.
    is_stated, is_required : bool
    choices : tuple of str
        The permitted words, where there are only a few; else empty.
    names_part : bool
        Whether it is the name of another part.
    """

    key: str
    label: str
    meaning: str = ""
    hint: str = ""
    is_stated: bool = False
    is_required: bool = False
    choices: tuple[str, ...] = ()
    names_part: bool = False


def part_values(name: str, written: Mapping[str, Any], good: Scenario | None) -> tuple[PartValue, ...]:
    """Return the values of a part: stated ones in the order of the file, required ones, the others.

    Keys that its kind does not know are among the stated ones.

    Parameters
    ----------
    name : str
    written : mapping
        As the file states the part.
    good : Scenario or None
        The last scenario that could be read, for the values of the catalog.
    """
    kind = KINDS.get(str(written.get("kind")))
    known = [] if kind is None else [_value(name, one, kind, written, good) for one in _written_fields(kind)]
    keys = {one.key for one in known}
    others = [
        PartValue(key=str(key), label=str(key).replace("_", " "), is_stated=True)
        for key in written
        if key not in keys and key not in ("kind", "catalog")
    ]
    order = [str(key) for key in written]
    first = sorted((one for one in (*known, *others) if one.is_stated), key=lambda one: order.index(one.key))
    required = [one for one in known if one.is_required and not one.is_stated]
    return (*first, *required, *(one for one in known if not (one.is_stated or one.is_required)))


def _written_fields(kind: type[Part]) -> Iterator[Field[Any]]:
    hints = get_type_hints(kind)
    for one in fields(kind):
        groups = one.name == "group" and len(get_args(hints["group"])) > 1
        if (one.name not in NOT_VALUES and not (one.name == "after" and not kind.on_shaft)) or groups:
            yield one


def _value(
    name: str, one: Field[Any], kind: type[Part], written: Mapping[str, Any], good: Scenario | None
) -> PartValue:
    hint = get_type_hints(kind, include_extras=True)[one.name]
    declared, key = next(_declarations(hint), None), one.name.rstrip("_")
    unit = "" if declared is None or declared.unit == "1" else f" [{declared.unit}]"
    is_bought = str(written.get("kind")) in SHELVES and "catalog" in written
    has_default = one.default is not MISSING or one.default_factory is not MISSING
    return PartValue(
        key=key, label=f"{key.replace('_', ' ')}{unit}", meaning="" if declared is None else declared.meaning,
        hint=_hint(name, one, good, unit.strip(" []")), is_stated=key in written,
        is_required=not has_default and not is_bought, choices=_choices(hint),
        names_part=one.name in (*HOST_FIELDS, "after", "motor", "of"),
    )  # fmt: skip


def _hint(name: str, one: Field[Any], good: Scenario | None, unit: str) -> str:
    taken = None if good is None else good.taken.get(f"{name}.{one.name}")
    if taken is not None:
        return f"{taken.used:.{DIGITS}g} {unit} (catalog)".replace("  ", " ")
    if one.default is MISSING and one.default_factory is MISSING:
        return "must be stated"
    shown = one.default if one.default is not MISSING else None
    if shown is None or shown in ((), ""):
        return ""
    return f"{shown:.{DIGITS}g} {unit}".strip() if isinstance(shown, float) else str(shown)


def _choices(hint: Any) -> tuple[str, ...]:
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    return tuple(str(one) for one in get_args(hint)) if get_origin(hint) is Literal else ()


def _declarations(hint: Any) -> Iterator[Parameter]:
    if get_origin(hint) is Annotated:
        yield from (note for note in hint.__metadata__ if isinstance(note, Parameter))
    for inner in get_args(hint):
        yield from _declarations(inner)
