"""The step Compare: the study of the scenario with progress, cancel and resume; the matrices with sliders."""

from __future__ import annotations

from nicegui import ui

from torquerig.studio.comparing.compared import compared
from torquerig.studio.comparing.question import StudyQuestion, StudyShown
from torquerig.studio.jobs.job import Job, start
from torquerig.studio.server.elements import button, folded, say_in, table, words
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.answer_screen import answer_html
from torquerig.studio.steps.compare_numbers import MovedNumbers
from torquerig.studio.steps.job_panel import JobPanel


class _Compare:
    """The step of one tab."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._found: StudyShown | None = None
        words("Compare", "h2")
        words("Every motor, gearbox and filter of the study is simulated. A drive is kept as soon as it is measured: "
              "after a cancel, the next start goes on there.", kind="note")  # fmt: skip
        self._why = words("", kind="note")
        self._panel = JobPanel(tab, "study", "Compare the drives", self._begin, self._show)
        self._result = ui.element("div").classes("hidden")
        with self._result:
            self._answer = ui.html("", sanitize=False)
            self._count = words("", kind="note")
            with ui.element("div").classes("acts"):
                button("Save the report as a page", self._download)
            with folded("Drives that are eliminated or open, and why"):
                self._out = ui.element("div")
        self._numbers = MovedNumbers(tab)
        tab.on_change(self._show_state)
        self._show_state()

    def _show_state(self) -> None:
        document = self.tab.document
        why = ""
        if document is None:
            why = "Open a scenario first."
        elif document.value("study") is None:
            why = "The scenario has no section study:. Add one, as in the shipped wear_rig.yaml, and compare then."
        elif not document.is_valid:
            why = "Correct the problems of the scenario first. The last result stays."
        say_in(self._why, why)
        self._panel.enable_start(not why)

    def _begin(self) -> Job | None:
        document = self.tab.document
        if document is None or not document.is_valid:
            return None
        return start(compared, StudyQuestion(document.path, document.text, tuple(self.tab.session.further)))

    def _show(self, found: StudyShown) -> None:
        self._found = found
        self._result.classes(remove="hidden")
        self._answer.set_content(answer_html(found.answer))
        say_in(self._count, f"{found.drives} drives, {found.from_store} of them kept from an earlier run.")
        self._numbers.show_study(found.model)
        self._out.clear()
        with self._out:
            table(("drive", "decision", "why"), found.not_ranked)

    def _download(self) -> None:
        if self._found is not None and self.tab.path is not None:
            ui.download.content(self._found.page, f"{self.tab.path.stem}-study.html", "text/html")


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _Compare(tab)


COMPARE = Step(key="compare", title="Compare", build=build)
