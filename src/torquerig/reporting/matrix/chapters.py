"""A matrix analysis as chapters of tables and sentences, for page and Markdown."""

from __future__ import annotations

from dataclasses import dataclass, replace

from torquerig.decide.eliminate import Decision
from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.decide.matrix_io.certainty_text import convergence_text, flips_text, pareto_text
from torquerig.decide.matrix_io.result_text import span
from torquerig.decide.pugh import Sign
from torquerig.decide.ranks import shown_rank
from torquerig.decide.trace import all_traces
from torquerig.reporting.figures.shades import GOOD_IS_HIGH, mark_style, shade
from torquerig.reporting.layout import Cell, Table, number, words


@dataclass(frozen=True, kw_only=True)
class Chapter:
    """A heading with its content.

    Parameters
    ----------
    anchor, title : str
    lines : tuple of str
        Sentences, above the tables.
    tables : tuple of Table
    picture : str
        ``strength`` or ``profile`` where the page shows that picture after the tables.
    """

    anchor: str
    title: str
    lines: tuple[str, ...] = ()
    tables: tuple[Table, ...] = ()
    picture: str = ""


def chapters(worked: MatrixAnalysis) -> tuple[Chapter, ...]:
    """Return all chapters in their order on the page."""
    return (
        known_chapter(worked),
        _elimination(worked),
        Chapter(anchor="pareto", title="Dominance (without weights)", lines=_lines(pareto_text(worked.pareto))),
        _pugh(worked),
        _kesselring(worked),
        *_strength(worked),
        _sure(worked),
        _ask(worked),
        _changed(worked),
        _findings(worked),
        _traces(worked),
    )


def trace_anchor(worked: MatrixAnalysis, alternative: str, criterion: str) -> str:
    """Return the anchor of one cell's calculation on the page."""
    matrix = worked.case.matrix
    column = next(place for place, one in enumerate(matrix.criteria) if one.name == criterion)
    return f"cell-{matrix.index(alternative) + 1}-{column + 1}"


def known_chapter(worked: MatrixAnalysis) -> Chapter:
    """Return the known values, each cell with a link to its calculation."""
    matrix = worked.case.matrix
    head = [one.name if one.unit in ("1", "yes/no") else f"{one.name} [{one.unit}]" for one in matrix.criteria]
    rows = []
    for name in matrix.alternatives:
        cells = []
        for one in matrix.criteria:
            cell = matrix.cell(name, one.name)
            source = "; ".join(text for text in (cell.source, cell.evidence, cell.unknown_reason) if text)
            shown = number(cell.shown(), title=source)
            cells.append(replace(shown, link=f"#{trace_anchor(worked, name, one.name)}"))
        rows.append((*words(name), *cells))
    table = Table(caption="Known values; ? is missing and never counts as zero", head=("alternative", *head),
                  rows=tuple(rows))  # fmt: skip
    return Chapter(anchor="known", title="Known values", tables=(table,))


def _elimination(worked: MatrixAnalysis) -> Chapter:
    rules = {
        one.name: one.requirement.rule(one.name, one.unit)
        for one in worked.case.matrix.criteria
        if one.requirement is not None
    }
    rows = []
    for row in worked.chart.rows:
        marks = [str(row.marks.get(name, "")) for name in worked.chart.criteria]
        remarks = "; ".join(remark.sentence() for remark in row.remarks)
        cells = (Cell(text=mark, style=mark_style(mark), word="mark") for mark in marks)
        rows.append((*words(row.alternative), *cells, *words(str(row.decision)), Cell(text=remarks, word="remark")))
    table = Table(
        caption="+ meets the requirement, - fails it, ? the value is missing, ! check the requirement; criteria "
        "after the first - are not tested",
        head=("alternative", *(rules[name] for name in worked.chart.criteria), "decision", "remarks"),
        rows=tuple(rows),
    )
    near = tuple(f"Near miss: {one.sentence()}." for one in worked.near)
    if worked.verdict.winners == () and worked.chart.with_decision(Decision.ELIMINATE):
        near = (*near, "No alternative meets the requirements. The following chapters rate all of them.")
    return Chapter(anchor="elimination", title="Elimination", lines=near, tables=(table,))


