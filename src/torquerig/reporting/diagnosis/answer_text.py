"""A diagnosis as plain text for the terminal: what is missing, how large, how sure, what to do next."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from torquerig.plain_table import cut, wrapped
from torquerig.reporting.diagnosis.sentences import fact_text, mechanism_text
from torquerig.reporting.layout import plain

MOST_LINES = 15  # of the answer, so that it fits into a small terminal without scrolling
_QUANTITIES = ("time", "speed", "position")  # axes along which a nameless effect extends
_NEXT_LETTERS = 330  # three lines
_NEXT: Mapping[str, str] = {
    "adequate": "use the scenario as it is; more runs at other speeds and loads can show smaller effects",
    "missing_physics": "check the named part on the rig; continue with the completed scenario (--model writes it)",
    "setup_error": "correct the named fact in the scenario or sidecar, and run the diagnosis again",
    "unexplained": "record runs at two more speeds and one more load, and add them to this command: what keeps its "
    "order, its frequency or its level there shows the kind of effect",
}
"""What to do next for each verdict, where the diagnosis names no run itself."""


def answer_lines(data: Mapping[str, Any], *, verdict: str, remarks: Sequence[str] = ()) -> list[str]:
    """Return the answer in at most 15 lines.

    Parameters
    ----------
    data : mapping
        The diagnosis in the contract's form.
    verdict : str
        The verdict in sentences.
    remarks : sequence of str
        Printed as far as there are lines left; the last line says where the others are.
    """
    head = wrapped(verdict).splitlines()
    size = wrapped(_residual(data)).splitlines()
    last = wrapped(f"Next: {_next(data)}.").splitlines()
    details = [line for one in _details(data) for line in wrapped(one).splitlines()]
    room = MOST_LINES - len(head) - len(size) - len(last)
    details = _cut(details, room - bool(remarks), "findings")
    noted = _cut([line for one in remarks for line in wrapped(one).splitlines()], room - len(details), "remarks")
    return [*head, *size, *details, *noted, *last][:MOST_LINES]


def _cut(lines: list[str], room: int, what: str) -> list[str]:
    """Return the lines, or so many of them that a last one says where the others are."""
    if len(lines) <= room:
        return lines
    return (
        [*lines[: room - 1], f"More {what} are in the JSON and in the report (--json, --report)."] if room > 0 else []
    )


def _residual(data: Mapping[str, Any]) -> str:
    """Return the rms of the residual where the diagnosis states it."""
    rms = data.get("rms")
    if not rms:
        return ""
    unit = str(rms["unit"]).replace("*", " ")
    least = f" Random errors alone make {plain(rms['true_model'])} {unit}." if "true_model" in rms else ""
    ends = f"{plain(rms['before'])} {unit} before, {plain(rms['after'])} {unit} after"
    return f"Rms residual on held-out data: {ends}.{least}"


def _details(data: Mapping[str, Any]) -> Iterator[str]:
    for one in data.get("setup", ()):
        alike = " or ".join(map(mechanism_text, one.get("equivalent_to", ())))
        also = f"; the same could be {alike}" if alike else ""
        ends = f"stated {one['stated']}, estimated {_value(one['estimated'])}"
        yield f"- {fact_text(one)}: {ends}; {_sure(one)} sure{also}"
    for one in data["findings"]:
        parameters = ", ".join(f"{name} {_value(value)}" for name, value in one["parameters"].items())
        yield f"- {mechanism_text(one['mechanism'])}, {_sure(one)} sure: {parameters or 'no parameter'}"
    for one in data.get("unnamed", ()):
        if not one.get("minor"):
            size = f", {_value(one['size'])}" if one.get("size") else ""
            yield f"- no name: {nameless_text(one)}{size}; {_sure(one)} sure"


def nameless_text(one: Mapping[str, Any]) -> str:
    """Return what an effect without a name is, and where; a function of a quantity has no place."""
    if one["axis"] in _QUANTITIES:
        return f"a function of the {one['axis']}"
    place = f"{one['at']:g} {one['axis']}"
    if one["axis"].endswith("shaft"):
        place = f"order {one['at']:g} of the {one['axis'].replace('_', ' ')}"
    return f"{mechanism_text(one['kind'])} at {place}"


def _value(value: Mapping[str, Any]) -> str:
    unit = "" if value["unit"] in ("1", "") else f" {value['unit'].replace('*', ' ')}"
    low, high = value["ci95"]
    if low == high:
        return f"{plain(value['value'], 5)}{unit}"
    return f"{plain(value['value'])} ({plain(low)} to {plain(high)}){unit}"


def _sure(one: Mapping[str, Any]) -> str:
    return f"{100 * one['confidence']:.0f} %"


def _next(data: Mapping[str, Any]) -> str:
    runs = [one.get("next_experiment") for one in data["findings"]] + [data.get("next_experiment")]
    named = next((run for run in runs if run), None)
    return cut(str(named or _NEXT[data["verdict"]]).rstrip("."), _NEXT_LETTERS)
