"""Changes of written recordings and scenarios: what a wrong data sheet or another unit does to the files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml

Tree = dict[str, Any]
Columns = dict[str, Any]


def _same_tree(tree: Tree) -> Tree:
    return tree


def _same_columns(columns: Columns, rate: float) -> Columns:
    return columns


@dataclass(frozen=True)
class Edit:
    """Functions that change the scenario, a sidecar and the columns of a table (with the true sample rate)."""

    scenario: Callable[[Tree], Tree] = _same_tree
    sidecar: Callable[[Tree], Tree] = _same_tree
    columns: Callable[[Columns, float], Columns] = _same_columns
    backwards: bool = False
    """Whether the files are given to the diagnosis in reverse order."""


def apply(edit: Edit, folder: Path) -> None:
    """Change the files of a case in place."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    scenario = folder / "scenario.yaml"
    _write(scenario, edit.scenario(_read(scenario)))
    for table in sorted(folder.glob("run*.parquet")):
        side = table.with_suffix(".yaml")
        facts = _read(side)
        columns = {name: np.asarray(column) for name, column in _columns(pq.read_table(table)).items()}
        changed = edit.columns(columns, float(facts["sample_rate_Hz"]))
        pq.write_table(pa.table({name: pa.array(values) for name, values in changed.items()}), table)
        _write(side, edit.sidecar(facts))


def _columns(table: Any) -> dict[str, Any]:
    return {name: table[name].to_numpy() for name in table.column_names}


def _read(path: Path) -> Tree:
    tree: Tree = yaml.safe_load(path.read_text(encoding="utf-8"))
    return tree


def _write(path: Path, tree: Tree) -> None:
    path.write_text(yaml.safe_dump(tree, sort_keys=False, width=160), encoding="utf-8")


def number_of(text: Any) -> float:
    """Return the number of a stated value: ``1.5 N*m``, a bare number, or a mapping with ``value``."""
    if isinstance(text, dict):
        return number_of(text["value"])
    return float(str(text).split()[0])


def times(stated: Any, factor: float) -> Any:
    """Return a stated value times a factor, with its unit and spread."""
    if isinstance(stated, dict) and "value" in stated:
        return stated | {"value": times(stated["value"], factor)}
    if isinstance(stated, str):
        number, *unit = stated.split()
        return " ".join([f"{float(number) * factor:.9g}", *unit])
    return float(f"{stated * factor:.9g}")