def _pugh(worked: MatrixAnalysis) -> Chapter:
    result, sweep = worked.pugh, worked.sweep
    best, worst = (ends.tolist() for ends in result.rank_range)
    rows = []
    for place, name in enumerate(result.alternatives):
        marks = (Cell(text=str(sign), style=mark_style(str(sign)), word="mark") for sign in result.signs(name))
        counts = (number(str(count)) for count in result.counts(name).values())
        net = span(float(result.net_low[place]), float(result.net_high[place]))
        rows.append((*words(name), *marks, *counts, number(net), number(shown_rank(best[place], worst[place]))))
    against = Table(
        caption=f"Against {result.baseline}: better +, worse -, same S, unknown ?; the counts are the result, "
        "the net is optional",
        head=("alternative", *result.criteria, *(str(sign) for sign in Sign), "net (option)", "rank by net"),
        rows=tuple(rows),
    )
    wins = Table(
        caption="Number of criteria in which the row beats the column for all values of the intervals",
        head=("alternative", *sweep.alternatives),
        rows=tuple(
            (*words(name), *(number("" if name == other else str(count)) for other, count in zip(
                sweep.alternatives, row, strict=True)))
            for name, row in zip(sweep.alternatives, sweep.wins.tolist(), strict=True)
        ),
        note="Best net with each baseline: " + "; ".join(f"{one}: {', '.join(names)}" for one, names in
                                                       sweep.winners.items()),
    )  # fmt: skip
    lines = _lines(convergence_text(worked.convergence, worked.cycles))
    return Chapter(anchor="pugh", title="Pugh", lines=lines, tables=(against, wins))


def _kesselring(worked: MatrixAnalysis) -> Chapter:
    result = worked.overall
    top, best, worst = result.profile.p_max, *(ends.tolist() for ends in result.rank_range)
    rows = [
        (*words("weight as given"), *(number(f"{one:.4g}") for one in result.weights),
         number(f"{result.weight_sum:.4g}"), *words("", "")),
        (*words("weight normalised"), *(number(f"{one:.3f}") for one in result.normalised), number("1"),
         *words("", "")),
        (*words("ideal"), *(number(f"{top:g}") for _ in result.criteria), number(f"{result.ideal:.4g}"), number("1"),
         *words("")),
    ]  # fmt: skip
    for row, name in enumerate(result.alternatives):
        cells = []
        for column, criterion in enumerate(result.criteria):
            why = result.by_hand.get((name, criterion), "")
            text = span(float(result.low[row, column]), float(result.high[row, column])) + ("*" if why else "")
            style = shade(float(result.middle[row, column]), result.profile.p_min, top, scale=GOOD_IS_HIGH)
            shown = number(text, style=style, title=f"set by hand: {why}" if why else "")
            cells.append(replace(shown, link=f"#{trace_anchor(worked, name, criterion)}"))
        total = span(float(result.total_low[row]), float(result.total_high[row]))
        share = span(*(round(float(end[row]) / result.ideal, 3) for end in (result.total_low, result.total_high)))
        rows.append((*words(name), *cells, number(total), number(share), number(shown_rank(best[row], worst[row]))))
    table = Table(
        caption=f"Points on the scale {result.profile.p_min:g} to {top:g}, from value functions that do not depend on "
        "the other alternatives; ties share a rank (1 2 2 4)",
        head=("alternative", *result.criteria, "T", "T/T_max", "rank"), rows=tuple(rows), emphasised=frozenset({2}),
        note=result.warning,
    )  # fmt: skip
    spots = tuple(
        f"Weak spot: {one.alternative} gets at most {one.points:g} for {one.criterion!r}, although T/T_max = "
        f"{one.share:.2f}." for one in result.weak_spots
    )  # fmt: skip
    hand = tuple(f"* Set by hand: {name}, {what!r}: {why}." for (name, what), why in result.by_hand.items())
    out = (f"Eliminated by a requirement, not rated: {', '.join(worked.eliminated)}.",) if worked.eliminated else ()
    return Chapter(anchor="kesselring", title="Kesselring", lines=(*out, *spots, *hand), tables=(table,),
                   picture="profile")  # fmt: skip


