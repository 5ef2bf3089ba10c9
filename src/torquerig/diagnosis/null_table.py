"""What gain must an effect show on this scenario? Thresholds from rigs with nothing hidden, where they were made."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.document import read_document
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario

SHIPPED = Path(__file__).with_name("null_tables.yaml")


@dataclass(frozen=True, kw_only=True)
class NullTable:
    """Thresholds of one scenario.

    Parameters
    ----------
    key : str
        Of the scenario's content.
    made_by : str
        The command that made it.
    seeds : tuple of int
        Whose rigs it was made from; no score may be quoted of these.
    clean_rigs : int
        With nothing hidden.
    chance : float
        With which a further such rig exceeds a threshold, for each mechanism [1].
    thresholds : mapping of str to float
        Least gain by mechanism; a mechanism that is not in it never came near on any of the rigs.
    """

    key: str
    made_by: str
    seeds: tuple[int, ...]
    clean_rigs: int
    chance: float
    thresholds: Mapping[str, float] = field(default_factory=dict)

    def least_gain(self, mechanism: str, *, built_in: float) -> float:
        """Return the gain below which ``mechanism`` is not called missing, never less than the built-in one."""
        return max(built_in, self.thresholds.get(mechanism, built_in))


def null_table(scenario: Scenario, path: Path = SHIPPED) -> NullTable | None:
    """Return the table that was made for the content of ``scenario``, or None where there is none."""
    return _tables(path).get(content_key(scenario))


def without_table(scenario: Scenario) -> str:
    """Return what a diagnosis says where no table was made for its scenario."""
    return (
        "The detection thresholds are the built-in ones, because no fault-free rigs were simulated for this scenario "
        f"(content {content_key(scenario)[:12]})."
    )


def content_key(scenario: Scenario) -> str:
    """Return the SHA-256 of what a scenario means: parts, values, what of them is uncertain, what is measured.

    Title, comments and operating point do not count, nor values left at their defaults, nor those that were drawn from
    an interval for want of a stated one (these change with the seed).
    """
    parts = [(type(part).__name__, _stated(part, scenario.assumed)) for part in scenario.rig.parts]
    spreads = {
        name: replace(known, value=None) if name in scenario.assumed else known
        for name, known in scenario.uncertainties.items()
    }
    said = _plain((parts, scenario.rig.measured, spreads))
    return hashlib.sha256(repr(said).encode()).hexdigest()


def _stated(part: Part, assumed: Iterable[str]) -> dict[str, Any]:
    """Return the values that are not the defaults, so that a new field of a part leaves the key as it is."""
    drawn = {".".join(name.split(".")[:length]) for name in assumed for length in range(2, name.count(".") + 2)}
    values = {each.name: _plain(getattr(part, each.name)) for each in fields(part)}
    defaults = {each.name: _plain(each.default) for each in fields(part)}
    return {
        name: "drawn" if f"{part.name}.{name}" in drawn else value
        for name, value in values.items()
        if value != defaults[name]
    }


@cache
def _tables(path: Path) -> dict[str, NullTable]:
    if not path.is_file():
        return {}
    rows = read_document(path).data.get("tables") or []
    tables = [
        NullTable(
            key=row["scenario"], made_by=row["made_by"], seeds=tuple(row["seeds"]), clean_rigs=row["clean_rigs"],
            chance=float(row["chance"]), thresholds={name: float(gain) for name, gain in row["thresholds"].items()},
        )
        for row in rows
    ]  # fmt: skip
    return {table.key: table for table in tables}


def _plain(value: Any) -> Any:
    """Return nested tuples whose text is the same for equal contents."""
    if isinstance(value, dict):
        return tuple((str(key), _plain(value[key])) for key in sorted(value, key=str))
    if isinstance(value, list | tuple):
        return tuple(_plain(each) for each in value)
    if isinstance(value, np.ndarray):
        return (value.shape, hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest())
    if is_dataclass(value) and not isinstance(value, type):
        return (type(value).__name__, *((each.name, _plain(getattr(value, each.name))) for each in fields(value)))
    if isinstance(value, float | np.floating):
        return float(f"{float(value):.12g}")
    return value
