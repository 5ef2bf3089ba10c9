"""The page as HTML and as Markdown: chapters of sentences, tables and pictures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.html import html
from torquerig.reporting.matrix.chapters import Chapter
from torquerig.reporting.matrix.markdown import escaped, table_text
from torquerig.whole_file import whole_file


@dataclass(frozen=True, kw_only=True)
class ProofPage:
    """The content of the page.

    Parameters
    ----------
    title : str
    lead : tuple of str
        Sentences at the top.
    chapters : tuple of Chapter
    pictures : mapping of str to tuple of Picture
        By the anchor of their chapter; the Markdown has only captions.
    command : str
        Command that reproduces the page.
    """

    title: str
    lead: tuple[str, ...]
    chapters: tuple[Chapter, ...]
    pictures: Mapping[str, tuple[Picture, ...]] = field(default_factory=dict)
    command: str


def write_proof(page: ProofPage, path: Path) -> None:
    """Write ``path`` as .html or, with any other ending, as Markdown; an old file is replaced when complete."""
    text = proof_html(page) if path.suffix.lower() == ".html" else proof_markdown(page)
    with whole_file(path) as partial:
        partial.write_text(text, encoding="utf-8", newline="\n")


def proof_html(page: ProofPage) -> str:
    """Return the HTML: inline pictures, no script, no request."""
    return html("proof.html", {"page": page}, folder=Path(__file__).with_name("templates"))


def proof_markdown(page: ProofPage) -> str:
    """Return the same chapters as Markdown."""
    parts = [f"# {escaped(page.title)}", *(escaped(line) for line in page.lead), f"Made with `{page.command}`."]
    for chapter in page.chapters:
        parts.append(f"## {escaped(chapter.title)}")
        parts += ["\n".join(f"- {escaped(line)}" for line in chapter.lines)] if chapter.lines else []
        parts += [table_text(table) for table in chapter.tables]
        parts += [escaped(one.caption) for one in page.pictures.get(chapter.anchor, ())]
    return "\n\n".join(parts) + "\n"