def _strength(worked: MatrixAnalysis) -> tuple[Chapter, ...]:
    found = worked.strength
    if found is None:
        return ()
    rows = tuple(
        (*words(name), *(number(f"{one[row]:.3f}") for one in (found.technical.value, found.economic.value,
         found.arithmetic, found.hyperbolic)), *words(word))
        for row, (name, word) in enumerate(zip(found.alternatives, found.grades(), strict=True))
    )  # fmt: skip
    table = Table(
        caption="Technical and economic rating (after VDI 2225)",
        head=("alternative", "x", "y", "(x+y)/2", "sqrt(x y)", "technically"), rows=rows,
    )  # fmt: skip
    return (Chapter(anchor="strength", title="Strength", tables=(table,), picture="strength"),)


def _sure(worked: MatrixAnalysis) -> Chapter:
    found = worked.acceptability
    together = found["together"]
    rows = tuple(
        (*words(name), *(number(f"{one.p_best[row]:.1%}") for one in found.values()),
         number(f"{together.mean_rank[row]:.2f}"), *(number(f"{one:.1%}") for one in together.shares[row].tolist()))
        for row, name in enumerate(together.alternatives)
    )  # fmt: skip
    ranks = (f"rank {place + 1}" for place in range(len(together.alternatives)))
    table = Table(
        caption=f"Share of samples in which each is best or has each rank: {together.draws} Monte Carlo samples, seed "
        f"{together.seed}, of the values' intervals, points +-{together.uncertainty.scores:g}, weights "
        f"+-{together.uncertainty.weights:.0%}",
        head=("alternative", *(f"best: {name}" for name in found), "mean rank", *ranks), rows=rows,
    )  # fmt: skip
    flips = _lines(flips_text(worked.weight_flips, worked.score_flips, worked.common))
    tables = (table, _score_table(worked)) if worked.score_flips else (table,)
    return Chapter(anchor="sure", title="Confidence", lines=flips, tables=tables)


def _score_table(worked: MatrixAnalysis) -> Table:
    changes = {(one.alternative, one.criterion): one.change for one in worked.score_flips}
    result = worked.overall
    rows = tuple(
        (*words(name), *(number("" if change is None else f"{change:+.2f}") for change in (
            changes[name, criterion] for criterion in result.criteria)))
        for name in result.alternatives
    )  # fmt: skip
    return Table(
        caption="Change of points of one cell alone that makes another alternative win; empty where no change within "
        "the scale does",
        head=("alternative", *result.criteria), rows=rows,
    )  # fmt: skip


def _ask(worked: MatrixAnalysis) -> Chapter:
    rows = tuple(
        (*words(one.sentence()), number(f"{one.p_change:.0%}"), number(f"{one.gain:.4f}")) for one in worked.missing
    )
    table = Table(
        caption="Missing values, the most useful first", rows=rows,
        head=("missing value", "changes the winner in", "gain in T/T_max"),
    )  # fmt: skip
    return Chapter(anchor="ask", title="Missing values", lines=() if rows else ("No value is missing.",),
                   tables=(table,) if rows else ())  # fmt: skip


def _changed(worked: MatrixAnalysis) -> Chapter:
    lines = worked.case.history or (
        "No change is noted. torquerig matrix FILE --before OLD shows the effect of an edit.",
    )
    return Chapter(anchor="history", title="Earlier changes", lines=lines)


def _findings(worked: MatrixAnalysis) -> Chapter:
    rows = tuple(words(one.lint, one.table, one.what, one.why, one.remedy) for one in worked.findings)
    table = Table(caption="Errors of the tables", head=("check", "table", "error", "reason", "remedy"), rows=rows)
    return Chapter(anchor="lints", title="Errors", lines=() if rows else ("No error found.",),
                   tables=(table,) if rows else ())  # fmt: skip


def _traces(worked: MatrixAnalysis) -> Chapter:
    tables = tuple(
        Table(caption=f"{one.alternative}: {one.criterion}", head=("step", "value"),
              rows=tuple(words(label, text) for label, text in one.steps))
        for one in all_traces(worked)
    )  # fmt: skip
    return Chapter(anchor="trace", title="Every cell from the catalog to the verdict", tables=tables)


def _lines(text: str) -> tuple[str, ...]:
    """Return the sentences of a plain text whose continuation lines are indented."""
    joined: list[str] = []
    for line in text.splitlines():
        if line.startswith("  ") and joined:
            joined[-1] += f" {line.strip()}"
        else:
            joined.append(line)
    return tuple(joined)
