"""What one tab has open: files of one folder, each with its edits; two sessions share nothing but the disk."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from torquerig.catalog.reading import Catalog
from torquerig.errors import InputError
from torquerig.studio.session import yaml_edits
from torquerig.studio.session.catalog_state import CatalogState, catalog_state
from torquerig.studio.session.checked import Checked, Kind, checked
from torquerig.studio.session.file_on_disk import FileOnDisk, Saved, State, read_text, save
from torquerig.studio.session.folder_files import FolderFiles, files_in
from torquerig.studio.session.problem import Problem
from torquerig.studio.session.working_document import (
    WorkingDocument,
    checked_again,
    edited,
    redone,
    undone,
)
from torquerig.studio.session.yaml_spans import Keys


@dataclass(eq=False)
class Session:
    """The working state of one tab.

    Parameters
    ----------
    folder : Path
        Of the files; absolute.
    further : tuple of Path
        Further catalog folders.
    seed : int
        Fixes what is drawn where the catalog has only an interval.
    """

    folder: Path
    further: tuple[Path, ...] = ()
    seed: int = 1
    _open: dict[Path, WorkingDocument] = field(default_factory=dict, repr=False)
    _catalog: CatalogState = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.folder = self.folder.resolve()
        if not self.folder.is_dir():
            raise InputError(f"{self.folder}: there is no such folder; check the path")
        self._catalog = catalog_state(self.folder / "scenario.yaml", self.further)

    def files(self) -> FolderFiles:
        """Return what is in the folder now."""
        return files_in(self.folder)

    @property
    def catalog(self) -> Catalog:
        """The catalog; read again where its files have changed, the last good one where one of them is wrong."""
        self._catalog = self._catalog.current()
        return self._catalog.catalog

    def catalog_problems(self) -> tuple[Problem, ...]:
        """Return what is wrong with the catalog files now, each with its file; the last good catalog stays in use."""
        self._catalog = self._catalog.current()
        return self._catalog.problems

    def open(self, path: str | Path) -> WorkingDocument:
        """Return the open file of a path (from the folder of the session), read where it is not open yet.

        Raises
        ------
        InputError
            Where it is missing or no UTF-8 text. A text with mistakes opens, with its problems.
        """
        full = self._full(path)
        if full not in self._open:
            text, file = read_text(full)
            self._open[full] = self._document(text, file)
        return self._open[full]

    def new(self, path: str | Path, text: str) -> WorkingDocument:
        """Open a file that is not on the disk yet; InputError where one is there. `save` writes it."""
        full = self._full(path)
        if full.exists() or full in self._open:
            raise InputError(f"{full.name}: is there already; choose another name")
        self._open[full] = self._document(text, FileOnDisk(full, None))
        return self._open[full]

    def opened(self) -> tuple[WorkingDocument, ...]:
        """Return all open files."""
        return tuple(self._open.values())

    def close(self, path: str | Path) -> None:
        """Forget an open file and its edits."""
        self._open.pop(self._full(path), None)

    def edit(self, path: str | Path, keys: Keys, value: Any, *, merge: bool = False) -> WorkingDocument:
        """Set the value under ``keys``; comments, order and every other sign of the file stay.

        ``merge`` makes consecutive edits of the same field (a slider) one step of undo. A value that makes the file
        unusable is taken: ``problems`` lists what is wrong and ``good`` stays what it was.

        Raises
        ------
        InputError
            Where the path cannot be edited; the file is as before.
        """
        return self._edited(path, keys, lambda text, file: yaml_edits.with_value(text, keys, value, path=file), merge)

    def edit_text(self, path: str | Path, keys: Keys, written: str, *, merge: bool = False) -> WorkingDocument:
        """Set a value to what a person wrote into a field: ``200 rpm``, ``2.0e-4``, ``[1, 2]``; as :meth:`edit`."""
        return self._edited(path, keys, lambda text, file: yaml_edits.with_text(text, keys, written, path=file), merge)

    def insert(self, path: str | Path, keys: Keys, value: Any, *, after: str | None) -> WorkingDocument:
        """Add a key behind the key ``after`` of its mapping, such as a part of the rig; None: at the beginning."""
        return self._edited(
            path, keys, lambda text, file: yaml_edits.with_entry(text, keys, value, after=after, path=file)
        )

    def remove(self, path: str | Path, keys: Keys) -> WorkingDocument:
        """Remove a key or an item of a list."""
        return self._edited(path, keys, lambda text, file: yaml_edits.without(text, keys, path=file))

    def move(self, path: str | Path, keys: Keys, *, after: str | None) -> WorkingDocument:
        """Move a key behind the key ``after`` of its mapping, with its comments; None: to the beginning."""
        return self._edited(path, keys, lambda text, file: yaml_edits.moved(text, keys, after=after, path=file))

    def replace_text(self, path: str | Path, text: str) -> WorkingDocument:
        """Set the whole text of a file, as it is edited by hand."""
        return self._edited(path, (), lambda _, __: text)

    def undo(self, path: str | Path) -> WorkingDocument:
        """Take the last edit back; nothing where there is none."""
        document = self.open(path)
        if document.past:
            document = undone(document, self._check(document.past[-1].text, document.path, document.kind))
        return self._kept(document)

    def redo(self, path: str | Path) -> WorkingDocument:
        """Make the edit again that was undone last; nothing where there is none."""
        document = self.open(path)
        if document.future:
            document = redone(document, self._check(document.future[-1].text, document.path, document.kind))
        return self._kept(document)

    def recheck(self, path: str | Path) -> WorkingDocument:
        """Check the same text again, after a catalog or another file that it uses has changed."""
        document = self.open(path)
        return self._kept(checked_again(document, self._check(document.text, document.path, document.kind)))

    def disk_state(self, path: str | Path) -> State:
        """Return ``same``, ``changed`` or ``gone``: the file on the disk compared with what was read or saved last."""
        return self.open(path).file.state()

    def save(self, path: str | Path) -> Saved:
        """Write the file whole; refused, with what can be done, where it has changed on disk since it was read.

        Raises
        ------
        InputError
            Where the folder or disk cannot be written to; nothing is lost.
        """
        document = self.open(path)
        saved = save(document.file, document.text)
        self._kept(replace(document, file=saved.file))
        count = len(document.problems)
        if saved.written and count:
            what = "1 problem" if count == 1 else f"{count} problems"
            return replace(saved, sentence=f"{saved.sentence}; it has {what}, and the commands refuse it until they "
                           "are corrected")  # fmt: skip
        return saved

    def save_as(self, path: str | Path, other: str | Path) -> Saved:
        """Write an open file under another name, and have it open under that one; refused where one is there."""
        document, full = self.open(path), self._full(other)
        if full.exists() or full in self._open:
            return Saved(False, f"{full.name}: is there already; choose another name", document.file, ("save_as",))
        saved = save(FileOnDisk(full, None), document.text)
        if saved.written:
            self.close(path)
            found = self._check(document.text, full, document.kind)
            self._kept(checked_again(replace(document, file=saved.file), found))
        return saved

    def reload(self, path: str | Path) -> WorkingDocument:
        """Read the file from the disk again; the edits of this tab can be had back by undo."""
        document = self.open(path)
        text, file = read_text(document.path)
        found = self._check(text, document.path, document.kind)
        return self._kept(replace(edited(document, text, found, keys=(), merge=False), file=file))

    def _edited(
        self, path: str | Path, keys: Keys, edit: Callable[[str, Path], str], merge: bool = False
    ) -> WorkingDocument:
        document = self.open(path)
        text = edit(document.text, document.path)
        found = self._check(text, document.path, document.kind)
        return self._kept(edited(document, text, found, keys=keys, merge=merge))

    def _document(self, text: str, file: FileOnDisk) -> WorkingDocument:
        found = self._check(text, file.path, None)
        good = (None, None) if found.problems else (found.value, text)
        return WorkingDocument(
            kind=found.kind, text=text, problems=found.problems, good=good[0], good_text=good[1], file=file
        )

    def _check(self, text: str, path: Path, kind: Kind | None) -> Checked:
        return checked(text, path, catalog=self.catalog, seed=self.seed, kind=kind)

    def _kept(self, document: WorkingDocument) -> WorkingDocument:
        self._open[document.path] = document
        return document

    def _full(self, path: str | Path) -> Path:
        """Return the absolute path of a file of the folder; InputError where it is outside of it."""
        full = (self.folder / path).resolve()
        if not full.is_relative_to(self.folder):
            raise InputError(f"{path}: is outside of the folder {self.folder}; the studio works on the files in it")
        return full
