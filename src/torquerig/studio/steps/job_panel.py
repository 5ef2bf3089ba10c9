"""Start, progress, cancel and result of a piece of long work."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from torquerig.studio.jobs.job import Job
from torquerig.studio.server.elements import button, enable, say_in, words
from torquerig.studio.server.tab import Tab
from torquerig.studio.steps.running_jobs import job_of, keep_job

LOOK = 0.4  # [s] between two looks at a running job

ENDS = {"done": "Done.", "cancelled": "Cancelled. What was done is kept."}


class JobPanel:
    """Two buttons, a bar and a line of text.

    Parameters
    ----------
    tab : Tab
    kind : str
        Names the job in the tab, such as ``study``.
    title : str
        Text of the button that starts it.
    begin : callable
        Returns the started job, or None where it cannot be started; it says why.
    show : callable
        Called with the result of the job.
    """

    def __init__(
        self, tab: Tab, kind: str, title: str, begin: Callable[[], Job | None], show: Callable[[Any], None]
    ) -> None:
        self.tab, self.kind, self._begin, self._show = tab, kind, begin, show
        self._shown: Job | None = None
        with ui.element("div").classes("acts"):
            self._start = button(title, self._started)
            self._cancel = button("Cancel", self._cancelled, name=f"Cancel: {title}")
        self._bar = ui.element("progress").props(f'aria-label="{title}: progress"').classes("hidden")
        self._line = words("", kind="note").props("role=status")
        ui.timer(LOOK, self._look)  # the first time after the step is drawn

    @property
    def job(self) -> Job | None:
        """The last job of this tab."""
        return job_of(self.tab.session, self.kind)

    def enable_start(self, is_enabled: bool) -> None:
        """Switch the start on or off while nothing runs."""
        self._may_start = is_enabled
        enable(self._start, is_enabled and not (self.job is not None and self.job.is_running))

    _may_start = True

    def _started(self) -> None:
        if self.job is not None and self.job.is_running:
            return
        job = self._begin()
        if job is not None:
            keep_job(self.tab.session, self.kind, job)
            self._shown = None
            self._look()

    def _cancelled(self) -> None:
        if self.job is not None:
            self.job.cancel()
            self._look()

    def _look(self) -> None:
        job = self.job
        is_running = job is not None and job.is_running
        enable(self._cancel, is_running)
        enable(self._start, self._may_start and not is_running)
        self._bar.classes(remove="hidden") if is_running else self._bar.classes(add="hidden")
        if job is None or job is self._shown:
            return
        if is_running:
            self._show_progress(job)
            return
        self._shown = job
        say_in(
            self._line, {"done": "Done.", "cancelled": "Cancelled. What is done is kept."}.get(job.state, job.sentence)
        )
        if job.state == "done":
            self._show(job.result)

    def _show_progress(self, job: Job) -> None:
        now = job.progress
        if now.total:
            self._bar.props(f"max={now.total} value={now.done}")
        else:
            self._bar.props(remove="max value")
        self._bar.update()
        say_in(self._line, now.text() or "The process starts.")
