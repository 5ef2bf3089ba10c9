"""What a diagnosis found, from its JSON."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nicegui import ui

from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.layout import plain
from torquerig.studio.diagnosing.each_effect import HEAD
from torquerig.studio.diagnosing.question import DiagnosisShown
from torquerig.studio.server.elements import folded, table, words
from torquerig.studio.steps.answer_screen import answer_html, picture

PARAMETERS = ("parameter", "value", "95 % interval")
SETUP = ("fact", "of", "stated", "estimated", "confidence")


def show_diagnosis(found: DiagnosisShown) -> None:
    """Draw answer, curves, findings, set-up facts, nameless effects and the next run into the present element."""
    data = found.data
    ui.html(answer_html(found.answer), sanitize=False)
    for one in found.pictures[:1]:
        picture(one)
    _findings(data)
    if found.each:
        words("The reading with and without each effect", "h3")
        table(HEAD, found.each, caption="the completed model, simulated with the effect and without it")
    _setup(data.get("setup", ()))
    _unnamed(data.get("unnamed", ()))
    _next_runs(data)
    if found.pictures[1:]:
        words("Recording, nominal and completed model", "h3")
        for one in found.pictures[1:]:
            picture(one)
    _rejected(data.get("set_aside", {}))
    with folded("As the command prints it"):
        words("\n".join(found.lines), "pre")


def _findings(data: Mapping[str, Any]) -> None:
    words("Findings", "h3")
    if not data["findings"]:
        words("These recordings support no mechanism of the library.")
    for one in data["findings"]:
        variant = f" ({mechanism_text(one['variant'])})" if one.get("variant") else ""
        part = f" in {one['part']}" if one.get("part") else ""
        name = f"{mechanism_text(one['mechanism'])}{variant}{part}"
        words(f"{name}: {100 * one['confidence']:.0f} % sure", "h4")
        words(one["explanation"])
        rows = [(name, _value(value), _interval(value)) for name, value in one["parameters"].items()]
        if rows:
            table(PARAMETERS, rows, caption=f"parameters of {mechanism_text(one['mechanism'])}")
        if one["equivalent_to"]:
            alike = " or ".join(map(mechanism_text, one["equivalent_to"]))
            words(f"These recordings do not distinguish it from {alike}.")


def _setup(facts: Any) -> None:
    if not facts:
        return
    words("Facts of the set-up that look wrong", "h3")
    rows = []
    for one in facts:
        right = f"{_value(one['estimated'])} ({_interval(one['estimated'])})"
        sure = f"{100 * one['confidence']:.0f} %"
        rows.append((mechanism_text(one["kind"]), one["of"], one["stated"], right, sure))
    table(SETUP, rows)


def _unnamed(effects: Any) -> None:
    listed = [one for one in effects if not one.get("minor")]
    if not listed:
        return
    words("Effects without a name", "h3")
    with ui.element("ul"):
        for one in listed:
            words(f"{one['explanation']} ({100 * one['confidence']:.0f} % sure)", "li")


def _next_runs(data: Mapping[str, Any]) -> None:
    runs = [one.get("next_experiment") for one in data["findings"]] + [data.get("next_experiment")]
    named = list(dict.fromkeys(str(one) for one in runs if one))
    if not named:
        return
    words("Next experiment", "h3")
    with ui.element("ul"):
        for one in named:
            words(one, "li")


def _rejected(reasons: Any) -> None:
    if not isinstance(reasons, Mapping) or not reasons:
        return
    with folded("Rejected mechanisms, and why"):
        table(("mechanism", "why"), [(mechanism_text(str(name)), str(why)) for name, why in reasons.items()])


def _value(value: Mapping[str, Any]) -> str:
    unit = "" if value["unit"] in ("1", "") else f" {value['unit'].replace('*', ' ')}"
    return f"{plain(value['value'])}{unit}"


def _interval(value: Mapping[str, Any]) -> str:
    low, high = value["ci95"]
    return f"{plain(low)} to {plain(high)}"
