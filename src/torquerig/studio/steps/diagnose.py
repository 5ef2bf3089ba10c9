"""The step Diagnose: which physics the scenario lacks, by recordings of its rig."""

from __future__ import annotations

import os

from nicegui import ui

from torquerig.errors import InputError
from torquerig.reporting.json_results.document import json_text
from torquerig.studio.diagnosing.diagnosed import diagnosed
from torquerig.studio.diagnosing.question import DiagnosisQuestion, DiagnosisShown
from torquerig.studio.jobs.job import Job, start
from torquerig.studio.server.elements import button, enable, words
from torquerig.studio.server.fields import text_field
from torquerig.studio.server.step import Step
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.chosen_recordings import ChosenRecordings
from torquerig.studio.steps.diagnose_result import show_diagnosis
from torquerig.studio.steps.job_panel import JobPanel

MOST_WORKERS = 4  # each fit takes some 200 MB


class _Diagnose:
    """The step of one tab."""

    def __init__(self, tab: Tab) -> None:
        self.tab = tab
        self._found: DiagnosisShown | None = None
        words("Diagnose", "h2")
        words("All recordings must be runs of one rig, with the conditions that their sidecars state. The other steps "
              "stay usable meanwhile.", kind="note")  # fmt: skip
        self._files = ChosenRecordings(tab, lambda: None)
        self._panel = JobPanel(tab, "diagnosis", "Diagnose", self._begin, self._show)
        self._saves()
        self._result = ui.element("div")
        tab.on_change(self._files.refresh)

    def _saves(self) -> None:
        self._save_row = ui.element("div").classes("hidden")
        with self._save_row:
            with ui.element("div").classes("form"):
                self._name = text_field("name of the completed scenario", "diagnosed.yaml", lambda _: None)
            with ui.element("div").classes("acts"):
                self._save_model = button("Save the completed scenario", self._write_model)
                button("Save the JSON", self._download_json)
                button("Save the page", self._download_page)

    def _begin(self) -> Job | None:
        document = self.tab.document
        self._files.refresh()
        if document is None or not document.is_valid:
            self.tab.say("Open a scenario without problems first.")
            return None
        if not self._files.paths:
            self.tab.say("Choose at least one recording.")
            return None
        if self._files.unsaved():
            self.tab.say(self._files.unsaved())
            return None
        workers = min(os.cpu_count() or 1, MOST_WORKERS)
        return start(diagnosed, DiagnosisQuestion(
            document.path, document.text, self._files.paths, catalogs=tuple(self.tab.session.further),
            workers=workers,
        ))  # fmt: skip

    def _show(self, found: DiagnosisShown) -> None:
        self._found = found
        self._save_row.classes(remove="hidden")
        enable(self._save_model, found.model is not None)
        self._result.clear()
        with self._result:
            show_diagnosis(found)

    def _write_model(self) -> None:
        if self._found is None or self._found.model is None:
            return
        session, name = self.tab.session, self._name.value.strip() or "diagnosed.yaml"
        try:
            session.new(name, self._found.model)
            saved = session.save(name)
        except InputError as error:
            self._name.problem(str(error))
            return
        self._name.problem("")
        self.tab.say(f"{saved.sentence}. Choose it above to go on with it.")
        self.tab.changed()

    def _download_json(self) -> None:
        if self._found is not None:
            ui.download.content(json_text(dict(self._found.data)), "diagnosis.json", "application/json")

    def _download_page(self) -> None:
        if self._found is not None and self._found.page is not None:
            ui.download.content(self._found.page, "diagnosis.html", "text/html")


def build(tab: Tab) -> None:
    """Draw the step of a tab."""
    _Diagnose(tab)


DIAGNOSE = Step(key="diagnose", title="Diagnose", build=build)
