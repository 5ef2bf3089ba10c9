"""The result of ``torquerig batch``: one row per file, with the figures that its JSON document holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from torquerig.reporting.json_results.values import Missing

_LINES = 3  # strongest lines of a recording in its row; all are in the JSON


@dataclass(frozen=True)
class BatchRow:
    """One file: computed, taken over or failed with the reason; its figures by name with unit."""

    file: str
    status: str
    reason: str
    json: str
    figures: Mapping[str, float | int | str | Missing]


@dataclass(frozen=True)
class BatchResult:
    """All files of a folder, and the table that was written."""

    command: str
    folder: str
    rows: tuple[BatchRow, ...]
    written: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class FileOutcome:
    """The outcome of one file.

    Parameters
    ----------
    file : Path
    status : str
        ``computed``, ``taken over`` from an earlier call, or ``failed``.
    reason : str
        Why it failed, in one sentence; empty where it did not.
    json : str
        Name of the JSON file next to it.
    figures : mapping
        The figures of its row by column, with the unit in the name of the column.
    """

    file: Path
    status: str
    reason: str = ""
    json: str = ""
    figures: Mapping[str, Any] = field(default_factory=dict)


def batch_result(command: str, folder: Path, outcomes: Sequence[FileOutcome], *, table: Path) -> BatchResult:
    """Return the result; whether a file was computed now or taken over does not change it."""
    rows = []
    for one in outcomes:
        figures = {key: Missing("see the JSON of the file") if value is None else value
                   for key, value in one.figures.items()}  # fmt: skip
        rows.append(BatchRow(one.file.name, "failed" if one.reason else "done", one.reason, one.json, figures))
    return BatchResult(command, folder.name, tuple(rows), (table.name,))


def problem_of(document: Mapping[str, Any]) -> str:
    """Return why the file of a document cannot be used; empty where it can."""
    recordings = document.get("recordings", ())
    return str(recordings[0]["problem"]) if recordings else ""


def figures_of(command: str, document: Mapping[str, Any]) -> dict[str, Any]:
    """Return the figures of a row from the document of ``filter``, ``ordermap`` or ``info``."""
    made = {"filter": _of_filter, "ordermap": _of_ordermap, "info": _of_info}[command](document)
    return {name: value for name, value in made.items() if value is not None}


def _of_info(document: Mapping[str, Any]) -> dict[str, Any]:
    one = document["recordings"][0]
    row = {
        "sample rate [Hz]": one["sample_rate_Hz"], "duration [s]": one["duration_s"],
        "motor speed [rpm]": one["motor_speed_rpm"], "suspicions": len(one["suspicions"]),
        "first suspicion": next(iter(one["suspicions"]), ""),
    }  # fmt: skip
    for column in one["columns"]:
        for level in ("minimum", "mean", "maximum", "std"):
            row[f"{column['name']} {level} [{column['unit'] or '?'}]"] = column[level]
    return row


def _of_ordermap(document: Mapping[str, Any]) -> dict[str, Any]:
    low, high = document["speed_rpm"] or (None, None)
    row = {
        "duration [s]": document["duration_s"], "speed from [rpm]": low, "speed to [rpm]": high,
        "lines": len(document["lines"]), "suspicions": len(document["suspicions"]),
    }  # fmt: skip
    strongest = sorted(document["lines"], key=lambda line: -line["amplitude"]["value"])[:_LINES]
    for place, line in enumerate(strongest, start=1):
        row[f"line {place} amplitude [{line['amplitude']['unit']}]"] = line["amplitude"]["value"]
        row[f"line {place} output order"] = line["output_order"]
        row[f"line {place} [Hz]"] = line["frequency_Hz"]
        row[f"line {place} cause"] = line["cause"]
    return row


def _of_filter(document: Mapping[str, Any]) -> dict[str, Any]:
    row = {f"{name} [{document[name]['unit']}]": document[name]["value"] for name in ("std", "mean")}
    for one in document["chains"]:
        chain, error = one["chain"], one["error_to_true_load"]
        row |= {
            f"{chain}: std [{one['std']['unit']}]": one["std"]["value"],
            f"{chain}: std cut [%]": one["std_cut_percent"],
            f"{chain}: mean change [%]": one["mean_change_percent"],
            f"{chain}: energy change [%]": one["energy_change_percent"],
            f"{chain}: error to the true load [{error['unit']}]": error["value"],
        }
    return row
