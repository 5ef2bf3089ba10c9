"""Tables and timetables of MATLAB, through mat-io where it is installed.

mat-io reads with compiled code, which a damaged file can bring down; it runs in a process of its own.
"""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.recordings.files.child_reading import ChildError, read_in_child, run_child
from torquerig.recordings.files.matlab.tree import EXPORTS, Node, Unread, Variables, numbers

_MODULE = "torquerig.recordings.files.matlab.tables"
_UNITS = ("VariableUnits", "varUnits")


def with_tables(variables: Variables, path: Path) -> Variables:
    """Return the variables with each table and timetable as a struct of its columns.

    Without mat-io they stay unread, with the reason; so does one that mat-io cannot read.
    """
    wanted = {
        name: node.kind for name, node in variables.items()
        if isinstance(node, Unread) and node.kind in ("table", "timetable")
    }  # fmt: skip
    if not wanted or find_spec("matio") is None:
        return variables
    read = _in_child(path, list(wanted))
    failed: dict[str, Node] = {
        name: Unread(f"a MATLAB {kind} that mat-io cannot read; {EXPORTS[kind]}", kind=kind)
        for name, kind in wanted.items()
    }
    return {**variables, **failed, **read}


def _in_child(path: Path, names: list[str]) -> dict[str, Node]:
    """Return the tables ``names`` as structs."""
    try:
        index, arrays = read_in_child(_MODULE, path, *names)
    except ChildError:
        return {}
    found: dict[str, dict[str, Node]] = {}
    for (table, column, unit), array in zip(index, arrays, strict=True):
        is_number = array.dtype.kind in "fiub"
        found.setdefault(table, {})[column] = (
            replace(numbers(array), unit=unit) if is_number else Unread("words or objects")
        )
    return {name: [columns] for name, columns in found.items()}


def _read(path: str, *names: str) -> list[tuple[Any, Any]]:
    """Return the columns of the tables ``names``, each with table, name and unit."""
    import matio

    content = matio.load_from_mat(path, variable_names=list(names), add_table_attrs=True)
    return [((name, column, unit), values) for name in names for column, values, unit in _columns(content.get(name))]


def _columns(table: Any) -> list[tuple[str, Any, str]]:
    """Return name, numbers and unit of each column of a DataFrame; the times of a timetable in seconds."""
    import pandas as pd

    if not isinstance(table, pd.DataFrame):
        return []
    units = next((list(table.attrs[key]) for key in _UNITS if len(table.attrs.get(key, []))), [])
    found = [_column("time_s", table.index.to_series(), "s")] if _is_time(table.index) else []
    for order, name in enumerate(table.columns):
        unit = np.asarray(units[order]).astype(str).ravel() if order < len(units) else np.array([""])
        found.append(_column(str(name), table[name], str(unit[0]) if unit.size else ""))
    return found


def _is_time(index: Any) -> bool:
    return index.dtype.kind in "mM"


def _column(name: str, series: Any, unit: str) -> tuple[str, Any, str]:
    kind = series.dtype.kind
    if kind in "mM":
        steps = (series - series.iloc[0] if len(series) else series).to_numpy()
        return name, steps.astype("timedelta64[ns]").astype(np.int64) * 1e-9, "s"
    values = series.to_numpy()
    return (name, values, unit) if values.dtype.kind in "fiub" else (name, np.array("words"), "")


if __name__ == "__main__":
    run_child(_read)
