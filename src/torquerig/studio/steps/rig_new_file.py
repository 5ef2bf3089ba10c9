"""A folder without a scenario: begin with one of the shipped ones."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from nicegui import ui

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.studio.server.elements import button, words
from torquerig.studio.server.fields import choice
from torquerig.studio.server.tab import Tab
from torquerig.studio.session.checked import kind_of

FIRST = "wear_rig.yaml"


class NewFile:
    """Offers a copy of a shipped scenario; it is on the disk after it was saved."""

    def __init__(self, tab: Tab) -> None:
        self.tab, self._source = tab, FIRST
        self._place = ui.element("div")
        with self._place:
            words("This folder has no scenario yet. Begin with a copy of a shipped one.")
            names = [one.name for one in sorted(shipped_scenarios().glob("*.yaml"))
                     if kind_of(one.read_text(encoding="utf-8"), one) == "scenario"]  # fmt: skip
            choice("shipped scenario", names, FIRST, self._take)
            button("Copy it", self._copy)

    def show(self, is_shown: bool) -> None:
        """Show or hide the offer."""
        self._place.classes(remove="hidden") if is_shown else self._place.classes(add="hidden")

    def _take(self, name: str) -> None:
        self._source = name

    def _copy(self) -> None:
        def copied() -> None:
            text = (shipped_scenarios() / self._source).read_text(encoding="utf-8")
            _copy_named_files(text, self.tab.folder)
            self.tab.path = self.tab.session.new(self._source, text).path

        if self.tab.attempt(copied):
            self.tab.say(f"{self._source} is open. Save writes it into this folder.")


def _copy_named_files(text: str, folder: Path) -> None:
    """Copy the shipped files that a scenario names, such as its filter chains; a file that is there stays."""
    named = set(_texts_in(parse_document(text, Path("scenario")).data))
    for source in sorted(shipped_scenarios().glob("*.yaml")):
        written = folder / source.name
        if source.name in named and not written.exists():
            try:
                shutil.copyfile(source, written)
            except OSError as error:
                raise InputError(f"{written}: cannot be written ({error.strerror}); choose another folder") from None


def _texts_in(data: Any) -> Iterator[str]:
    if isinstance(data, str):
        yield data
    elif isinstance(data, Mapping | list):
        for one in data.values() if isinstance(data, Mapping) else data:
            yield from _texts_in(one)
