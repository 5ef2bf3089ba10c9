"""The step Rig: the parts along the shaft, the values of the chosen part, the operating point."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nicegui import ui

from torquerig.scenario.kinds import KINDS
from torquerig.studio.rig_view.drawing import drawing
from torquerig.studio.rig_view.placed_parts import placed_parts
from torquerig.studio.server.elements import button, words
from torquerig.studio.server.fields import picker, text_field
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.rig_new_file import NewFile
from torquerig.studio.steps.rig_part import PartForm
from torquerig.studio.steps.value_form import ValueForm

CHOSEN = """(event) => {
  const part = event.target.closest('[data-part]');
  if (!part || (event.type === 'keydown' && !['Enter', ' '].includes(event.key))) return;
  event.preventDefault();
  emit(part.dataset.part);
}"""
FOCUS = "document.querySelector('.drawing [aria-pressed=true]')?.focus()"


class _RigStep:
    """The step of one tab."""

    def __init__(self, tab: Tab) -> None:
        self.tab, self._chosen = tab, ""
        words("Rig", "h2")
        self._new_file = NewFile(tab)
        self._whole = ui.element("div")
        with self._whole:
            words("Choose a part to see its values. White boxes have a spring inside; the part with the strong frame "
                  "is measured; effects are below the part they act on.", kind="note")  # fmt: skip
            self._drawing = ui.html("", sanitize=False).classes("drawing")
            for event in ("click", "keydown"):
                self._drawing.on(event, lambda found: self._choose(str(found.args)), js_handler=CHOSEN)
            with ui.element("div").classes("two"):
                self._part = PartForm(tab, self._choose)
                with ui.element("div"):
                    words("Operating point", "h3")
                    self._point = ValueForm(tab)
                    words("Add a part or an effect", "h3")
                    self._add_form()
        tab.on_change(self._show)
        self._show()

    def _add_form(self) -> None:
        self._new = {"name": "", "kind": ""}
        with ui.element("div").classes("form"):
            self._name = text_field("name of the new part", "", lambda text: self._new.update(name=text.strip()))
            self._kind = picker("kind of the new part", sorted(KINDS), "", lambda text: self._new.update(kind=text))
        button("Add behind the chosen part", self._add)

    def _add(self) -> None:
        path, name, kind = self.tab.path, self._new["name"], self._new["kind"]
        self._name.problem("" if name else "write a name, such as gap")
        self._kind.problem("" if kind in KINDS else "choose a kind of the list")
        if path is None or not name or kind not in KINDS:
            return
        after = self._chosen or None
        added = self.tab.attempt(lambda: self.tab.session.insert(path, ("rig", name), {"kind": kind}, after=after))
        if added:
            self._name.set("")
            self._new["name"] = ""
            self._choose(name)

    def _choose(self, name: str) -> None:
        self._chosen = name
        self._show()
        ui.run_javascript(FOCUS)

    def _show(self) -> None:
        document = self.tab.document
        self._new_file.show(document is None)
        if document is None:
            self._whole.classes(add="hidden")
            return
        self._whole.classes(remove="hidden")
        found = document.data
        data = found if isinstance(found, Mapping) else {}
        rig = data.get("rig")
        parts = placed_parts(rig)
        names = [one.name for one in parts]
        if self._chosen not in names:
            self._chosen = names[0] if names else ""
        problems: dict[str, int] = {}
        for one in document.problems:
            if one.part and one.keys[0] == "rig":
                problems[one.part] = problems.get(one.part, 0) + 1
        shown = drawing(parts, chosen=self._chosen, problems=problems, read=_measured(data))
        if shown != self._drawing.content:
            self._drawing.set_content(shown)
        self._part.show(self._chosen, names)
        self._point.show(_point_keys(data), document)


def _measured(data: Mapping[str, Any]) -> tuple[str, ...]:
    stated = data.get("measured", "torque_sensor")
    return tuple(str(one) for one in (stated if isinstance(stated, list) else [stated]))


def _point_keys(data: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """Return the keys of the operating point and the recording whose values are one number or word."""
    found: list[tuple[str, ...]] = []
    for section in ("operating_point", "recording"):
        inside = data.get(section)
        for key, value in inside.items() if isinstance(inside, Mapping) else ():
            if key == "load" and isinstance(value, Mapping):
                found += [(section, "load", str(name)) for name in value]
            elif not isinstance(value, Mapping | list):
                found.append((section, str(key)))
    return found


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _RigStep(tab)


RIG = Step(key="rig", title="Rig", build=build)
