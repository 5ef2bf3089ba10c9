"""What ``torquerig filter`` prints: the effect of each chain, and what the recording is too short for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import hypot
from pathlib import Path

import click

from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.counted_periods import few_periods_text
from torquerig.filters.filter_effect import FilterEffect
from torquerig.filters.removed_lines import no_line_text
from torquerig.plain_table import fixed, grid, wrapped
from torquerig.recordings.recording import Recording

# rounding error of the mean of equal numbers
_ROUNDING = 1e-14
_HEAD = ("std cut %", "variance cut %", "mean change %", "energy change %")
_TOO_SHORT = (
    "the recording is too short for this chain, which takes slow load and mean along; take a longer recording, or a "
    "chain with wider bands or fewer lines"
)


def print_effects(
    path: Path, before: Recording, chains: Sequence[Chain], effects: Sequence[FilterEffect],
    errors: Sequence[float] | None, *, samples: int,
    ratio: float,
) -> None:  # fmt: skip
    """Print a table of the effects of some chains, the lines of each, and what the recording is too short for."""
    first, unit = effects[0], before.torque_unit()
    size = hypot(first.mean_before, first.std_before)

    def number(value: float) -> str:
        return fixed(value, scale=size, digits=6)

    if first.std_before <= _ROUNDING * abs(first.mean_before):
        click.echo(
            f"torquerig: warning: {path}: {before.torque_name()} is constant in all its {samples} samples; "
            "is the sensor connected?",
            err=True,
        )
    click.echo(f"{path}: std {number(first.std_before)} {unit}, mean {number(first.mean_before)} {unit}")
    rows = [_row(chain, effect, number) for chain, effect in zip(chains, effects, strict=True)]
    if errors is not None:
        rows = [[*row, number(error)] for row, error in zip(rows, errors, strict=True)]
    head = ["chain", f"std {unit}", *_HEAD, *([] if errors is None else [f"error to true load {unit}"])]
    click.echo(grid([head, *rows]) + "\n")
    for chain, effect in zip(chains, effects, strict=True):
        _print_families(chain, effect, number, unit=unit)
        if few := few_periods_text(chain.lines, effect.motor_turns, ratio=ratio):
            click.echo(wrapped(f"{chain.name}: {few}"))
        if none := no_line_text(chain, effect):
            click.echo(wrapped(f"{chain.name}: {none}"))
        if effect.moves_mean:
            change = f"from {number(effect.mean_before)} to {number(effect.mean_after)} {unit}"
            click.echo(f"torquerig: warning: {path}: {chain.name} changes the mean {change}; {_TOO_SHORT}", err=True)
    click.echo(f"speed for energy and lines: {first.speed_origin}")


def _row(chain: Chain, effect: FilterEffect, number: Callable[[float], str]) -> list[str]:
    energy = effect.energy_change_percent
    return [
        chain.name, number(effect.std_after), f"{effect.std_reduction_percent:.1f}",
        f"{effect.variance_reduction_percent:.1f}", f"{effect.mean_change_percent:.4f}",
        "-" if energy is None else f"{energy:.4f}",
    ]  # fmt: skip


def _print_families(chain: Chain, effect: FilterEffect, number: Callable[[float], str], *, unit: str) -> None:
    levels = effect.family_levels()
    if levels:
        rows = [[family, number(was), number(now)] for family, (was, now) in levels.items()]
        click.echo(grid([[f"{chain.name}: lines", f"before {unit}", f"after {unit}"], *rows]) + "\n")
    for reason in chain.left_out:
        click.echo(f"{chain.name}: not removed: {reason}")
