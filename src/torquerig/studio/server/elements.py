"""Headings, paragraphs, buttons and tables: plain HTML, which a keyboard and a screen reader can use as it is."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterable, Sequence
from html import escape

from nicegui import ui

from torquerig.harmless import harmless

Action = Callable[[], Awaitable[None] | None]


def shown(text: object) -> str:
    """Return a text of a file or a person as HTML that acts on nothing."""
    return escape(harmless(str(text)))


def words(text: object, tag: str = "p", *, kind: str = "") -> ui.html:
    """Add an element with a text and, where ``kind`` is given, that class of the style sheet."""
    made = ui.html(shown(text), sanitize=False, tag=tag)
    return made.classes(kind) if kind else made


def say_in(element: ui.html, text: object) -> None:
    """Replace the text of an element."""
    element.set_content(shown(text))


def button(text: str, on_click: Action, *, name: str = "") -> ui.html:
    """Add a button; ``name`` is what a screen reader reads where the text alone is not clear."""
    made = words(text, "button").props("type=button")
    if name:
        made.props["aria-label"] = name
    made.on("click", lambda _: on_click())
    return made


def enable(element: ui.html, is_enabled: bool) -> None:
    """Switch a button on or off."""
    if is_enabled:
        element.props.pop("disabled", None)
    else:
        element.props["disabled"] = True
    element.update()


def table(
    head: Sequence[str], rows: Iterable[Sequence[object]], *, caption: str = "", numbers: Sequence[int] = ()
) -> ui.html:
    """Add a table whose first column names the row; the columns ``numbers`` are set to the right."""
    made = table_place(caption or head[0])
    made.set_content(table_html(head, rows, caption=caption, numbers=numbers))
    return made


def table_place(name: str) -> ui.html:
    """Add a place for a table that the keyboard can scroll; ``name`` is what a screen reader reads."""
    made = ui.html("", sanitize=False).classes("scroll").props("tabindex=0 role=region")
    made.props["aria-label"] = name
    return made


def table_html(
    head: Sequence[str], rows: Iterable[Sequence[object]], *, caption: str = "", numbers: Sequence[int] = ()
) -> str:
    """Return the HTML of a table; see :func:`table`."""

    def cell(tag: str, at: int, text: object, scope: str = "") -> str:
        kind = ' class="number"' if at in numbers else ""
        return f"<{tag}{kind}{scope}>{shown(text)}</{tag}>"

    top = "".join(cell("th", at, text, ' scope="col"') for at, text in enumerate(head))
    body = "".join(
        "<tr>" + "".join(
            cell("th" if at == 0 else "td", at, text, ' scope="row"' if at == 0 else "") for at, text in enumerate(row)
        ) + "</tr>" for row in rows
    )  # fmt: skip
    said = f"<caption>{shown(caption)}</caption>" if caption else ""
    return f"<table>{said}<thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def folded(title: str) -> ui.element:
    """Add a part of the page that opens by its title; use it as ``with folded("Sizing"):``."""
    made = ui.element("details")
    with made:
        words(title, "summary")
    return made
