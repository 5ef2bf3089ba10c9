"""The file that states how each criterion of published tables is computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, model_validator

from torquerig.catalog.reading import Catalog
from torquerig.decide.matrix_io.matrix_table import Method, TableSet
from torquerig.decide.matrix_io.published_tables import read_tables
from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.metrics.motor_facts import FACT_UNITS
from torquerig.parameter import Parameter
from torquerig.study.criteria import UNITS
from torquerig.study.definition import Study, open_study
from torquerig.study.settings import Band

KNOWN_UNITS: Mapping[str, str] = {**UNITS, **FACT_UNITS}
"""Every metric of a study and every fact of the catalog, with its unit."""


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Reading(_Section):
    """One way to compute a published criterion: a metric, and a limit or a direction."""

    metric: str
    unit: str
    purpose: str
    min: float | None = None
    max: float | None = None
    better: Literal["more", "less", "band"] = "more"
    band: tuple[float, float] | None = None
    same_within: Band = Band()
    points: dict[float, float] | None = None

    @model_validator(mode="after")
    def _counted_in_its_unit(self) -> Reading:
        if self.metric not in KNOWN_UNITS:
            raise ValueError(f"{self.metric!r} is no metric; {did_you_mean(self.metric, KNOWN_UNITS)}")
        if self.unit != KNOWN_UNITS[self.metric]:
            counted = KNOWN_UNITS[self.metric]
            raise ValueError(
                f"{self.metric} has the unit {counted!r}, not {self.unit!r}; write the limits in {counted!r}"
            )
        if (self.better == "band") != (self.band is not None):
            raise ValueError("band: and better: band need each other; write both or neither")
        return self


class PlannedRow(Reading):
    """A published criterion, and another possible interpretation."""

    otherwise: Reading | None = None


class PlannedTable(_Section):
    """A published table: the gearbox of each motor, and the computation of each row.

    ``also`` adds motors that the table leaves out; ``missing`` is the criterion of the missing weight.
    """

    gearbox: str
    gearboxes: dict[str, str] = Field(default_factory=dict)
    also: tuple[str, ...] = ()
    rows: dict[str, PlannedRow]
    missing: dict[str, PlannedRow] = Field(default_factory=dict, max_length=1)

    def gearbox_of(self, motor: str) -> str:
        """Return the gearbox of a motor by its published name."""
        return self.gearboxes.get(motor, self.gearbox)


class PlanText(_Section):
    """A plan as a file states it."""

    published: str
    scenario: str
    tables: dict[str, PlannedTable] = Field(min_length=1)
    draws: int = Field(default=2, ge=0)
    duration: Annotated[float, Parameter("s", "length of a run", above=0)] = 6.0
    agree_within: float = Field(default=0.5, ge=0)


@dataclass(frozen=True, kw_only=True)
class Plan:
    """The plan with its published tables and the study that simulates their drives.

    Parameters
    ----------
    tables : mapping of str to PlannedTable
        By the published name.
    agree_within : float
        Points by which computed and published may differ and still agree.
    """

    document: Document
    book: TableSet
    study: Study
    tables: Mapping[str, PlannedTable]
    agree_within: float


def read_plan(document: Document, catalog: Catalog, *, draws: int | None = None) -> Plan:
    """Return the plan of a document, its tables, and its study with the motors of its Pugh and Kesselring tables.

    Raises
    ------
    InputError
        With file, line and key: an unknown table, row, motor or gearbox, or a row without a limit or points that its
        method needs.
    """
    text = validated(document, TypeAdapter(PlanText))
    folder = Path(document.path).parent
    book = read_tables(folder / text.published)
    study = open_study(read_document(folder / text.scenario), catalog)
    _check_tables(document, book, text.tables, catalog)
    simulated = [name for name in text.tables if book.table(name).method is not Method.ELIMINATION]
    motors = [study.settings.present.motor]
    motors += [name for table in simulated for name in (*book.table(table).alternatives, *text.tables[table].also)]
    real = dict.fromkeys(real_name(catalog, name) for name in motors)
    boxes = dict.fromkeys((study.present_gearbox, *(box for table in simulated for box in _boxes(text.tables[table]))))
    update = {"motors": tuple(real), "gearboxes": tuple(boxes), "duration": text.duration,
              "draws": text.draws if draws is None else draws}  # fmt: skip
    study = Study(study.document, study.settings.model_copy(update=update), catalog, study.filters)
    return Plan(document=document, book=book, study=study, tables=text.tables, agree_within=text.agree_within)


def real_name(catalog: Catalog, published: str) -> str:
    """Return the catalog name of a motor by its published name."""
    entry = catalog.motor(published)
    return entry.stands_for or entry.name


def _boxes(table: PlannedTable) -> tuple[str, ...]:
    return (table.gearbox, *table.gearboxes.values())


def _check_tables(document: Document, book: TableSet, tables: Mapping[str, PlannedTable], catalog: Catalog) -> None:
    known = [sheet.name for sheet in book.audited]
    for name, table in tables.items():
        here = ("tables", name)
        if name not in known:
            raise InputError(f"{document.place(here)}: unknown published table {name!r}; {did_you_mean(name, known)}")
        sheet = book.table(name)
        _look_up(document, (*here, "gearbox"), _boxes(table), catalog.gearbox)
        _look_up(document, (*here, "also"), (*sheet.alternatives, *table.also, *table.gearboxes), catalog.motor)
        printed = [row.criterion for row in sheet.rows]
        for row, planned in (*table.rows.items(), *table.missing.items()):
            place = document.place((*here, "rows", row))
            if row in table.rows and row not in printed:
                raise InputError(f"{place}: {name} has no row {row!r}; {did_you_mean(row, printed)}")
            _check_row(place, planned, sheet.method)
        lost = [row for row in printed if row not in table.rows]
        if lost:
            raise InputError(
                f"{document.place((*here, 'rows'))}: {lost[0]!r} of {name} is missing; state how to compute it"
            )


def _look_up(document: Document, keys: tuple[str, ...], names: tuple[str, ...], look_up: object) -> None:
    for name in names:
        try:
            look_up(name)  # type: ignore[operator]
        except UnknownNameError as error:
            raise UnknownNameError(f"{document.place(keys)}: {error}") from None


def _check_row(place: str, row: PlannedRow, method: Method) -> None:
    if method is Method.ELIMINATION and row.min is None and row.max is None:
        raise InputError(f"{place}: an elimination needs a limit; write min or max")
    if method is Method.KESSELRING and row.points is None:
        raise InputError(f"{place}: a rated criterion needs points; write points: {{value: points, ...}}")
