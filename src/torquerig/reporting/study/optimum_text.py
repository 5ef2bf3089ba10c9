"""The result of an optimisation as text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from torquerig.plain_table import grid

if TYPE_CHECKING:
    from torquerig.study.optimisation.tried import Tried


def optimum_text(best: Sequence[Tried], by_rule: Sequence[Tried], *, unit: str) -> str:
    """Return what to set for the least reading error, and the least for use while the rig runs."""
    first, shown = best[0], unit.replace("*", " ")
    filtering = first.set_filter
    same = [one for one in by_rule if (one.drive, one.filtering) == (first.drive, first.filtering)]
    now = f"; the study's rule gives {same[0].error:.4g} {shown}" if same else ""
    text = (
        f"The least reading error is {first.error:.4g} {shown}: {first.drive} with the filter {filtering}, speed "
        f"loop with a crossover of {first.crossover:.3g} Hz and an integral corner of {first.integral_corner:.2g} "
        f"Hz{now}."
    )
    live = next((one for one in best if one.delay is not None), None)
    if live is None or live is first:
        return text
    return (
        f"{text} While the rig runs, {live.set_filter} on {live.drive} reads within {live.error:.4g} {shown}, "
        f"{1000 * (live.delay or 0):.3g} ms late."
    )


def front_text(best: Sequence[Tried], *, unit: str) -> str:
    """Return the choices that no other beats, as a table."""
    rows = [["drive", "filter", "crossover Hz", "corner Hz", f"error {unit.replace('*', ' ')}", "delay ms", "price EUR",
             "margin"]]  # fmt: skip
    rows += [
        [
            one.drive, one.set_filter, f"{one.crossover:.3g}", f"{one.integral_corner:.2g}", f"{one.error:.4f}",
            "whole recording" if one.delay is None else f"{1000 * one.delay:.3g}",
            "?" if one.price is None else f"{one.price:.0f}", f"{one.margin:.2f}",
        ]
        for one in best
    ]  # fmt: skip
    return grid(rows)
