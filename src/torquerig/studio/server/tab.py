"""What one browser tab works on. Two tabs share the files on the disk and the computing process, nothing else."""

from __future__ import annotations

import inspect
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nicegui import background_tasks

from torquerig.errors import TorquerigError

if TYPE_CHECKING:
    from torquerig.studio.server.compute import Compute
    from torquerig.studio.session.tab_session import Session
    from torquerig.studio.session.working_document import WorkingDocument

Listener = Callable[[], Awaitable[None] | None]


@dataclass
class Tab:
    """A tab.

    Parameters
    ----------
    session : Session
        Its open files, each with its edits.
    compute : Compute
        The process that computes.
    path : Path or None
        The scenario that is open.
    """

    session: Session
    compute: Compute
    path: Path | None = None
    said: Callable[[str], None] = field(default=print, repr=False)
    _listeners: list[Listener] = field(default_factory=list, repr=False)

    @property
    def folder(self) -> Path:
        """The folder of the studio."""
        return self.session.folder

    @property
    def document(self) -> WorkingDocument | None:
        """The open scenario with its edits and problems; None where none is open."""
        return None if self.path is None else self.session.open(self.path)

    def say(self, sentence: str) -> None:
        """Show a sentence in the status line, which a screen reader reads."""
        self.said(sentence)

    def on_change(self, listener: Listener) -> None:
        """Have a function called after each change of this tab's files, by whichever step."""
        self._listeners.append(listener)

    def changed(self) -> None:
        """Call what depends on this tab's files; to be called after every edit, undo and opening."""
        for listener in tuple(self._listeners):
            found = listener()
            if inspect.isawaitable(found):
                background_tasks.create(_finished(found))

    def attempt(self, action: Callable[[], Any]) -> bool:
        """Do something to the files and tell the steps; where it is refused, say why. Return whether it was done."""
        try:
            action()
        except TorquerigError as error:
            self.say(str(error))
            return False
        self.changed()
        return True


async def _finished(found: Awaitable[None]) -> None:
    await found
