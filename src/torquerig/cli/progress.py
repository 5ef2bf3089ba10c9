"""A progress bar on standard error, or plain lines if standard error is no terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.cli.console import terminal
from torquerig.harmless import harmless

if TYPE_CHECKING:
    from torquerig.cases import Progress as CaseProgress


EVERY = 10.0  # [s] between plain lines, at most: a reader of a log sees that the work goes on
MINUTES = 120.0  # [s] from here on the remaining time is in minutes


@contextmanager
def drive_progress(title: str) -> Iterator[Callable[[int, int, str], None]]:
    """Yield a function ``progress(done, total, name)`` that shows the progress of a study.

    Nothing is shown, and what draws the bar is not imported, where all was done before the first call.
    """
    with ExitStack() as opened:
        shown: list[Callable[[int, int, str], None]] = []

        def progress(done: int, total: int, name: str) -> None:
            if not shown and done == total:
                return
            if not shown:
                shown.append(opened.enter_context(_shown_progress(title)))
            shown[0](done, total, name)

        yield progress


@contextmanager
def _shown_progress(title: str) -> Iterator[Callable[[int, int, str], None]]:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    console = Console(file=terminal(sys.stderr))
    if not console.is_terminal:
        lines = PlainLines(title)

        def shown(done: int, total: int, name: str) -> None:
            if line := lines.line(done, total, name, now=time.monotonic()):
                console.print(line, markup=False, soft_wrap=True)

        yield shown
        return
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(),
               TimeRemainingColumn(), TextColumn("{task.fields[name]}", markup=False))  # fmt: skip
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(title, total=None, name="")
        yield lambda done, total, name: bar.update(task, completed=done, total=total, name=harmless(name))


@contextmanager
def case_progress(title: str) -> Iterator[Callable[[CaseProgress], None]]:
    """Yield a function that shows how many cases of a stored study are done, from the first one that is computed."""
    with drive_progress(title) as shown:

        def progress(now: CaseProgress) -> None:
            shown(now.done, now.total, f"{now.failed} failed" if now.failed else "")

        yield progress


@contextmanager
def stages(title: str) -> Iterator[Callable[[str], None]]:
    """Yield a function that shows the present stage of a command on a terminal; elsewhere it prints nothing."""
    from rich.console import Console
    from rich.markup import escape

    console = Console(file=terminal(sys.stderr))
    if not console.is_terminal:
        yield lambda stage: None
        return
    with console.status(title) as status:
        yield lambda stage: status.update(f"{title}: {escape(harmless(stage))}")


@dataclass
class PlainLines:
    """Progress in plain lines: the tenth of each ten, the last one, and one where the last line is older than 10 s.

    Parameters
    ----------
    title : str
    start : float
        Time of the first call [s].
    last : float
        Time of the last line [s].
    before : int
        What was done at the first call: it took no time of this run.
    """

    title: str
    start: float | None = None
    last: float = 0.0
    before: int = 0

    def line(self, done: int, total: int, name: str, *, now: float) -> str:
        """Return the line for this state, with the remaining time; empty where none is due. ``now`` in [s]."""
        if self.start is None:
            self.start, self.last, self.before = now, now, done
        if not (done == total or (done and done % 10 == 0) or now - self.last >= EVERY):
            return ""
        self.last = now
        return f"{self.title}: {done}/{total}{self._remaining(done, total, now)} {harmless(name)}".rstrip()

    def _remaining(self, done: int, total: int, now: float) -> str:
        """Return the remaining time at the mean rate since the first call."""
        made = done - self.before
        if self.start is None or made <= 0 or done >= total:
            return ""
        seconds = (now - self.start) / made * (total - done)
        return f", some {seconds:.0f} s remain," if seconds < MINUTES else f", some {seconds / 60:.0f} min remain,"
