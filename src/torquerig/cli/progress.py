"""A progress bar on standard error, or plain lines if standard error is no terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from torquerig.cli.console import terminal
from torquerig.harmless import harmless

if TYPE_CHECKING:
    from torquerig.cases import Progress as CaseProgress


@contextmanager
def drive_progress(title: str) -> Iterator[Callable[[int, int, str], None]]:
    """Yield a function ``progress(done, total, name)`` that shows the progress of a study."""
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
        yield (
            lambda done, total, name: (
                console.print(f"{title}: {done}/{total} {harmless(name)}", markup=False)
                if _is_shown(done, total)
                else None
            )
        )
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
            left = "" if now.remaining is None else f"some {now.remaining:.0f} s remain"
            failed = f"{now.failed} failed" if now.failed else ""
            shown(now.done, now.total, ", ".join(word for word in (left, failed) if word))

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


def _is_shown(done: int, total: int) -> bool:
    return done == total or done % 10 == 0
