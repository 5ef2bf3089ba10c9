"""The page of a round: a table per figure and set, what went wrong by kind, and every verdict as CSV."""

from __future__ import annotations

import csv
import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from proof.referee.figures import SetFigures, figures_of
from proof.referee.judging import Verdict
from proof.scoring.summary import Share

Table = list[list[str]]
MAIN: tuple[tuple[str, Callable[[SetFigures], Share], bool], ...] = (
    ("answered", lambda one: one.answered, True),
    ("exactly right", lambda one: one.exact, True),
    ("with a false name", lambda one: one.false_names, False),
    ("clean rigs accused", lambda one: one.accused, False),
    ("located", lambda one: one.located, True),
    ("modelled", lambda one: one.modelled, True),
    ("set-up reported", lambda one: one.setup_reported, True),
    ("answer unchanged", lambda one: one.unchanged, True),
)


@dataclass(frozen=True)
class Written:
    """Paths of the written files."""

    markdown: Path
    html: Path
    csv: Path


def write_page(out: Path, verdicts: Sequence[Verdict], *, command: str, seal: str) -> Written:
    """Write ``fleet.md``, ``fleet.html`` and ``verdicts.csv`` of a round into its folder."""
    names = list(dict.fromkeys(one.set_name for one in verdicts))
    figures = [figures_of(name, [one for one in verdicts if one.set_name == name]) for name in names]
    whole = figures_of("all", verdicts)
    chapters = chapters_of([*figures, whole], verdicts)
    written = Written(out / "fleet.md", out / "fleet.html", out / "verdicts.csv")
    head = f"Command: `{command}`. SHA-256 of the answers: `{seal}`."
    written.markdown.write_text(_markdown(head, chapters), encoding="utf-8")
    written.html.write_text(_html(head, chapters), encoding="utf-8")
    _write_csv(written.csv, verdicts)
    return written


def chapters_of(figures: Sequence[SetFigures], verdicts: Sequence[Verdict]) -> list[tuple[str, Table]]:
    """Return the tables of the page with their titles."""
    main = [["set", "cases", *(title for title, _, _ in MAIN)]]
    main += [
        [one.name, str(one.cases), *(share_text(of(one), at_least=more) for _, of, more in MAIN)] for one in figures
    ]
    more = [["set", "sizes", "median error", "intervals with the truth", "median half-width", "findings",
             "calibration error", "mean chi-square of clean rigs"]]  # fmt: skip
    more += [_more(one) for one in figures]
    groups = [["set", "kind", "exactly right", "with a false name"]]
    groups += [
        [one.name, group, share_text(exact, at_least=True), share_text(false, at_least=False)]
        for one in figures if one.name != "all" for group, (exact, false) in one.groups.items()
    ]  # fmt: skip
    wrong = [["case", "due", "hidden", "said", "named", "wrong because"]]
    wrong += [[one.name, one.due, ", ".join(one.effects), one.said or "no answer", ", ".join(one.named), reason(one)]
              for one in verdicts if not one.exact]  # fmt: skip
    return [("Shares, with one-sided 95 % bounds (Clopper and Pearson)", main), ("Sizes and calibration", more),
            ("By kind", groups), ("Every case that is not exactly right", wrong)]  # fmt: skip


def share_text(share: Share, *, at_least: bool) -> str:
    """Return a share with its bound, ``-`` without cases."""
    if share.trials == 0:
        return "-"
    bound = f">= {100 * share.lower:.0f}" if at_least else f"<= {100 * share.upper:.0f}"
    return f"{share.hits} of {share.trials} ({bound} %)"


def reason(one: Verdict) -> str:
    """Return why a case is not exactly right."""
    if not one.said:
        return one.why_not.strip().splitlines()[-1][:200] if one.why_not.strip() else "no answer"
    if one.false_names:
        return "false: " + ", ".join(one.false_names)
    if one.missed:
        return "missed: " + ", ".join(one.missed)
    if one.setup_reported is False:
        return "set-up fault not reported"
    return f"verdict {one.said} instead of {one.due}"


def _more(one: SetFigures) -> list[str]:
    sizes = one.sizes
    cells = ["0", "-", "-", "-"] if sizes is None else [
        str(sizes.count), f"{100 * sizes.error:.1f} %", share_text(sizes.covered, at_least=True),
        "-" if sizes.half_width is None else f"{100 * sizes.half_width:.1f} %",
    ]  # fmt: skip
    error = "-" if one.calibration_error is None else f"{one.calibration_error:.3f}"
    chi = "-" if one.chi_square is None else f"{one.chi_square:.2f}"
    return [one.name, *cells, str(one.findings), error, chi]


def _markdown(head: str, chapters: Sequence[tuple[str, Table]]) -> str:
    lines = ["# The referee: diagnoses of the fleet", "", head, ""]
    for title, table in chapters:
        rows = [[cell.replace("|", "/") for cell in row] for row in table]
        lines += [f"## {title}", "", "| " + " | ".join(rows[0]) + " |", "|" + "---|" * len(rows[0])]
        lines += ["| " + " | ".join(row) + " |" for row in rows[1:]] + [""]
    return "\n".join(lines)


def _html(head: str, chapters: Sequence[tuple[str, Table]]) -> str:
    style = "body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}"
    style += "td,th{border:1px solid #bbb;padding:2px 6px;text-align:left}"
    parts = [f"<!doctype html><html lang='en'><meta charset='utf-8'><title>The referee</title><style>{style}</style>",
             "<h1>The referee: diagnoses of the fleet</h1>", f"<p>{html.escape(head)}</p>"]  # fmt: skip
    for title, table in chapters:
        first = "".join(f"<th>{html.escape(cell)}</th>" for cell in table[0])
        rows = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in table[1:])
        parts.append(f"<h2>{html.escape(title)}</h2><table><tr>{first}</tr>{rows}</table>")
    return "\n".join([*parts, "</html>", ""])


def _write_csv(path: Path, verdicts: Sequence[Verdict]) -> None:
    columns = ("name", "set_name", "group", "due", "said", "exact", "accused", "located", "modelled", "setup_reported")
    with path.open("w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream)
        table.writerow([*columns, "effects", "named", "false_names", "missed", "reason"])
        for one in verdicts:
            lists = (one.effects, one.named, one.false_names, one.missed)
            table.writerow([*(getattr(one, name) for name in columns), *("; ".join(some) for some in lists),
                            "" if one.exact else reason(one)])  # fmt: skip
