"""Which open values matter, as text: what to ask the makers first."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.plain_table import grid

if TYPE_CHECKING:
    from torquerig.study.monte_carlo.design import Design
    from torquerig.study.monte_carlo.sensitivity import Sensitivity

SHOWN = 15  # rows of a table
RARE = 0.01  # [1] share of the base points below which a value is not called decisive


def asked_first_text(found: Sensitivity, *, unit: str) -> str:
    """Return what to ask first, in one or two sentences."""
    if found.decisive:
        first = found.decisive[0]
        if first.share < RARE:
            return (
                f"No open value alone changes which drive is best (in less than {RARE:.0%} of {found.points} points)."
            )
        money = "" if first.price is None else f"; the two drives differ by {first.price:.0f} EUR on average"
        return (
            f"Ask for {spoken(first.name)} first: alone it changes which drive is best in {first.share:.0%} of "
            f"{found.points} points{money}."
        )
    if not found.effects:
        return "No open value changes the reading error."
    most = found.effects[0]
    if most.error <= most.total_reach:
        return "No effect of an open value on the reading error is larger than its uncertainty yet: take more draws."
    return (
        f"Ask for {spoken(most.name)} first: over its range it changes the reading error of {most.drive} by "
        f"{most.error:.3g} {unit.replace('*', ' ')}."
    )


def too_few_text(found: Sensitivity) -> str:
    """Return a warning where the points are too few for the largest effect; empty where they are enough."""
    if not found.effects:
        return ""
    most = found.effects[0]
    size = most.error if most.total is None else most.total
    if most.total_reach <= 0.5 * size:
        return ""
    return f"{found.points} points are too few: the largest effect is uncertain by {most.total_reach / size:.0%}."


def effects_text(found: Sensitivity, design: Design, *, unit: str) -> str:
    """Return the largest effects on the reading error as a table."""
    shown = unit.replace("*", " ")
    if design.method == "sobol":
        rows = [["drive", "open value", f"error {shown}", "total index", "+-", "alone"]]
        rows += [[one.drive, spoken(one.name), f"{one.error:.4f}", f"{one.total or 0:.2f}",
                  f"{one.total_reach:.2f}", f"{one.first or 0:.2f}"] for one in found.effects[:SHOWN]]  # fmt: skip
    else:
        rows = [["drive", "open value", f"error {shown} over the range", "+-"]]
        rows += [[one.drive, spoken(one.name), f"{one.error:.4f}", f"{one.total_reach:.4f}"]
                 for one in found.effects[:SHOWN]]  # fmt: skip
    return grid(rows)


def decisive_text(found: Sensitivity) -> str:
    """Return the decisive values as a table; empty for none."""
    listed = [one for one in found.decisive if one.share >= RARE][:SHOWN]
    rows = [["open value", "changes the best drive %", "price difference EUR"]]
    rows += [[spoken(one.name), f"{100 * one.share:.1f}", "-" if one.price is None else f"{one.price:.0f}"]
             for one in listed]  # fmt: skip
    return grid(rows) if listed else ""


def spoken(name: str) -> str:
    """Return ``HDS6A-0104A.ripple.cogging_native`` as ``ripple cogging native of HDS6A-0104A``."""
    entry, _, field = name.partition(".")
    return f"{field.replace('_', ' ').replace('.', ' ')} of {entry}"
