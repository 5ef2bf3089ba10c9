"""The numbers of a MATLAB file with their paths: fields of structs, labelled signals of scopes and loggers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from torquerig.recordings.files.matlab.stated_rate import states_rate
from torquerig.recordings.files.matlab.tree import Node, Numbers, Unread, Variables
from torquerig.recordings.names.time_column import time_column

_LABELS = ("label", "name", "title", "signalname")
_DATA = ("data", "values", "value", "y")
_UNITS = ("unit", "units", "einheit")
# the lists of signals of Simulink's scopes and of dSPACE's recordings, also where they have one element
_SIGNALS = ("signals", "X", "Y")
HEADER = "_Header"
"""End of the names of structs that describe another variable; their texts stay leaves."""
_SECONDS = ("", "s", "sec", "second", "seconds", "-")


@dataclass(frozen=True, kw_only=True)
class Leaf:
    """An array of numbers, or a variable that is not read.

    Parameters
    ----------
    path : tuple of str
        Variable, fields, and the label where the file gives one.
    node : Numbers or Unread or str
        A text is a variable that is not read.
    unit : str
        As the struct around it states; empty where it does not.
    is_time : bool
        Whether the others in the same struct were sampled at these times [s].
    scope : tuple of str
        The struct whose time and rate apply.
    rate : float
        Sample rate that the file states for these numbers alone [Hz]; 0 where it does not.
    columns : tuple of str
        Names that the file gives the columns of a matrix; empty where it does not.
    note : str
        What the reader did with the numbers, or left undone.
    """

    path: tuple[str, ...]
    node: Numbers | Unread | str
    unit: str = ""
    is_time: bool = False
    scope: tuple[str, ...] = field(default=())
    rate: float = 0.0
    columns: tuple[str, ...] = ()
    note: str = ""


def leaves_of(variables: Variables) -> list[Leaf]:
    """Return all numbers and unread variables, in the order of the file."""
    return [leaf for name, node in variables.items() for leaf in _leaves(node, (name,), ())]


def _leaves(node: Node, path: tuple[str, ...], scope: tuple[str, ...]) -> Iterator[Leaf]:
    if not isinstance(node, list):
        unit = node.unit if isinstance(node, Numbers) else ""
        yield Leaf(path=path, node=node, unit=unit, is_time=is_time_name(path[-1]), scope=scope)
        return
    for number, element in enumerate(node, 1):
        own = (*path[:-1], f"{path[-1]}_{number}") if len(node) > 1 else path
        yield from _fields(element, own, scope, is_labelled=len(node) > 1 or path[-1] in _SIGNALS)


def _fields(
    element: dict[str, Node], path: tuple[str, ...], scope: tuple[str, ...], *, is_labelled: bool
) -> Iterator[Leaf]:
    """Yield the leaves of one struct; its unit belongs to its data, and in a list of signals its label names them."""
    lowered = {name.lower() for name in element}
    # a struct with a time, a rate or an X axis is a clock for its fields; without, the struct around it is
    has_clock = any(map(is_time_name, lowered)) or any(map(states_rate, element)) or {"x", "y"} <= lowered
    own = path if has_clock else scope
    label, unit = _text(element, _LABELS), _text(element, _UNITS)
    signals = [
        name for name, node in element.items()
        if isinstance(node, Numbers) and node.size > 1 and not is_time_name(name)
    ]  # fmt: skip
    data = next((name for name in signals if name.lower() in _DATA), signals[0] if len(signals) == 1 else None)
    for name, node in element.items():
        if isinstance(node, str) and name.lower() in (*_LABELS, *_UNITS) and not path[-1].endswith(HEADER):
            continue
        if name != data:
            yield from _leaves(node, (*path, name), own)
        elif label and is_labelled and isinstance(node, Numbers):
            is_axis = path[-1].partition("_")[0] == "X" and unit.lower() in _SECONDS
            is_time = is_axis or is_time_name(label)
            label = "time_s" if is_axis and not is_time_name(label) else label
            name_parts = (*path[:1], label) if label != path[0] else (label,)
            yield Leaf(path=name_parts, node=node, unit=unit, is_time=is_time, scope=own)
        else:
            for leaf in _leaves(node, (*path, name), own):
                yield replace(leaf, unit=unit or leaf.unit)


def is_time_name(name: str) -> bool:
    """Return whether a field of this name holds the times of the others."""
    return time_column([name]) is not None


def _text(element: dict[str, Node], names: tuple[str, ...]) -> str:
    found = {name.lower(): node for name, node in element.items() if isinstance(node, str)}
    return next((str(found[name]).strip() for name in names if name in found), "")
