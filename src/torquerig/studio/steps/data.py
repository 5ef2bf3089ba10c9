"""The step Data: recordings are dropped, each column says what it is taken for, its sidecar is completed in a form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nicegui import run, ui

from torquerig.recordings.files.sidecar_choice import find_sidecar, sidecar_target
from torquerig.studio.data.received import arrival_sentence
from torquerig.studio.data.shown_file import HEAD, ShownFile, shown_file
from torquerig.studio.server.elements import say_in, table, words
from torquerig.studio.server.fields import choice
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.data_drop import DropPlace
from torquerig.studio.steps.data_sheet import SheetView

NUMBERS = (5, 6, 7, 8)  # columns of the table that are numbers


class _Data:
    """The step of one tab."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._chosen = ""
        words("Data", "h2")
        DropPlace(tab.folder, self._received)
        self._said = ui.element("div").props("role=status")
        self._files = choice("recording", [""], "", self._choose)
        self._line = words("", kind="note").props("role=status")
        self._contents = ui.element("div")
        self._sheet = SheetView(tab, self._read)
        tab.on_change(self._list)
        ui.timer(0.01, self._first, once=True)

    async def _first(self) -> None:
        self._list()
        found = self.tab.session.files().recordings
        if found:
            await self._choose(found[0].name)

    def _list(self) -> None:
        names = [one.name for one in self.tab.session.files().recordings]
        self._files.choose_from(names or [""])
        if not names:
            say_in(self._line, "There is no recording in the folder yet.")

    async def _received(self, files: Sequence[Mapping[str, Any]]) -> None:
        self._said.clear()
        with self._said:
            for one in files:
                words(
                    arrival_sentence(str(one["text"])) if one["ok"] else one["text"],
                    kind="" if one["ok"] else "problem",
                )
        arrived = [str(one["text"]) for one in files if one["ok"]]
        self.tab.changed()
        known = {one.name for one in self.tab.session.files().recordings}
        for name in arrived:
            if name in known:
                await self._choose(name)
                return

    async def _choose(self, name: str) -> None:
        self._chosen = name
        self._files.set(name)
        await self._read()

    async def _read(self) -> None:
        path = self.tab.folder / self._chosen
        say_in(self._line, f"{self._chosen} is read.")
        target = _sheet_of(path)
        found = await run.io_bound(shown_file, path, target)
        if found is None or self._chosen != found.name:
            return  # the studio ends, or another file was chosen meanwhile
        self._show(found)
        self._sheet.open(target, found.draft)

    def _show(self, found: ShownFile) -> None:
        say_in(self._line, f"{found.name} can be used." if not found.problem else "")
        self._contents.clear()
        with self._contents:
            if found.problem:
                words(f"Cannot be used yet: {found.problem}", kind="problem")
            if found.rows:
                table(HEAD, found.rows, caption=f"columns of {found.name}", numbers=NUMBERS)
            with ui.element("ul"):
                for name, missing in found.needed:
                    words(f"{name}: the sidecar must add {missing}", "li")
                for note in found.notes:
                    words(note, "li")


def _sheet_of(path: Path) -> Path:
    return find_sidecar(path) or sidecar_target(path)


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _Data(tab)


DATA = Step(key="data", title="Data", build=build)
