"""Saving the open file under another name: a field that opens by its button."""

from __future__ import annotations

from nicegui import ui

from torquerig.errors import TorquerigError
from torquerig.studio.server.elements import button
from torquerig.studio.server.fields import text_field
from torquerig.studio.server.tab import Tab

ENDINGS = (".yaml", ".yml")


class SaveAs:
    """The field and its button, hidden until :meth:`toggle`."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._place = ui.element("div").classes("acts hidden")
        with self._place:
            self._name = text_field("new file name", "", self._take, hint="my_rig.yaml")
            button("Write the new file", self._save)
        self._given = ""

    def toggle(self) -> None:
        """Show or hide it."""
        self._place.classes(toggle="hidden")

    def _take(self, text: str) -> None:
        self._given = text.strip()

    def _save(self) -> None:
        path, name = self.tab.path, self._given
        if path is None:
            return
        if not name.endswith(ENDINGS):
            self._name.problem("write a name that ends in .yaml, such as my_rig.yaml")
            return
        try:
            saved = self.tab.session.save_as(path, name)
        except TorquerigError as error:
            self._name.problem(str(error))
            return
        self._name.problem("" if saved.written else saved.sentence)
        if saved.written:
            self.tab.path = self.tab.folder / name
            self.tab.say(saved.sentence)
            self._place.classes(add="hidden")
            self.tab.changed()
