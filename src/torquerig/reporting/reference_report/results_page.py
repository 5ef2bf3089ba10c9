"""The results of the reference report and of the simulated rig as one self-contained HTML page."""

from __future__ import annotations

from torquerig.reporting.html import html
from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.reference_report.results_figures import results_pictures
from torquerig.study.reference_report.cells import CellResult
from torquerig.study.reference_report.published import MECHANICAL_DROP
from torquerig.study.reference_report.reasons import cell_sentence, fit_sentences, mechanical_sentences, table_sentences
from torquerig.study.reference_report.results import ReportResults

HEAD = (
    "", "published %", "", "simulated %", "range of runs %", "difference", "without fit %", "placebo %",
    "mean change %", "energy change %", "lines N\u00a0m", "load N\u00a0m", "load needed N\u00a0m",
)  # fmt: skip


def reference_results_page(results: ReportResults) -> str:
    """Return the HTML of the page: with inline figures, without scripts or external requests."""
    content = {
        "title": results.rig.scenario.title,
        "fit": fit_sentences(results),
        "tables": tuple(_table(results, name) for name in ("VIII", "IX")),
        "cells": tuple(cell_sentence(one) for one in results.cells),
        "whole": table_sentences(results),
        "mechanical": mechanical_sentences(results.drop),
        "drop": _drop(results),
        "pictures": results_pictures(results),
        "seed": results.rig.seed,
    }
    return html("reference_results.html", content)


def _table(results: ReportResults, name: str) -> Table:
    shown = [one for one in results.cells if one.cell.table == name]
    where = (
        f"at {1e3 * results.rig.size:g} mm (not stated; the scenario's)"
        if name == "VIII"
        else f"at {results.fit.occupancy:g} % occupancy (not stated; fitted)"
    )
    return Table(
        caption=f"Table {name}: reduction of the standard deviation by the report's filter, {where}",
        head=HEAD,
        rows=tuple(_row(one) for one in shown),
        note="Range of runs: with different random numbers. Placebo: reduction by the same notches at orders without "
        "lines. Load needed: fluctuation in the reading that would give the published reduction.",
    )


def _row(one: CellResult) -> tuple[Cell, ...]:
    placebo = "-"
    if one.placebo is not None:
        placebo = f"{100 * min(one.placebo.std_cuts):.1f}..{100 * max(one.placebo.std_cuts):.1f}"
    energy = "?" if one.energy_change is None else f"{one.energy_change:+.4f}"
    return (
        *words(one.cell.shown),
        number(f"{one.cell.cut:g}"),
        Cell(text="fitted" if one.cell.fitted else "held out", word="name"),
        number(f"{one.cut:.1f}"),
        number(f"{one.lowest:.1f}..{one.highest:.1f}"),
        number(f"{one.difference:+.1f}"),
        number(f"{one.shipped_cut:.1f}"),
        number(placebo),
        number(f"{one.mean_change + 0.0:.4f}"),
        number(energy),
        number(f"{one.lines:.3f}"),
        number(f"{one.load:.3f}"),
        number("none" if one.needed is None else f"{one.needed:.3f}"),
    )


def _drop(results: ReportResults) -> Table:
    drop = results.drop
    row = (*words("output shaft, first line"), number(f"{MECHANICAL_DROP:g}"), *words("held out"),
           number(f"{drop.percent:.1f}"), number(f"{drop.by_model:.1f}"), number(f"{drop.low:.4f}"),
           number(f"{drop.high:.4f}"), number(f"{drop.floor:.4f}"))  # fmt: skip
    return Table(
        caption="Drop of mechanical noise with load",
        head=(
            "",
            "published %",
            "",
            "in the reading %",
            "line of the model %",
            "low N m",
            "high N m",
            "noise floor N m",
        ),
        rows=(row,),
    )
