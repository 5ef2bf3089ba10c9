"""Print docs/parameters.md: every field of every part and effect, from the ``Parameter`` declarations in the code.

``python docs/parameters.py > docs/parameters.md``; tests/docs/test_parameters_page.py fails where the page is old.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import MISSING, Field, fields
from inspect import getdoc
from math import inf
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

from torquerig import mechanisms
from torquerig.parameter import Parameter
from torquerig.rig import parts
from torquerig.rig.assembly import Part
from torquerig.scenario.reading import KINDS

INTRODUCTION = """# Parameters of parts and effects

*For those who write a scenario. At the end you know what may be written under `rig:`, with units, bounds and defaults.*

Made by `docs/parameters.py` from the declarations in `src/torquerig`; do not edit by hand.

Every part and effect has a `kind:` (the headings below). A part on a shaft may also state `after:`, the part to which
it is fixed. Write a value with any unit of its kind (`1.5 kg*cm^2` for `kg*m^2`). The table shows the unit inside the
code; the bounds are in that unit. A dash means a pure number, a name or a list. Equations and their validity:
[models](models.md).

An effect on a part that moves in a line (`at:` or `gear:` names a `slide`, `link` or `force_sensor`) is written in N,
kg and m where the table has N*m, kg*m^2 and rad: `12 N`, `15 mm/s`, `3 N*s^2/m^2`.

Next to `rig:` a scenario has `scenario:` (a title), `measured:` (the part whose torque is read, or the
`imposed_motion` whose effort is) and `operating_point:`, with `motor_speed:` or `output_speed:`,
`load: {occupancy:, particle_size:}`,
`profile:` and `duty_cycle:`, `speed_set_point_error_max:` and `slow_speed_wander:`; the shipped scenarios show them.
`temperature_change: 10 K` is the largest change of the sensor's temperature since its zero was set; the uncertainty
budget of a study counts the drift over it.
"""


def page() -> str:
    """Return the whole page."""
    lines = [INTRODUCTION]
    for title, room in (("Parts", parts), ("Effects", mechanisms)):
        lines.append(f"## {title}\n")
        lines += [section(kind, cls) for kind, cls in KINDS.items() if cls.__name__ in room.__all__]
    return "\n".join(lines)


def section(kind: str, cls: type[Part]) -> str:
    """Return heading, first sentence and table of one kind; another word for the same class refers to the first."""
    first = next(word for word, known in KINDS.items() if known is cls)
    if kind != first:
        return f"### {kind}\n\nThe fields of `{first}`; docs and errors of the class say what this kind asks for.\n"
    module = sys.modules[cls.__module__]
    told = (getdoc(module) or "").splitlines()[0].replace("``", "`")
    hints = get_type_hints(cls, include_extras=True)
    fixed = {"name", "after", "kind"} | ({"group"} if len(get_args(hints["group"])) < 2 else set())
    written = [one for one in fields(cls) if one.name not in fixed]
    own = vars(cls)["__annotations__"]
    written.sort(key=lambda one: one.name not in own and one.default is not MISSING)  # what a family shares comes last
    rows = [row(one, hints[one.name]) for one in written]
    group = f" Counted to: {cls.group}." if cls.group else ""
    head = ["| field | unit | allowed | default | meaning |", "|---|---|---|---|---|"]
    return "\n".join([f"### {kind}\n", f"{told}{group}\n", *head, *rows, ""])


def row(one: Field[Any], hint: Any) -> str:
    """Return the table row of one field."""
    declared = next(declarations(hint), None)
    if declared is None:
        return f"| `{one.name.rstrip('_')}` | - | {allowed(hint)} | {default(one)} | - |"
    unit = "-" if declared.unit == "1" else f"`{declared.unit}`"
    several = {dict: ", one per key", tuple: ", one per entry"}.get(get_origin(hint), "")
    return f"| `{one.name.rstrip('_')}` | {unit} | {bounds(declared)} | {default(one)} | {declared.meaning}{several} |"


def declarations(hint: Any) -> Iterator[Parameter]:
    """Yield the Parameter declarations anywhere inside a type."""
    if get_origin(hint) is Annotated:
        yield from (note for note in hint.__metadata__ if isinstance(note, Parameter))
    for inner in get_args(hint):
        yield from declarations(inner)


def bounds(declared: Parameter) -> str:
    """Return the bounds in words of mathematics: ``> 0, <= 1``."""
    words = [f"> {declared.above:g}"] if declared.above > -inf else []
    words += [f">= {declared.low:g}"] if declared.low > -inf else []
    words += [f"<= {declared.high:g}"] if declared.high < inf else []
    return ", ".join(words) or "any"


def allowed(hint: Any) -> str:
    """Return what a field without a Parameter takes."""
    if get_origin(hint) is Literal:
        return " or ".join(str(choice) for choice in get_args(hint))
    words = {str: "text", int: "whole number", float: "number", type(None): "none"}
    if hint in words:
        return words[hint]
    inner = [word for part in get_args(hint) if (word := allowed(part))]
    opening = {dict: "mapping of ", tuple: "list of "}.get(get_origin(hint), "")
    return opening + (" to " if opening.startswith("mapping") else " or ").join(inner) or getattr(hint, "__name__", "")


def default(one: Field[Any]) -> str:
    """Return the default as it would be written, or that there is none."""
    if one.default is MISSING and one.default_factory is MISSING:
        return "required"
    if one.default is None:
        return "none"
    if one.default is MISSING or one.default == ():
        return "empty"
    return f"{one.default:g}" if isinstance(one.default, float) else str(one.default) or "empty"


if __name__ == "__main__":
    sys.stdout.write(page())
