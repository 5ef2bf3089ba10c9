"""The sidecar of a recording as a form with undo and save."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path

from nicegui import ui

from torquerig.errors import InputError
from torquerig.recordings.files.sidecar_choice import find_sidecar
from torquerig.studio.data.sheet_form import SheetField, SheetGroup, set_field, sheet_form
from torquerig.studio.server.elements import button, enable, say_in, words
from torquerig.studio.server.fields import Field, choice, picker, text_field
from torquerig.studio.server.tab import Tab
from torquerig.studio.session.problem import Problem
from torquerig.studio.session.working_document import WorkingDocument
from torquerig.studio.session.yaml_spans import Keys


class SheetView:
    """The form of one sidecar.

    Parameters
    ----------
    tab : Tab
    on_saved : callable
        Called after the sidecar was written, so that the recording is read again.
    """

    def __init__(self, tab: Tab, on_saved: Callable[[], Awaitable[None] | None]) -> None:
        self.tab, self._on_saved = tab, on_saved
        self._path: Path | None = None
        self._fields: dict[Keys, Field] = {}
        self._drawn: tuple[Keys, ...] = ()
        words("Sidecar", "h3")
        self._line = words("", kind="note").props("role=status")
        with ui.element("div").classes("acts"):
            self._acts = {
                "undo": button("Undo", lambda: self._act("undo"), name="Undo in the sidecar"),
                "redo": button("Redo", lambda: self._act("redo"), name="Redo in the sidecar"),
                "reload": button("Reload from disk", lambda: self._act("reload"), name="Reload the sidecar from disk"),
                "save": button("Save the sidecar", self._save),
            }
        self._problems = ui.element("div")
        self._form = ui.element("div")

    def open(self, target: Path, draft: str) -> None:
        """Show the sidecar ``target``: as it is edited, as it is on the disk, or a draft for it."""
        self._path = None
        session = self.tab.session
        opened = {one.path: one for one in session.opened()}
        if target in opened or target.exists():
            self._path = target
            session.open(target)
        elif draft:
            self._path = target
            session.new(target, draft)
        self._drawn = ()
        self._show()

    @property
    def document(self) -> WorkingDocument | None:
        """The sidecar with its edits."""
        return None if self._path is None else self.tab.session.open(self._path)

    def _act(self, what: str) -> None:
        session, path = self.tab.session, self._path
        if path is None:
            return
        try:
            {"undo": session.undo, "redo": session.redo, "reload": session.reload}[what](path)
        except InputError as error:
            self.tab.say(str(error))
        self._show()

    def _save(self) -> Awaitable[None] | None:
        if self._path is None:
            return None
        try:
            saved = self.tab.session.save(self._path)
        except InputError as error:
            self.tab.say(str(error))
            return None
        self.tab.say(saved.sentence)
        self._show()
        return self._on_saved() if saved.written else None

    def _set(self, field: SheetField, written: str) -> None:
        document = self.document
        if document is None:
            return
        try:
            set_field(self.tab.session, document, field.keys, written)
        except InputError as error:
            self._fields[field.keys].problem(str(error))
            return
        self._show()

    def _show(self) -> None:
        document = self.document
        for name, is_on in self._states(document).items():
            enable(self._acts[name], is_on)
        self._problems.clear()
        if document is None:
            self._form.clear()
            say_in(self._line, "There is no sidecar, and no draft can be made, because nothing can be read.")
            return
        name = document.path.name
        on_disk = "saved" if document.is_saved else "not saved yet"
        say_in(self._line, f"{name}: {on_disk}. It states what each column means and how the rig was run.")
        scenario = self.tab.document
        parts = scenario.value("rig") if scenario is not None else None
        names = list(parts) if isinstance(parts, dict) else []
        groups = sheet_form(document, parts=names, motors=[*self.tab.session.catalog.motors])
        keys = tuple(field.keys for group in groups for field in group.fields)
        if keys != self._drawn:
            self._draw(groups)
            self._drawn = keys
        shown: set[Problem] = set()
        for field in (field for group in groups for field in group.fields):
            found = document.problems_at(*field.keys)
            shown.update(found)
            self._fields[field.keys].set(field.value)
            self._fields[field.keys].problem(" ".join(one.sentence for one in found))
        with self._problems:
            for one in document.problems:
                if one not in shown:
                    words(one.text(), kind="problem")

    def _states(self, document: WorkingDocument | None) -> dict[str, bool]:
        if document is None:
            return dict.fromkeys(self._acts, False)
        return {
            "undo": bool(document.past), "redo": bool(document.future), "save": not document.is_saved,
            "reload": find_sidecar(document.path) is not None or document.path.exists(),
        }  # fmt: skip

    def _draw(self, groups: Sequence[SheetGroup]) -> None:
        self._form.clear()
        self._fields = {}
        with self._form:
            for group in groups:
                with ui.element("fieldset"):
                    words(group.title, "legend")
                    with ui.element("div").classes("form"):
                        for field in group.fields:
                            self._fields[field.keys] = self._field(field)

    def _field(self, field: SheetField) -> Field:
        def set_it(written: str) -> None:
            self._set(field, written)

        if field.kind == "choice":
            return choice(field.label, field.options, field.value, set_it)
        if field.kind == "picker":
            return picker(field.label, field.options, field.value, set_it)
        label = f"{field.label} [{field.unit}]" if field.unit else field.label
        return text_field(label, field.value, set_it)
