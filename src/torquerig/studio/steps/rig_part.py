"""The form of one part: its catalog entry, its values, its place; what is wrong with it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from nicegui import ui

from torquerig.scenario.model import Scenario
from torquerig.studio.rig_view.part_values import SHELVES, PartValue, part_values
from torquerig.studio.server.elements import button, enable, folded, words
from torquerig.studio.server.fields import Field, picker, text_field
from torquerig.studio.server.tab import Tab
from torquerig.studio.session.working_document import WorkingDocument
from torquerig.studio.steps.value_form import problem_at, write, written_at


class PartForm:
    """The values of the chosen part; ``choose`` is called with the name of another part to show."""

    def __init__(self, tab: Tab, choose: Callable[[str], None]) -> None:
        self.tab, self._choose = tab, choose
        self._drawn: tuple[Any, ...] = ()
        self._fields: dict[str, Field] = {}
        self._name, self._names = "", tuple[str, ...]()
        with ui.element("div"):
            self._title = ui.element("div")
            self._problems = ui.element("div")
            self._place = ui.element("div")
            with ui.element("div").classes("saves"):
                self._earlier = button("Move towards the motor", partial(self._move, -1))
                self._later = button("Move towards the load", partial(self._move, 1))
                self._gone = button("Remove this part", self._remove)

    def show(self, name: str, names: Sequence[str]) -> None:
        """Show a part; the fields stay where they are the same, and so does what is being written."""
        document = self.tab.document
        if document is None:
            return
        self._name, self._names = name, tuple(names)
        data = document.data
        found = data.get("rig", {}).get(name) if isinstance(data, Mapping) and name else None
        written = found if isinstance(found, Mapping) else {}
        good = document.good if isinstance(document.good, Scenario) else None
        values = part_values(name, written, good)
        kind = str(written.get("kind", ""))
        drawn = (name, kind, values, self._names)
        if drawn != self._drawn:
            self._drawn = drawn
            self._draw(name, kind, values)
        self._show_values(document, data, name)
        at = self._names.index(name) if name in self._names else -1
        enable(self._earlier, at > 0)
        enable(self._later, 0 <= at < len(self._names) - 1)
        enable(self._gone, at >= 0)

    def _draw(self, name: str, kind: str, values: Sequence[PartValue]) -> None:
        self._fields = {}
        for place in (self._title, self._place):
            place.clear()
        with self._title:
            words(f"{name}: {kind.replace('_', ' ')}" if name else "No part", "h3")
        shelf = SHELVES.get(kind)
        first = [one for one in values if one.is_stated or one.is_required]
        others = [one for one in values if one not in first]
        with self._place:
            with ui.element("div").classes("form"):
                if shelf is not None:
                    entries = tuple(getattr(self.tab.session.catalog, shelf))
                    self._fields["catalog"] = picker(
                        "catalog entry", entries, "", partial(write, self.tab, ("rig", name, "catalog"))
                    )
                for one in first:
                    self._add_field(name, one)
            if others:
                with folded("Values that the file does not state"), ui.element("div").classes("form"):
                    for one in others:
                        self._add_field(name, one)

    def _add_field(self, name: str, one: PartValue) -> None:
        written = partial(write, self.tab, ("rig", name, one.key))
        options = one.choices or (tuple(other for other in self._names if other != name) if one.names_part else ())
        if options:
            self._fields[one.key] = picker(one.label, options, "", written, hint=one.hint)
        else:
            self._fields[one.key] = text_field(one.label, "", written, hint=one.hint)
        if one.meaning:
            self._fields[one.key].props["title"] = one.meaning

    def _show_values(self, document: WorkingDocument, data: Any, name: str) -> None:
        shown: set[str] = set()
        for key, field in self._fields.items():
            field.set(written_at(data, ("rig", name, key)))
            problem = problem_at(document, ("rig", name, key))
            field.problem(problem)
            shown |= {key} if problem else set()
        self._problems.clear()
        with self._problems:
            for one in document.problems:
                if one.keys[:2] == ("rig", name) and (len(one.keys) == 2 or str(one.keys[2]) not in shown):
                    words(one.sentence, kind="problem")

    def _move(self, by: int) -> None:
        path, name, others = self.tab.path, self._name, [one for one in self._names if one != self._name]
        at = self._names.index(name) + by
        if path is not None and 0 <= at <= len(others):
            after = others[at - 1] if at else None
            self.tab.attempt(lambda: self.tab.session.move(path, ("rig", name), after=after))

    def _remove(self) -> None:
        path, name = self.tab.path, self._name
        if path is not None and self.tab.attempt(lambda: self.tab.session.remove(path, ("rig", name))):
            self.tab.say(f"{name} is removed. Undo brings it back.")
