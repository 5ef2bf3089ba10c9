"""The page of a tab: which scenario is open, undo and save, the steps, and what is wrong."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from nicegui import ui

from torquerig.errors import TorquerigError
from torquerig.studio.server.elements import button, enable, say_in, words
from torquerig.studio.server.fields import Field, choice
from torquerig.studio.server.save_as import SaveAs
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab

WATCH = 2.0  # [s] between two looks at the open file and the catalogs on the disk
DONE = {"undo": "Undone.", "redo": "Done again.", "reload": "{name} was read from the disk again."}
SHOWN = "history.replaceState(null, '', `${location.pathname}?step=%s`)"


class Frame:
    """Draws the page of a tab into the present NiceGUI element."""

    def __init__(self, tab: Tab, steps: Sequence[Step], *, first: str) -> None:
        self.tab, self.steps, self._built = tab, {one.key: one for one in steps}, set[str]()
        self._bar()
        self._sections: dict[str, ui.element] = {}
        self._buttons: dict[str, ui.html] = {}
        with ui.element("nav").classes("steps").props('aria-label="steps"'):
            for one in steps:
                self._buttons[one.key] = button(one.title, partial(self.open, one.key))
        with ui.element("div").classes("steps-shown"):  # NiceGUI's page is the main element
            self._problems = ui.element("div").classes("problems hidden").props("role=alert")
            for one in steps:
                self._sections[one.key] = ui.element("section").classes("hidden")
        tab.said = lambda sentence: say_in(self._status, sentence)
        tab.on_change(self._show)
        ui.timer(WATCH, self._watch)
        self._disk = ""
        self._show()
        self.open(first if first in self.steps else steps[0].key)

    def open(self, key: str) -> None:
        """Show a step; it is drawn when it is opened first."""
        for name, section in self._sections.items():
            section.classes(remove="hidden") if name == key else section.classes(add="hidden")
            if name == key:
                self._buttons[name].props["aria-current"] = "step"
            else:
                self._buttons[name].props.pop("aria-current", None)
            self._buttons[name].update()
        if key not in self._built:
            self._built.add(key)
            with self._sections[key]:
                self.steps[key].build(self.tab)
        ui.run_javascript(SHOWN % key)

    def _bar(self) -> None:
        tab = self.tab
        ui.on("studio_key", lambda event: self._act(str(event.args)))
        with ui.element("header").classes("bar"):
            words("torquerig studio", "h1")
            self._names = tab.session.files().scenarios
            self._file: Field = choice(
                "scenario", [one.name for one in self._names], tab.path.name if tab.path else "", self._open_file
            )
            with ui.element("div").classes("acts"):
                titles = {
                    "undo": "Undo",
                    "redo": "Redo",
                    "save": "Save",
                    "save_as": "Save as",
                    "reload": "Reload from disk",
                }
                self._acts = {what: button(title, partial(self._act, what)) for what, title in titles.items()}
            self._save_as = SaveAs(tab)
        self._status = words("", "div", kind="status").props("role=status")

    def _open_file(self, name: str) -> None:
        def opened() -> None:
            self.tab.session.open(name)
            self.tab.path = self.tab.folder / name

        self.tab.attempt(opened)

    def _act(self, what: str) -> None:
        path, session = self.tab.path, self.tab.session
        if path is None:
            return
        if what == "save":
            self._save(path)
            return
        if what == "save_as":
            self._save_as.toggle()
            return
        acts = {"undo": session.undo, "redo": session.redo, "reload": session.reload}
        if self.tab.attempt(lambda: acts[what](path)):
            self.tab.say(DONE[what].format(name=path.name))

    def _save(self, path: Path) -> None:
        try:
            saved = self.tab.session.save(path)
        except TorquerigError as error:
            self.tab.say(str(error))
            return
        self.tab.say(saved.sentence)
        self.tab.changed()

    def _show(self) -> None:
        document = self.tab.document
        enable(self._acts["undo"], document is not None and bool(document.past))
        enable(self._acts["redo"], document is not None and bool(document.future))
        enable(self._acts["save"], document is not None and not document.is_saved)
        for what in ("reload", "save_as"):
            enable(self._acts[what], document is not None)
        if document is not None:
            self._file.set(document.path.name)
        self._offer_files()
        self._show_problems()

    def _offer_files(self) -> None:
        document = self.tab.document
        opened = [] if document is None else [document.path.name]
        names = dict.fromkeys([*(path.name for path in self._names), *opened])
        if tuple(names) != tuple(self._file.props["options"]):
            self._file.choose_from(list(names))

    def _show_problems(self) -> None:
        document = self.tab.document
        found = [one.text() for one in (document.problems if document else ())]
        found += [one.text() for one in self.tab.session.catalog_problems()]
        self._problems.clear()
        self._problems.classes(remove="hidden") if found else self._problems.classes(add="hidden")
        with self._problems:
            for text in found:
                words(text, kind="problem")

    def _watch(self) -> None:
        """Say where the open file or a catalog changed on the disk; offer files that came meanwhile."""
        self._names = self.tab.session.files().scenarios
        self._offer_files()
        if self.tab.path is None:
            return
        catalog = self.tab.session.catalog_problems()
        now = f"{self.tab.session.disk_state(self.tab.path)} {[one.text() for one in catalog]}"
        if now == self._disk:
            return
        first, self._disk = not self._disk, now
        name = self.tab.path.name
        if now.startswith("changed"):
            self.tab.say(f"{name} has changed on the disk. Reload it, or go on here; Save will not overwrite it.")
        elif now.startswith("gone"):
            self.tab.say(f"{name} is no longer on the disk. Save writes it again.")
        if not first:
            self._show_problems()
