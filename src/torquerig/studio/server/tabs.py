"""The tabs of a studio: each browser tab has its files and edits, also after the page was loaded again."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from torquerig.errors import TorquerigError
from torquerig.studio.server.compute import Compute
from torquerig.studio.server.tab import Tab
from torquerig.studio.session.tab_session import Session

MOST_KEPT = 50  # tabs whose edits are kept after they were closed, each some 100 kB


@dataclass
class Tabs:
    """All tabs.

    Parameters
    ----------
    folder : Path
    scenario : Path or None
        Opened first in a new tab; else the first one of the folder.
    catalogs : tuple of Path
        Further catalog folders.
    compute : Compute
    """

    folder: Path
    scenario: Path | None
    catalogs: tuple[Path, ...]
    compute: Compute
    _opened: dict[str, Tab] = field(default_factory=dict, repr=False)
    _spare: list[tuple[Session, Path | None]] = field(default_factory=list, repr=False)

    def tab(self, name: str) -> Tab:
        """Return a tab for a page that was loaded: with the files and edits that this browser tab had before."""
        before = self._opened.pop(name, None)
        if before is None:
            session, path = self._spare.pop() if self._spare else self._new()
            tab = Tab(session, self.compute, path=path)
        else:
            tab = Tab(before.session, self.compute, path=before.path)
        self._opened[name] = tab
        for old in list(self._opened)[: max(len(self._opened) - MOST_KEPT, 0)]:
            del self._opened[old]
        return tab

    def prepare(self) -> None:
        """Open the files of the first tab before its page asks for them; to be called in a thread."""
        try:
            self._spare.append(self._new())
        except TorquerigError:
            return  # the page says it

    def _new(self) -> tuple[Session, Path | None]:
        session = Session(self.folder, self.catalogs)
        found = session.files().scenarios
        first = self.scenario.resolve() if self.scenario is not None else next(iter(found), None)
        return session, None if first is None else session.open(first).path
