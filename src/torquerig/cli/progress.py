"""A progress bar on standard error, or a plain line now and then where that is no terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def drive_progress(title: str) -> Iterator[Callable[[int, int, str], None]]:
    """Give a function ``progress(done, total, name)`` that shows how far a study is."""
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    console = Console(file=sys.stderr)
    if not console.is_terminal:
        yield (
            lambda done, total, name: console.print(f"{title}: {done}/{total} {name}") if _worth(done, total) else None
        )
        return
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(),
               TimeRemainingColumn(), TextColumn("{task.fields[name]}"))  # fmt: skip
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(title, total=None, name="")
        yield lambda done, total, name: bar.update(task, completed=done, total=total, name=name)


@contextmanager
def stages(title: str) -> Iterator[Callable[[str], None]]:
    """Give a function that names the stage a command is at, on a terminal only; elsewhere nothing is printed."""
    from rich.console import Console

    console = Console(file=sys.stderr)
    if not console.is_terminal:
        yield lambda stage: None
        return
    with console.status(title) as status:
        yield lambda stage: status.update(f"{title}: {stage}")


def _worth(done: int, total: int) -> bool:
    return done == total or done % 10 == 0
