"""The matrices of the study or of a matrix file with sliders, and how their numbers come into the file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nicegui import ui

from torquerig.decide.case import MatrixCase
from torquerig.errors import InputError
from torquerig.reporting.moving.matrix_model import case_model
from torquerig.studio.comparing.taken_weights import moved_values
from torquerig.studio.server.elements import button, say_in, words
from torquerig.studio.server.fields import choice
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.compare_matrices import Matrices

STUDY = "the study"


class MovedNumbers:
    """Sliders for weights, limits and points of the study, or of a matrix file of the folder."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._of, self._study = STUDY, dict[str, Any]()
        words("Other weights, limits and points", "h3")
        with ui.element("div").classes("form"):
            self._choice = choice("matrices of", self._names(), STUDY, self._choose)
        self._line = words("", kind="note").props("role=status")
        self._whole = ui.element("div").classes("hidden")
        with self._whole:
            self._matrices = Matrices()
            with ui.element("div").classes("acts"):
                button("Take these numbers into the file", self._take)
                button("Save the file", self._save, name="Save the file of the matrices")
        tab.on_change(lambda: self._choice.choose_from(self._names()))
        self._show()

    def show_study(self, model: Mapping[str, Any]) -> None:
        """Show the matrices of a study that was computed."""
        self._study, self._of = dict(model), STUDY
        self._choice.set(STUDY)
        self._show()

    @property
    def _path(self) -> Path | None:
        return self.tab.path if self._of == STUDY else self.tab.folder / self._of

    def _names(self) -> list[str]:
        return [STUDY, *(one.name for one in self.tab.session.files().matrices)]

    def _choose(self, name: str) -> None:
        self._of = name
        self._show()

    def _show(self) -> None:
        model, why = self._model()
        say_in(self._line, why)
        if not model:
            self._whole.classes(add="hidden")
            return
        self._whole.classes(remove="hidden")
        self._matrices.show(model)

    def _model(self) -> tuple[Mapping[str, Any], str]:
        if self._of == STUDY:
            return (
                self._study,
                "" if self._study else "Compare the drives first, or choose a matrix file of the folder.",
            )
        try:
            document = self.tab.session.open(self._of)
        except InputError as error:
            return {}, str(error)
        problems = " ".join(one.text() for one in document.problems)
        if not isinstance(document.good, MatrixCase):
            return {}, problems or f"{self._of} holds tables of marks or points, which have no weights to move."
        return case_model(document.good), problems

    async def _take(self) -> None:
        path, session = self._path, self.tab.session
        if path is None:
            return
        moved = moved_values(session.open(path), await self._matrices.moved())

        def take() -> None:
            for keys, number in moved:
                session.edit(path, keys, number)

        if not moved:
            self.tab.say(f"Nothing differs from {path.name}.")
        elif self.tab.attempt(take):
            count = "1 number" if len(moved) == 1 else f"{len(moved)} numbers"
            self.tab.say(f"{count} taken into {path.name}. The file is written when it is saved.")

    def _save(self) -> None:
        if self._path is None:
            return
        try:
            saved = self.tab.session.save(self._path)
        except InputError as error:
            self.tab.say(str(error))
            return
        self.tab.say(saved.sentence)
        self.tab.changed()
