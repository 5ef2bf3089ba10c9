"""The smallest effects that the recordings would show, computed when they are wanted."""

from __future__ import annotations

from nicegui import ui

from torquerig.studio.check.visible import HEAD, Visible, visible
from torquerig.studio.diagnosing.question import DiagnosisQuestion
from torquerig.studio.jobs.job import Job, start
from torquerig.studio.server.elements import table, words
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.chosen_recordings import ChosenRecordings
from torquerig.studio.steps.job_panel import JobPanel


class VisibleSizes:
    """A job that fits the nominal rig and shows what the recordings would show."""

    def __init__(self, tab: Tab, files: ChosenRecordings) -> None:
        self.tab, self._files = tab, files
        words("Smallest visible effects", "h3")
        words("This fits the rig to the recordings, and takes about a minute.", kind="note")
        self._panel = JobPanel(tab, "visible", "Compute the smallest visible effects", self._begin, self._show)
        self._result = ui.element("div")

    def _begin(self) -> Job | None:
        document = self.tab.document
        if document is None or not self._files.paths or not document.is_valid:
            self.tab.say("Open a scenario without problems and choose at least one recording.")
            return None
        if self._files.unsaved():
            self.tab.say(self._files.unsaved())
            return None
        return start(visible, DiagnosisQuestion(
            document.path, document.text, self._files.paths, catalogs=self.tab.session.further,
        ))  # fmt: skip

    def _show(self, found: Visible) -> None:
        self._result.clear()
        with self._result:
            table(HEAD, found.rows, caption="smallest sizes that 95 % of such runs would show")
            if found.pairs:
                words("These runs do not separate", "h3")
                with ui.element("ul"):
                    for one in found.pairs:
                        words(one, "li")
            else:
                words("These runs separate all mechanisms at twice these sizes.")
