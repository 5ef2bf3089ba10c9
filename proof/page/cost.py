"""Time and memory of a diagnosis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from proof.prove.scored import Cost
from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def cost(costs: Sequence[Cost], *, workers: int, duration: float) -> Chapter:
    """Return median, 90 % quantile and largest of time and memory."""
    if not costs:
        return Chapter(anchor="cost", title="Cost", lines=("No diagnosis time was recorded.",))
    rows = (
        _row("wall time [s]", [one.seconds for one in costs]),
        _row("processor time [s]", [one.processor_seconds for one in costs]),
        _row("peak memory of the process [MiB]", [one.peak_MiB for one in costs]),
    )
    table = Table(
        caption=f"Time and memory of {len(costs)} diagnoses", head=("", "median", "90 % quantile", "largest"), rows=rows
    )
    lines = (
        (
            f"Each rig has four recordings of {duration:g} s at 25 kHz; {workers} rigs ran in parallel, with "
            "single-threaded linear algebra. Required: 60 s for recordings of 12 s on two cores, and less than 2 GiB. "
            "Memory is the peak of the worker process up to the end of the diagnosis."
        ),
    )
    return Chapter(anchor="cost", title="Cost", lines=lines, tables=(table,))


def _row(name: str, values: Sequence[float]) -> tuple[Cell, ...]:
    shown = (float(np.quantile(values, at)) for at in (0.5, 0.9, 1.0))
    return (*words(name), *(number(f"{value:.1f}") for value in shown))
