"""A form of values of the open file by their keys: each is written when its field is left."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from nicegui import ui

from torquerig.errors import TorquerigError
from torquerig.studio.server.fields import Field, text_field
from torquerig.studio.server.tab import Tab
from torquerig.studio.session.working_document import WorkingDocument
from torquerig.studio.session.yaml_values import flow_text

Keys = tuple[str, ...]


class ValueForm:
    """Fields for some keys of the file that is open."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._fields: dict[Keys, Field] = {}
        self._place = ui.element("div").classes("form")

    def show(self, keys: Sequence[Keys], document: WorkingDocument) -> None:
        """Show these values; fields that are there already stay, and so does what is being written."""
        if tuple(self._fields) != tuple(keys):
            self._place.clear()
            with self._place:
                self._fields = {one: text_field(label_of(one), "", partial(write, self.tab, one)) for one in keys}
        data = document.data
        for one, field in self._fields.items():
            field.set(written_at(data, one))
            field.problem(problem_at(document, one))


def label_of(keys: Keys) -> str:
    """Return the last key in words."""
    return keys[-1].replace("_", " ")


def written_at(data: Any, keys: Keys) -> str:
    """Return a value of a file's data as a field shows it: a text as it is, others in the flow form of YAML."""
    found = data
    for key in keys:
        if not isinstance(found, dict) or key not in found:
            return ""
        found = found[key]
    return found if isinstance(found, str) else "" if found is None else flow_text(found)


def problem_at(document: WorkingDocument, keys: Keys) -> str:
    """Return what is wrong with a value, or with something inside it; empty where nothing is."""
    return " ".join(one.sentence for one in document.problems if one.keys[: len(keys)] == keys)


def write(tab: Tab, keys: Keys, text: str) -> None:
    """Write a value into the open file; an empty text removes its key."""
    document = tab.document
    if document is None or text.strip() == written_at(document.data, keys):
        return
    path = document.path

    def edit() -> None:
        if text.strip():
            tab.session.edit_text(path, keys, text)
        else:
            tab.session.remove(path, keys)

    try:
        edit()
    except TorquerigError as error:
        tab.say(str(error))
    tab.changed()
