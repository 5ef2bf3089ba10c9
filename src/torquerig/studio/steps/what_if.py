"""The step What-if: another motor, ratio, speed, load or filter, and what the sensor would record."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import background_tasks, ui

from torquerig.errors import TorquerigError
from torquerig.studio.server.elements import button, enable, words
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.what_if_answer import NOTHING_YET, AnswerView
from torquerig.studio.steps.what_if_form import WhatIfForm
from torquerig.studio.what_if.asked import edits_of, simulated, sized
from torquerig.studio.what_if.question import LENGTH, Question

if TYPE_CHECKING:
    from torquerig.studio.what_if.taken_over import Edit

NO_SCENARIO = "Open a scenario first; without one in the folder, copy a shipped one in the step Rig."


class _WhatIf:
    """The step of one tab. While one question is computed, the last one that came meanwhile waits."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._waiting: Question | None = None
        self._is_busy = False
        words("What-if", "h2")
        words(f"Change a value: {LENGTH:g} s of the rig are simulated with the filter. The file changes only when you "
              "take the values over.", kind="note")  # fmt: skip
        self._form = WhatIfForm(tab, self._ask)
        with ui.element("div").classes("saves"):
            self._back = button("Undo last value", self._form.undo)
            self._clear = button("Back to the scenario", self._form.clear)
            self._take = button("Take over into the scenario", self._take_over)
        self._view = AnswerView()
        tab.on_change(self._show_document)
        background_tasks.create(self._show_document())

    async def _show_document(self) -> None:
        document = self.tab.document
        if document is None:
            self._view.show_missing(NO_SCENARIO)
        elif document.good_text is None:
            self._view.show_missing(NOTHING_YET)
        else:
            self._view.show_missing("Computing.")
            await self._form.show_document()
            if self._form.question() is None:
                self._view.show_missing(NOTHING_YET)

    def _ask(self) -> None:
        self._buttons()
        self._waiting = self._form.question()
        if self._waiting is not None and not self._is_busy:
            self._is_busy = True
            background_tasks.create(self._answer())

    async def _answer(self) -> None:
        try:
            while (question := self._waiting) is not None:
                self._waiting = None
                await self._answer_one(question)
        finally:
            self._is_busy = False

    async def _answer_one(self, question: Question) -> None:
        try:
            found = await self.tab.compute.run(simulated, question)
        except TorquerigError as error:
            self._form.blame(question, error)
            self._view.keep_last()
            return
        self._form.blame(question, None)
        self._view.show(found, question)
        try:
            self._view.show_sizing(await self.tab.compute.run(sized, question))
        except TorquerigError as error:
            self._view.show_no_sizing(str(error))

    def _buttons(self) -> None:
        enable(self._back, self._form.can_undo)
        enable(self._clear, self._form.is_changed)
        enable(self._take, self._form.is_changed)

    async def _take_over(self) -> None:
        question, tab = self._form.question(), self.tab
        if question is None:
            return
        try:
            edits = await tab.compute.run(edits_of, question)
        except TorquerigError as error:
            tab.say(str(error))
            return

        def take() -> None:
            for edit in edits:
                _apply(tab, edit)
            self._form.forget()

        if tab.attempt(take):
            tab.say("Taken over. Undo takes it back; Save writes the file.")


def _apply(tab: Tab, edit: Edit) -> None:
    assert tab.path is not None
    if edit.value is None:
        tab.session.remove(tab.path, edit.keys)
    else:
        tab.session.edit(tab.path, edit.keys, edit.value)


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _WhatIf(tab)


WHAT_IF = Step(key="what_if", title="What-if", build=build)
