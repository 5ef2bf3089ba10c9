"""The form of the step What-if: the values of the scenario, and what is changed in them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from nicegui import ui

from torquerig.errors import TorquerigError
from torquerig.studio.server.elements import say_in, words
from torquerig.studio.server.fields import Field, choice, picker, text_field
from torquerig.studio.server.tab import Tab
from torquerig.studio.what_if.asked import changeable_of
from torquerig.studio.what_if.question import Question

if TYPE_CHECKING:
    from torquerig.studio.what_if.changeable import Changeable

Keys = tuple[str, ...]


@dataclass(frozen=True)
class Changes:
    """What is changed: empty texts where the scenario is as stated."""

    motor: str = ""
    gearbox: str = ""
    chain: str = ""
    numbers: tuple[tuple[Keys, str], ...] = ()

    def with_number(self, keys: Keys, text: str) -> Changes:
        """Return the changes with one number set, or as stated where ``text`` is empty."""
        others = tuple(one for one in self.numbers if one[0] != keys)
        return replace(self, numbers=(*others, (keys, text)) if text else others)


@dataclass
class _State:
    changes: Changes = Changes()
    past: list[Changes] = field(default_factory=list)


class WhatIfForm:
    """Fields of one tab; ``asked`` is called when there is another question."""

    def __init__(self, tab: Tab, asked: Callable[[], None]) -> None:
        self.tab, self._asked, self._state = tab, asked, _State()
        self._known: Changeable | None = None
        self._source = ("", "")
        self._fields: dict[Keys, Field] = {}
        self._place = ui.element("div").classes("form")
        self._problem = words("", "p", kind="problem hidden").props("role=alert")

    @property
    def can_undo(self) -> bool:
        """Whether a change can be taken back."""
        return bool(self._state.past)

    @property
    def is_changed(self) -> bool:
        """Whether anything but the filter differs from the scenario."""
        return replace(self._state.changes, chain="") != Changes()

    def question(self) -> Question | None:
        """Return what is to be computed; None where no scenario can be used."""
        (path, text), known, changes = self._source, self._known, self._state.changes
        if known is None:
            return None
        return Question(
            path=Path(path), text=text, motor=changes.motor, gearbox=changes.gearbox, settings=changes.numbers,
            chain=changes.chain or known.chain, catalogs=self.tab.session.further,
        )  # fmt: skip

    async def show_document(self) -> None:
        """Take up the scenario of the tab where it is another one or was edited; the last good text counts."""
        document = self.tab.document
        text = None if document is None else document.good_text
        if document is None or text is None or (str(document.path), text) == self._source:
            return
        if str(document.path) != self._source[0]:
            self._state = _State()
        source = self._source = (str(document.path), text)
        stated = Question(path=document.path, text=text, catalogs=self.tab.session.further)
        try:
            known = await self.tab.compute.run(changeable_of, stated)
        except TorquerigError as error:
            self._say(str(error))
            return
        if source == self._source:
            self._known = known
            self._draw(known)
            self._asked()

    def undo(self) -> None:
        """Take the last change back."""
        if self._state.past:
            self._state.changes = self._state.past.pop()
            self._show_values()

    def clear(self) -> None:
        """Go back to what the scenario states, with the chosen filter."""
        self._change(Changes(chain=self._state.changes.chain))
        self._show_values()

    def forget(self) -> None:
        """Forget the changes, which are in the scenario now."""
        self._state = _State(Changes(chain=self._state.changes.chain))
        self._show_values(asks=False)

    def blame(self, question: Question, error: TorquerigError | None) -> None:
        """Show an error at the field that it is about, else above the answer; None takes all back."""
        text = "" if error is None else str(error)
        at = _blamed(question, text) if text else None
        sentence = _plain(text, question)
        for keys, one in self._fields.items():
            one.problem(sentence if keys == at else "")
        self._say(sentence if at not in self._fields else "")

    def _draw(self, known: Changeable) -> None:
        self._place.clear()
        self._fields = {}
        with self._place:
            if known.motors:
                self._fields["motor",] = picker("motor", known.motors, "", self._set_motor)
            if known.gearboxes:
                self._fields["gearbox",] = picker("gearbox", known.gearboxes, "", self._set_gearbox)
            for one in known.numbers:
                hint = one.written or "as in the catalog"
                self._fields[one.keys] = text_field(one.label, "", partial(self._set_number, one.keys), hint=hint)
            self._fields["chain",] = choice("filter", known.chains, "", self._set_chain)
        self._show_values(asks=False)

    def _show_values(self, *, asks: bool = True) -> None:
        known, changes = self._known, self._state.changes
        if known is None:
            return
        shown: dict[Keys, str] = {one.keys: one.written for one in known.numbers} | dict(changes.numbers)
        shown |= {("motor",): changes.motor or known.motor, ("gearbox",): changes.gearbox or known.gearbox,
                  ("chain",): changes.chain or known.chain}  # fmt: skip
        for keys, one in self._fields.items():
            one.set(shown.get(keys, ""))
        if asks:
            self._asked()

    def _set_motor(self, name: str) -> None:
        assert self._known is not None
        self._change(replace(self._state.changes, motor="" if name in ("", self._known.motor) else name))

    def _set_gearbox(self, name: str) -> None:
        assert self._known is not None
        stays = name in ("", self._known.gearbox)
        self._change(replace(self._state.changes, gearbox="" if stays else name))

    def _set_number(self, keys: Keys, text: str) -> None:
        assert self._known is not None
        stated = next(one.written for one in self._known.numbers if one.keys == keys)
        self._change(self._state.changes.with_number(keys, "" if text.strip() == stated else text.strip()))

    def _set_chain(self, name: str) -> None:
        self._change(replace(self._state.changes, chain=name))

    def _change(self, changes: Changes) -> None:
        if changes != self._state.changes:
            self._state.past.append(self._state.changes)
            self._state.changes = changes
            self._asked()

    def _say(self, text: str) -> None:
        say_in(self._problem, text)
        self._problem.classes(remove="hidden") if text else self._problem.classes(add="hidden")


def _plain(text: str, question: Question) -> str:
    """Return an error without what only the command line has: its options, and the folder of the scenario."""
    text = text.partition(" (the scenario was read with --set")[0].replace(f"{question.path.parent}{os.sep}", "")
    for option, name in (("--motor", question.motor), ("--gearbox", question.gearbox)):
        text = text.removeprefix(f"{option} {name}: ")
    for keys, value in question.settings:
        place = ".".join(keys)
        text = text.removeprefix(f"--set {place}={value}: ").removeprefix(f"{place}: ")
    return text


def _blamed(question: Question, text: str) -> Keys | None:
    """Return the keys of the field that an error names; None where it names none."""
    if question.motor and ("--motor" in text or f"'{question.motor}'" in text):
        return ("motor",)
    if question.gearbox and text.startswith("--gearbox"):
        ratio = next((keys for keys, _ in question.settings if keys[-1] == "ratio"), None)
        return ratio if "ratio" in text and ratio is not None else ("gearbox",)
    if "filter chain" in text:
        return ("chain",)
    written = {f"--set {'.'.join(keys)}={value}": keys for keys, value in question.settings}
    exact = next((keys for start, keys in written.items() if text.startswith(start)), None)
    if exact is not None:
        return exact
    return next((keys for keys, _ in reversed(question.settings) if ".".join(keys) in text), None)
