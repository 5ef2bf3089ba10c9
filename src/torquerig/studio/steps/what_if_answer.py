"""The answer of the step What-if: reading error, sizing, torque over time, spectrum with causes, commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from torquerig.plain_table import fixed
from torquerig.reporting.figures.effort import shown_unit
from torquerig.studio.server.elements import folded, say_in, shown, table_html, table_place, words
from torquerig.studio.server.plot import Plot

if TYPE_CHECKING:
    from torquerig.studio.what_if.answer import Simulated, Sized
    from torquerig.studio.what_if.question import Question

MOST_LINES = 12  # of the table: those that a page shows without scrolling
SIZES = {
    "holds": "large enough", "exceeds": "too small", "unsure": "may be too small", "unknown": "data missing",
}  # fmt: skip
NOTHING_YET = "Nothing could be computed yet: change what the page marks as wrong."
KEPT = "These are the values of the last change that could be computed."


class AnswerView:
    """What is shown of an answer; it stays until there is another one."""

    def __init__(self) -> None:
        self._has_answer = False
        self._kept = words("", "p", kind="note hidden").props("role=status")
        self._place = ui.element("div")
        with self._place:
            self._title = words("Computing.", "p", kind="line").props("id=what-if-title")
            with ui.element("dl").classes("figures"):
                self._after = _Figure("reading error with the filter", "what-if-error")
                self._before = _Figure("reading error without a filter", "what-if-error-before")
                self._size = _Figure("sizing", "what-if-sizing")
            self._doubts = words("", "p", kind="note")
            self._signal = Plot("Torque over time: reading before and after the filter, and the true load")
            self._spectrum = Plot("Amplitude spectrum before and after the filter, with the lines of the drive")
            words("Largest lines of the reading", "h3")
            self._lines = table_place("lines")
            with folded("Sizing: every figure"):
                self._sizing = table_place("sizing")
            with folded("The same on the command line"):
                self._commands = ui.html("", sanitize=False).classes("commands")

    def show(self, found: Simulated, question: Question) -> None:
        """Show what was simulated."""
        unit, self._has_answer = shown_unit(found.unit), True
        say_in(self._title, found.title)
        self._after.show(_number(found.error_after, unit), f"filter {question.chain}")
        self._before.show(_number(found.error_before, unit), "rms of the reading minus the true load")
        doubts = [*found.warnings, *(f"Not filtered: {one}." for one in found.left_out)]
        say_in(self._doubts, " ".join(doubts))
        self._signal.show(found.signal)
        self._spectrum.show(found.spectrum)
        rows = [
            (one.cause, f"{one.order:.5g}", f"{one.frequency:.2f}", f"{one.before:.2e}", f"{one.after:.2e}")
            for one in found.lines[:MOST_LINES]
        ]
        head = ("cause", "order [1/rev]", "frequency [Hz]", f"before [{unit}]", f"after [{unit}]")
        text = table_html(head, rows, numbers=(1, 2, 3, 4)) if rows else (
            "<p>The speed is not constant, so that no line has one frequency.</p>")  # fmt: skip
        self._lines.set_content(text)
        self._commands.set_content("".join(f"<pre>{shown(one)}</pre>" for one in question.commands().values()))
        self._set_kept(False)

    def show_sizing(self, found: Sized) -> None:
        """Show whether the drive is large enough."""
        self._size.show(SIZES[found.verdict], found.sentence)
        self._sizing.set_content(table_html(found.rows[0], found.rows[1:], numbers=(1,)))

    def show_no_sizing(self, reason: str) -> None:
        """Show why nothing can be sized."""
        self._size.show("not possible", reason)
        self._sizing.set_content("")

    def keep_last(self) -> None:
        """Say that what is shown belongs to the last change that could be computed, or that there is none."""
        if self._has_answer:
            self._set_kept(True)
        else:
            say_in(self._title, NOTHING_YET)

    def show_missing(self, sentence: str) -> None:
        """Say why nothing is computed where there is no answer yet."""
        if not self._has_answer:
            say_in(self._title, sentence)

    def _set_kept(self, is_kept: bool) -> None:
        say_in(self._kept, KEPT if is_kept else "")
        for one, name in ((self._kept, "hidden"), (self._place, "stale")):
            add = is_kept if name == "stale" else not is_kept
            one.classes(add=name) if add else one.classes(remove=name)


class _Figure:
    """A large figure with its name and one line of explanation."""

    def __init__(self, name: str, identity: str) -> None:
        self._shown = 0
        self._place = ui.element("div")
        with self._place:
            words(name, "dt")
            self._large = words("–", "dd", kind="large").props(f"id={identity}")
            self._small = words("", "dd", kind="small")

    def show(self, large: str, small: str) -> None:
        """Show other words; the page counts how often, so that a script can wait for the next ones."""
        self._shown += 1
        self._place.props["data-shown"] = self._shown
        self._place.update()
        say_in(self._large, large)
        say_in(self._small, small)


def _number(value: float | None, unit: str) -> str:
    return "unknown" if value is None else f"{fixed(value, scale=value, digits=3)} {unit}"
