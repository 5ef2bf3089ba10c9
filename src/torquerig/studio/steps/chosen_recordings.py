"""The recordings of the folder as check boxes: those that belong to one rig."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path

from nicegui import ui

from torquerig.recordings.files.sidecar_choice import find_sidecar, sidecar_target
from torquerig.studio.server.elements import words
from torquerig.studio.server.tab import Tab

CHECKED = "(event) => emit(event.target.checked)"


class ChosenRecordings:
    """Check boxes for the recordings of the folder; those with a sidecar are chosen first, or all where none has one.

    Parameters
    ----------
    tab : Tab
    on_change : callable
        Called after a box was clicked, and where the files of the folder have changed.
    """

    def __init__(self, tab: Tab, on_change: Callable[[], Awaitable[None] | None]) -> None:
        self.tab, self._on_change = tab, on_change
        self._left_out: set[Path] = set()
        self._listed: tuple[Path, ...] | None = None
        self._holder = ui.element("fieldset").classes("files")
        self.refresh()

    @property
    def paths(self) -> tuple[Path, ...]:
        """The chosen recordings."""
        return tuple(one for one in self._listed or () if one not in self._left_out)

    def unsaved(self) -> str:
        """Return why the chosen recordings cannot be read yet: a sidecar with edits that are not saved; else empty."""
        edited = {one.path for one in self.tab.session.opened() if one.kind == "sheet" and not one.is_saved}
        sheets = {find_sidecar(path) or sidecar_target(path) for path in self.paths} & edited
        names = " and ".join(sorted(one.name for one in sheets))
        return f"{names}: has edits that are not saved; save it in the step Data first" if names else ""

    def refresh(self) -> None:
        """List the recordings that are in the folder now."""
        found = self.tab.session.files().recordings
        if found == self._listed:
            return
        known = {one for one in found if find_sidecar(one) is not None}
        arrived = set(found) - set(self._listed or ())
        self._left_out |= (arrived - known) if known else set()
        self._listed = found
        self._holder.clear()
        with self._holder:
            words("recordings of this rig", "legend")
            if not found:
                words("There is no recording in the folder. Drop some in the step Data.", kind="note")
            for path in found:
                self._box(path)

    def _box(self, path: Path) -> None:
        with ui.element("label").classes("box"):
            made = ui.element("input").props("type=checkbox")
            if path not in self._left_out:
                made.props("checked")
            made.on("change", lambda event: self._clicked(path, is_chosen=bool(event.args)), js_handler=CHECKED)
            words(path.name, "span")

    def _clicked(self, path: Path, *, is_chosen: bool) -> Awaitable[None] | None:
        self._left_out.discard(path) if is_chosen else self._left_out.add(path)
        return self._on_change()
