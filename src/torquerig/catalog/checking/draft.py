"""A commented file with blanks for a new entry, from the declarations of its schema."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, get_args

from torquerig.catalog.entry import Entry
from torquerig.catalog.part_class import KINDS, PartClass
from torquerig.catalog.reading import BLANK
from torquerig.parameter import Estimate, Parameter

FIRST = {
    "motor": ("rated_torque", "peak_torque", "rated_speed", "max_speed", "rotor_inertia", "pole_pairs", "slots"),
    "gearbox": ("nominal_torque", "peak_torque", "input_inertia", "efficiency", "backlash"),
    "sensor": ("range_torque", "sensitivity", "bandwidth"),
    "coupling": ("rated_torque", "stiffness", "inertia"),
}
"""What makers print about each kind of part; all else is commented out, and filled from a class."""
SHOWN = {"kg*m^2": "kg*cm^2", "V/(N*m)": "V/(N*m)", "N*m*s/rad": "N*m*s/rad", "N*m/Arms": "N*m/Arms"}
PRINTED = """\
# Figures in the maker's own words, converted when the file is read: delete the # of those that the sheet prints.
# as_printed:
#   evidence: DOC
#   source: "____"
#   winding: star                                   # or delta
#   voltage_constant: ____ V/krpm line-to-line rms  # or per phase, peak; speed_constant: ____ rpm/V dc
#   torque_constant: ____ N*m/A rms                 # or peak, dc
#   resistance: ____ ohm line-to-line               # or per phase
#   inductance: ____ mH line-to-line                # or electrical_time_constant: ____ ms
#   rated_current: ____ A rms
#   no_load_current: ____ A rms
#   no_load_speed: ____ rpm
#   rated_power: ____ W                             # or S3 40 %
#   intermittent_torque: ____ N*m S3 40 %
#   cogging: ____ % of rated torque peak-to-peak    # or amplitude; torque_ripple in the same way
"""


def draft(of: str, name: str, classes: Mapping[str, PartClass], *, like: str = "") -> str:
    """Return the text of a new entry with blanks ``____``; it is read once they are filled or their lines deleted.

    Parameters
    ----------
    of : str
        ``motor``, ``gearbox``, ``sensor`` or ``coupling``.
    name : str
        The name of the entry.
    classes : mapping of str to PartClass
        The classes to choose from.
    like : str
        The class from which it is filled; empty where it is left blank.
    """
    kind = KINDS[of]
    part = classes.get(like)
    first = FIRST[of]
    if part is not None and part.kinds == ("induction",):
        first = tuple("rotor_bars" if field == "slots" else field for field in first)
    fitting = sorted(label for label, one in classes.items() if one.of == of)
    lines = [
        f"# A {of}. Fill the blanks ({BLANK}) from the data sheet, with units as printed. Delete the lines that it",
        "# does not state: the class that like: names fills them with intervals. A value is {value: ...} where a sheet",
        "# states it, else {low: ..., high: ...} or {one_of: [...]}. Evidence: DOC the maker's sheet, SC a sheet of",
        "# the same class, RT rule of thumb.",
        f"name: {name}",
        f'title: "{BLANK}"',
        f"like: {like or BLANK}  # {', '.join(fitting)}",
        *_kind_lines(kind, part),
        "",
        "# what makers print",
        *(_line(field, _declared(kind, field)) for field in first),
        "",
        *([PRINTED] if of == "motor" else []),
        "# further fields",
        *(f"# {_line(field, declared)}" for field, declared in _others(kind, first)),
    ]
    return "\n".join(lines) + "\n"


def _kind_lines(kind: type[Entry], part: PartClass | None) -> Iterator[str]:
    field = kind.model_fields.get("kind")
    if field is not None:
        known = get_args(field.annotation)
        only = part.kinds[0] if part is not None and len(part.kinds) == 1 else BLANK
        yield f"kind: {only}  # {', '.join(known)}"
    if "ratio" in kind.model_fields:
        yield f"ratio: {BLANK}  # motor turns per output turn"
    if "starts" in kind.model_fields and (part is None or part.kinds in ((), ("worm",))):
        hidden = "" if part is not None and part.kinds else "# "
        yield f"{hidden}starts: {BLANK}  # threads of a worm"
        yield f"{hidden}wheel_teeth: {BLANK}  # teeth of its wheel"


def _declared(kind: type[Entry], field: str) -> Parameter:
    return next(note for note in kind.model_fields[field].metadata if isinstance(note, Parameter))


def _others(kind: type[Entry], first: tuple[str, ...]) -> Iterator[tuple[str, Parameter]]:
    for name, field in kind.model_fields.items():
        if field.annotation is Estimate and name not in first:
            yield name, _declared(kind, name)


def _line(field: str, declared: Parameter) -> str:
    unit = SHOWN.get(declared.unit, declared.unit)
    value: Any = BLANK if unit == "1" else f"{BLANK} {unit}"
    return f'{field}: {{value: {value}, evidence: DOC, source: "{BLANK}"}}  # {declared.meaning}'
