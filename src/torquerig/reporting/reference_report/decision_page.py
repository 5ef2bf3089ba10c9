"""A published decision computed again, as self-contained page and as Markdown."""

from __future__ import annotations

from pathlib import Path

from torquerig.reporting.html import html
from torquerig.reporting.matrix.markdown import escaped, table_text
from torquerig.reporting.reference_report.decision_chapters import chapters
from torquerig.study.reference_decision.decision import ReferenceDecision
from torquerig.whole_file import whole_file

TITLE = "The published decision, computed again"


def write_decision(decision: ReferenceDecision, path: Path) -> None:
    """Write ``path`` as .html or .md; an old file is replaced when the new one is complete."""
    text = (
        reference_decision_page(decision) if path.suffix.lower() == ".html" else reference_decision_markdown(decision)
    )
    with whole_file(path) as partial:
        partial.write_text(text, encoding="utf-8", newline="\n")


def reference_decision_page(decision: ReferenceDecision) -> str:
    """Return the HTML: without scripts or external requests; the same plan gives the same bytes."""
    settings = decision.plan.study.settings
    content = {
        "title": TITLE, "source": decision.plan.book.source, "answer": decision.answer, "chapters": chapters(decision),
        "command": command_of(decision), "seed": settings.seed, "draws": settings.draws,
    }  # fmt: skip
    return html("reference_decision.html", content)


def reference_decision_markdown(decision: ReferenceDecision) -> str:
    """Return the same chapters as Markdown."""
    parts = [f"# {TITLE}", f"{escaped(decision.plan.book.source)}; made with `{command_of(decision)}`"]
    for chapter in chapters(decision):
        parts.append(f"## {escaped(chapter.title)}")
        parts += ["\n".join(f"- {escaped(line)}" for line in chapter.lines)] if chapter.lines else []
        parts += [table_text(table) for table in chapter.tables]
    return "\n\n".join(parts) + "\n"


def command_of(decision: ReferenceDecision) -> str:
    """Return the command that repeats the page, without folders of this machine."""
    path = Path(decision.plan.document.path)
    return f"torquerig reference-decision {path.name if path.is_absolute() else path.as_posix()}"
