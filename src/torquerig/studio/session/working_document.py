"""One open file: its text, what is wrong with it, the last good result, and the way back."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.studio.session.checked import Checked, Kind
from torquerig.studio.session.file_on_disk import FileOnDisk
from torquerig.studio.session.problem import Problem
from torquerig.studio.session.yaml_spans import Keys

MOST_STEPS = 500
"""Edits that can be undone; each holds one text of the file, some 10 kB."""


@dataclass(frozen=True)
class Step:
    """A text of the past or future, and the keys of the edit that left it."""

    text: str
    keys: Keys


@dataclass(frozen=True, kw_only=True)
class WorkingDocument:
    """One file that is open in a tab; each edit returns a new one.

    Parameters
    ----------
    kind : str
        ``scenario``, ``sheet``, ``matrix``, ``filters`` or ``other``.
    text : str
        As it is edited.
    problems : tuple of Problem
        Empty where the text can be used.
    good : Scenario, Sidecar, MatrixCase, TableSet, mapping of chains, or None
        What the last text without problems was read as: it stays while an edit is wrong.
    good_text : str or None
        That text.
    file : FileOnDisk
        As it was read or saved last.
    past, future : tuple of Step
        What undo and redo give back, the nearest last.
    """

    kind: Kind
    text: str
    problems: tuple[Problem, ...]
    good: Any
    good_text: str | None
    file: FileOnDisk
    past: tuple[Step, ...] = ()
    future: tuple[Step, ...] = ()

    @property
    def path(self) -> Path:
        """The file, as an absolute path."""
        return self.file.path

    @property
    def is_valid(self) -> bool:
        """Whether the text as it is now can be used."""
        return not self.problems

    @property
    def is_saved(self) -> bool:
        """Whether the file has this text, as it was read or saved last."""
        return self.file.content == self.text.encode("utf-8")

    @property
    def data(self) -> Any:
        """The data of the present text; of the last good text where the present one is no YAML; else None."""
        for text in (self.text, self.good_text):
            if text is not None:
                try:
                    return parse_document(text, self.path).data
                except InputError:
                    continue
        return None

    def value(self, *keys: str | int) -> Any:
        """Return the value under a path as the file states it; None where it does not have it."""
        found = self.data
        for key in keys:
            if isinstance(found, dict):
                found = next((one for name, one in found.items() if str(name) == str(key)), None)
            elif isinstance(found, list) and isinstance(key, int) and 0 <= key < len(found):
                found = found[key]
            else:
                return None
        return found

    def problems_at(self, *keys: str | int) -> tuple[Problem, ...]:
        """Return the problems of a field and of what is in it."""
        wanted = tuple(map(str, keys))
        return tuple(one for one in self.problems if tuple(map(str, one.keys))[: len(wanted)] == wanted)


def edited(document: WorkingDocument, text: str, found: Checked, *, keys: Keys, merge: bool) -> WorkingDocument:
    """Return the document with a new text that was checked; ``merge`` makes edits of one field one step of undo."""
    if text == document.text:
        return document
    is_same_field = merge and bool(document.past) and document.past[-1].keys == keys and bool(keys)
    past = document.past if is_same_field else (*document.past, Step(document.text, keys))[-MOST_STEPS:]
    return _with(replace(document, past=past, future=()), text, found)


def undone(document: WorkingDocument, found: Checked) -> WorkingDocument:
    """Return the document before the last edit, whose text was checked."""
    last = document.past[-1]
    future = (*document.future, Step(document.text, last.keys))
    return _with(replace(document, past=document.past[:-1], future=future), last.text, found)


def redone(document: WorkingDocument, found: Checked) -> WorkingDocument:
    """Return the document with the edit again that was undone last, whose text was checked."""
    last = document.future[-1]
    past = (*document.past, Step(document.text, last.keys))
    return _with(replace(document, past=past, future=document.future[:-1]), last.text, found)


def checked_again(document: WorkingDocument, found: Checked) -> WorkingDocument:
    """Return the document with a new check of the same text, after a catalog or filters file has changed."""
    return _with(document, document.text, found)


def _with(document: WorkingDocument, text: str, found: Checked) -> WorkingDocument:
    good = (document.good, document.good_text) if found.problems else (found.value, text)
    return replace(document, kind=found.kind, text=text, problems=found.problems, good=good[0], good_text=good[1])
