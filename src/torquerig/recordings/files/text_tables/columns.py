"""Which columns of a text table are read: numbers, one column of time stamps; the others with the reason."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.recordings.files.text_tables.layout import EMPTY, NUMBER, STAMP, UNNAMED, WORDS, Layout
from torquerig.recordings.files.text_tables.stamp_parts import StampForm
from torquerig.recordings.files.text_tables.stamps import stamp_form
from torquerig.recordings.files.text_tables.written_dates import is_written_date, with_signs
from torquerig.recordings.names.time_column import time_column

# characters of an example in a message
_EXAMPLE = 30


@dataclass(frozen=True, kw_only=True)
class StampColumn:
    """The column of times that time stamps give: its name, and the columns that hold them (one, or date and clock)."""

    name: str
    columns: tuple[str, ...]
    forms: tuple[StampForm, ...]


@dataclass(frozen=True, kw_only=True)
class ColumnPlan:
    """The columns of numbers by name, the column of time stamps, and those not read with the reason."""

    numbers: tuple[str, ...]
    stamps: StampColumn | None
    skipped: dict[str, str]
    notes: tuple[str, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all columns that are read; the time stamps first."""
        return ((self.stamps.name,) if self.stamps else ()) + self.numbers


def plan_columns(layout: Layout) -> ColumnPlan:
    """Return which columns are read; time stamps become times only where no column of numbers holds the time."""
    numbers = tuple(name for name in layout.of_family(NUMBER) if not name.startswith(UNNAMED))
    words = [name for name in layout.of_family(WORDS) if not name.startswith(UNNAMED) or any(layout.column(name))]
    skipped = {name: f"words, for example {_example(layout, name)}" for name in words}
    skipped |= {name: "is empty" for name in layout.of_family(EMPTY) if not name.startswith(UNNAMED)}
    skipped |= {name: "has no name" for name in layout.of_family(NUMBER) if name.startswith(UNNAMED)}
    time = time_column(numbers, layout.units)
    stamps = None
    if time is not None and _are_written_dates(layout, time.name):
        stamps = _of_one_number(layout, time.name)
        numbers = tuple(name for name in numbers if name != time.name)
        reasons = dict.fromkeys(layout.of_family(STAMP), f"time stamps; the column {time.name} holds the time")
    elif time is None:
        stamps, reasons = _stamp_column(layout, numbers)
    else:
        reasons = dict.fromkeys(layout.of_family(STAMP), f"time stamps; the column {time.name} holds the time")
    notes = () if stamps is None else (_note(stamps),)
    return ColumnPlan(numbers=numbers, stamps=stamps, skipped=skipped | reasons, notes=notes)


def _are_written_dates(layout: Layout, name: str) -> bool:
    cells = [cell for cell in layout.column(name) if cell]
    return len(cells) > 1 and all(is_written_date(cell) for cell in cells)


def _of_one_number(layout: Layout, name: str) -> StampColumn:
    form = stamp_form([with_signs(cell) for cell in layout.column(name) if cell])
    return StampColumn(name=name, columns=(name,), forms=() if form is None else (form,))


def _stamp_column(layout: Layout, numbers: Sequence[str]) -> tuple[StampColumn | None, dict[str, str]]:
    forms, reasons = {}, {}
    for name in layout.of_family(STAMP):
        cells = [cell for cell in layout.column(name) if cell]
        form = stamp_form(cells)
        if form is None:
            reasons[name] = f"its time stamps have no clear form, for example {_example(layout, name)}"
        elif form.has_clock and len(cells) > 1 and len(set(cells)) == 1:
            reasons[name] = f"the same time stamp in all rows, {cells[0]}"
        else:
            forms[name] = form
    clocks = [name for name, form in forms.items() if form.has_clock]
    dates = [name for name, form in forms.items() if not form.has_clock]
    if not clocks:
        reasons |= dict.fromkeys(dates, "dates without a time of day")
        return None, reasons
    chosen = next((name for name in clocks if forms[name].has_date), clocks[0])
    used = (chosen,) if forms[chosen].has_date or not dates else (dates[0], chosen)
    reasons |= {name: f"time stamps; the column {chosen} holds the time" for name in forms if name not in used}
    is_time = time_column([chosen], {chosen: "s"}) is not None
    name = chosen if is_time or "time_s" in numbers else "time_s"
    return StampColumn(name=name, columns=used, forms=tuple(forms[one] for one in used)), reasons


def _note(stamps: StampColumn) -> str:
    words = " and ".join(form.words for form in stamps.forms)
    called = "" if stamps.name == stamps.columns[-1] else f", and are called {stamps.name}"
    columns = " and ".join(name for name in stamps.columns if not name.startswith(UNNAMED))
    return f"the time stamps of the column {columns} ({words}) are read as seconds from the first one{called}"


def _example(layout: Layout, name: str) -> str:
    cell = next((cell for cell in layout.column(name) if cell), "")
    return repr(cell if len(cell) <= _EXAMPLE else f"{cell[:_EXAMPLE]}...")
