"""Answer and large figures of a result, as the pages of the reports show them."""

from __future__ import annotations

from nicegui import ui

from torquerig.studio.server.elements import shown
from torquerig.studio.shown_answer import ShownAnswer, ShownPicture


def answer_html(answer: ShownAnswer) -> str:
    """Return the HTML of an answer and its figures."""
    first, *others = answer.sentences
    sentences = f'<p class="sentence">{shown(first)}</p>' + "".join(f"<p>{shown(one)}</p>" for one in others)
    figures = "".join(
        f'<div><dt>{shown(name)}</dt><dd class="large">{shown(value)}</dd><dd class="small">{shown(note)}</dd></div>'
        for name, value, note in answer.figures
    )
    return (
        f'<div class="answer {shown(answer.tone)}" role="group" aria-label="answer">{sentences}</div>'
        f'<dl class="figures">{figures}</dl>'
    )


def picture(one: ShownPicture) -> ui.html:
    """Add a picture with its caption."""
    return ui.html(
        f'<figure><img src="{shown(one.source)}" alt="{shown(one.alt_text)}">'
        f"<figcaption>{shown(one.caption)}</figcaption></figure>", sanitize=False,
    )  # fmt: skip
