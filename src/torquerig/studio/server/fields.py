"""Fields of a form: a label, what a person wrote, and what is wrong with it directly under it."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Sequence
from typing import Any

from nicegui import ui

from torquerig.harmless import harmless

Changed = Callable[[str], Awaitable[None] | None]


class Field(ui.element, component="page/studio_field.js"):
    """A field; what a person is writing is never overwritten before he leaves the field.

    Parameters
    ----------
    label : str
    value : str
    on_change : callable
        Called with the text when the field is left or Enter is pressed, and with the choice when one is made.
    kind : {"text", "number", "choice", "picker"}
        A picker takes any text and finds options by a part of their name.
    options : sequence of str
    hint : str
        Shown in an empty field.
    """

    def __init__(
        self, label: str, value: str, on_change: Changed, *, kind: str = "text", options: Sequence[str] = (),
        hint: str = "", unit: str = "",
    ) -> None:  # fmt: skip
        super().__init__()
        for name, one in (("label", label), ("kind", kind), ("hint", hint), ("unit", unit)):
            self.props[name] = harmless(one)
        self.props["value"], self.props["options"], self.props["problem"] = str(value), list(options), ""
        self.on("changed", lambda event: self._changed(str(event.args), on_change))

    @property
    def value(self) -> str:
        """The text as it was given or written last."""
        return str(self.props["value"])

    def set(self, value: object) -> None:
        """Show another value."""
        self.props["value"] = str(value)
        self.update()

    def choose_from(self, options: Sequence[str]) -> None:
        """Offer other options."""
        self.props["options"] = list(options)
        self.update()

    def problem(self, sentence: str) -> None:
        """Say under the field what is wrong with it; an empty text takes it back."""
        if self.props["problem"] != harmless(sentence):
            self.props["problem"] = harmless(sentence)
            self.update()

    def _changed(self, value: str, on_change: Changed) -> Any:
        self.props["value"] = value
        return on_change(value)


def text_field(label: str, value: str, on_change: Changed, *, hint: str = "") -> Field:
    """Add a field for any text, such as a quantity with its unit."""
    return Field(label, value, on_change, hint=hint)


def number_field(label: str, value: float | str, on_change: Changed, *, unit: str = "") -> Field:
    """Add a field for a number whose unit is stated next to it."""
    return Field(label, str(value), on_change, kind="number", unit=unit)


def choice(label: str, options: Sequence[str], value: str, on_change: Changed) -> Field:
    """Add a choice of a few options."""
    return Field(label, value, on_change, kind="choice", options=options)


def picker(label: str, options: Sequence[str], value: str, on_change: Changed, *, hint: str = "") -> Field:
    """Add a field that finds one of many options by a part of its name."""
    return Field(label, value, on_change, kind="picker", options=options, hint=hint)
