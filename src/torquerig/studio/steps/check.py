"""The step Check: what a diagnosis of these recordings would compare, tell apart, and find odd."""

from __future__ import annotations

from collections.abc import Sequence

from nicegui import ui

from torquerig.errors import TorquerigError
from torquerig.studio.check.runs_checked import RunsChecked, runs_checked
from torquerig.studio.server.elements import button, say_in, table, words
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.chosen_recordings import ChosenRecordings
from torquerig.studio.steps.visible_sizes import VisibleSizes


class _Check:
    """The step of one tab."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        words("Check", "h2")
        words("Nothing is diagnosed here. The check says what these recordings can tell apart, and what looks wrong.",
              kind="note")  # fmt: skip
        self._files = ChosenRecordings(tab, self._outdated)
        with ui.element("div").classes("acts"):
            button("Check the recordings", self._check)
        self._line = words("", kind="note").props("role=status")
        self._result = ui.element("div")
        self._sizes = VisibleSizes(tab, self._files)
        tab.on_change(self._files.refresh)

    def _outdated(self) -> None:
        say_in(self._line, "The choice has changed. Check again.")

    async def _check(self) -> None:
        document, tab = self.tab.document, self.tab
        self._files.refresh()
        if document is None or not self._files.paths:
            say_in(self._line, "Open a scenario and choose at least one recording.")
            return
        if self._files.unsaved():
            say_in(self._line, self._files.unsaved())
            return
        say_in(self._line, "Checking.")
        try:
            found = await tab.compute.run(
                runs_checked, document.text, document.path, self._files.paths, catalogs=tab.session.further
            )
        except TorquerigError as error:
            say_in(self._line, error)
            return
        say_in(self._line, found.problem or "Scenario and recordings match.")
        if not found.problem:  # the last good result stays
            self._show(found)

    def _show(self, found: RunsChecked) -> None:
        self._result.clear()
        with self._result:
            table(found.head, found.rows, caption="what a diagnosis compares")
            _listed("These runs can tell apart", found.can)
            _listed("They cannot tell apart", found.cannot)
            _listed("This looks wrong", found.suspicious, empty="No channel or sample looks wrong.")
            _listed("How it is compared", found.compared)
            fitted = ", ".join(found.fitted) or "nothing, because no parameter has a rel_sd"
            words(f"Fitted before mechanisms are tested: {fitted}.")


def _listed(title: str, sentences: Sequence[str], *, empty: str = "") -> None:
    if not sentences and not empty:
        return
    words(title, "h3")
    if not sentences:
        words(empty)
        return
    with ui.element("ul"):
        for one in sentences:
            words(one, "li")


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _Check(tab)


CHECK = Step(key="check", title="Check", build=build)
