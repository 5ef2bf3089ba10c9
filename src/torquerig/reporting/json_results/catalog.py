"""The results of ``torquerig catalog``: the lists, all values of one entry, and the check of entries."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

from torquerig.catalog.checking.entry_check import EntryCheck
from torquerig.catalog.entry import Entry, estimates
from torquerig.catalog.motor import Motor
from torquerig.catalog.part_class import PartClass
from torquerig.catalog.reading import Catalog
from torquerig.parameter import Estimate
from torquerig.reporting.json_results.values import Missing, known


@dataclass(frozen=True)
class KnownValue:
    """A value of an entry in SI: nominal value and interval, evidence and source."""

    name: str
    value: float | Missing
    low: float | Missing
    high: float | Missing
    choices: tuple[float, ...]
    unit: str
    evidence: str
    source: str
    note: str


@dataclass(frozen=True)
class CatalogEntry:
    """A motor, gearbox, sensor, coupling or class, with all values that have a source."""

    name: str
    of: str
    title: str
    notes: tuple[str, ...]
    values: tuple[KnownValue, ...]


@dataclass(frozen=True)
class CatalogListResult:
    """All entries of the catalog."""

    entries: tuple[CatalogEntry, ...]


@dataclass(frozen=True)
class CatalogShowResult:
    """One entry of the catalog; ``resolved`` is its name where an alias was given."""

    resolved: str
    entry: CatalogEntry


@dataclass(frozen=True)
class OpenCost:
    """An open value, and the figure that it widens."""

    value: str
    known: str
    evidence: str
    figure: str
    needed_for: str
    ratio: float | Missing


@dataclass(frozen=True)
class CheckedEntry:
    """The check of one catalog file."""

    path: str
    name: str
    title: str
    problem: str
    contradictions: tuple[str, ...]
    open_values: tuple[OpenCost, ...]


@dataclass(frozen=True)
class CatalogCheckResult:
    """The check of catalog files; ``faulty`` counts those with contradictions or errors."""

    checked: int
    faulty: int
    entries: tuple[CheckedEntry, ...]


def catalog_list_result(catalog: Catalog) -> CatalogListResult:
    """Return all entries of a catalog."""
    shelves: Mapping[str, Mapping[str, Entry]] = {
        "motor": catalog.motors, "gearbox": catalog.gearboxes, "sensor": catalog.sensors,
        "coupling": catalog.couplings,
    }  # fmt: skip
    entries = [entry_result(one, of) for of, shelf in shelves.items() for one in shelf.values()]
    return CatalogListResult((*entries, *(class_result(one) for one in catalog.classes.values())))


def entry_result(entry: Entry, of: str) -> CatalogEntry:
    """Return an entry with all its values."""
    notes = tuple(entry.warnings) if isinstance(entry, Motor) else ()
    return CatalogEntry(entry.name, of, entry.title, notes, _values(estimates(entry)))


def class_result(part: PartClass) -> CatalogEntry:
    """Return a class with the values that it fills."""
    return CatalogEntry(part.name, f"class of {part.of}", part.title, (), _values(part.known().items()))


def check_result(checks: Sequence[EntryCheck]) -> CatalogCheckResult:
    """Return the checks of some catalog files."""
    entries = tuple(
        CheckedEntry(
            path=one.path.as_posix(), name=one.name, title=one.title, problem=one.problem,
            contradictions=one.contradictions,
            open_values=tuple(
                OpenCost(
                    cost.field, cost.known, cost.evidence, cost.figure, cost.decides,
                    cost.ratio if isfinite(cost.ratio) else Missing("the figure stays open"),
                )
                for cost in one.costs
            ),
        )
        for one in checks
    )  # fmt: skip
    return CatalogCheckResult(len(checks), sum(bool(one.problem or one.contradictions) for one in checks), entries)


def _values(found: Iterable[tuple[str, Estimate]]) -> tuple[KnownValue, ...]:
    return tuple(_value(name, one) for name, one in found if one.source)


def _value(name: str, one: Estimate) -> KnownValue:
    low, high = one.bounds
    value = "only its interval is known" if one.low is not None else "the maker does not state it"
    return KnownValue(
        name, known(one.value, value), known(low, "nothing is known"), known(high, "nothing is known"), one.choices,
        one.unit, one.evidence, one.source, one.note,
    )  # fmt: skip
