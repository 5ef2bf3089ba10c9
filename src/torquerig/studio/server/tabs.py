"""The tabs of a studio: each browser tab has its files and edits, also after the page was loaded again."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

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

    def tab(self, name: str) -> Tab:
        """Return a tab for a page that was loaded: with the files and edits that this browser tab had before."""
        before = self._opened.pop(name, None)
        if before is None:
            session = Session(self.folder, self.catalogs)
            tab = Tab(session, self.compute, path=self._first(session))
        else:
            tab = Tab(before.session, self.compute, path=before.path)
        self._opened[name] = tab
        for old in list(self._opened)[: max(len(self._opened) - MOST_KEPT, 0)]:
            del self._opened[old]
        return tab

    def _first(self, session: Session) -> Path | None:
        found = session.files().scenarios
        first = self.scenario.resolve() if self.scenario is not None else next(iter(found), None)
        return None if first is None else session.open(first).path
