"""Torques that are given over time or over the angle, and load pulses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, pi, sin
from typing import NamedTuple

import numpy as np

from torquerig.recordings.recording import random_for
from torquerig.rig.terms import AngleLoad, AppliedTorque, BladeTorque, Load, Term, Wave
from torquerig.simulation.arrays import Floats, Rows, Starts
from torquerig.simulation.term_kinds.kind import (
    GROUND_ROW,
    UNFILLED,
    Lowering,
    Reversal,
    TermKind,
    floats,
    phase_of,
    starts,
    whole,
)


class Loads(NamedTuple):
    """Sampled torques, linear between samples: they oppose a node's motion, or drive it where the smoothing is 0."""

    on: Rows
    inverse_smoothing: Floats
    samples: Floats  # (loads, settling + samples + 1)


class AngleLoads(NamedTuple):
    """Torques over the angle; all grids one after the other, each with its first point once more at its end."""

    on: Rows
    inverse_smoothing: Floats
    points_per_radian: Floats
    first: Starts  # (angle loads + 1,)
    values: Floats


class Blades(NamedTuple):
    """Half-wave-squared load pulses from a slot."""

    on: Rows
    slot: Rows
    c: Floats
    s: Floats
    amplitude: Floats
    inverse_smoothing: Floats


class LoadKind(TermKind[Load | AppliedTorque, Loads]):
    """Loads and, behind them, applied torques."""

    field = "loads"
    made_from = (Load, AppliedTorque)
    deciding = ("inverse_smoothing",)

    def chosen(self, terms: Sequence[Term]) -> tuple[Load | AppliedTorque, ...]:
        """Return the loads first."""
        given = super().chosen(terms)
        return tuple(term for kind in self.made_from for term in given if isinstance(term, kind))

    def rows(self, terms: Sequence[Load | AppliedTorque], to: Lowering) -> Loads:
        """Return the torques over time, their samples still empty."""
        return Loads(
            on=whole(to.number[t.on] for t in terms),
            inverse_smoothing=floats(1 / t.smoothing if isinstance(t, Load) else 0.0 for t in terms),
            samples=UNFILLED,
        )

    def reversals(self, terms: Sequence[Load | AppliedTorque], rows: Loads) -> Iterator[Reversal]:
        """Yield the loads, once the run has filled their samples."""
        for row, term in enumerate(terms):
            if isinstance(term, Load):
                torque, smooth = float(np.abs(rows.samples[row]).max()), float(rows.inverse_smoothing[row])
                yield Reversal(int(rows.on[row]), GROUND_ROW, torque, smooth, f"the load {term.name!r}")


class AngleLoadKind(TermKind[AngleLoad, AngleLoads]):
    """Loads over the angle, drawn from the seed by their names."""

    field = "angle_loads"
    made_from = (AngleLoad,)
    deciding = ("inverse_smoothing",)

    def rows(self, terms: Sequence[AngleLoad], to: Lowering) -> AngleLoads:
        """Return the torques over the angle."""
        grids = [t.process.sample(random_for(to.seed, t.name)) for t in terms]
        closed = [np.append(grid, grid[:1]) for grid in grids]
        return AngleLoads(
            on=whole(to.number[t.on] for t in terms),
            inverse_smoothing=floats(1 / t.smoothing for t in terms),
            points_per_radian=floats(t.process.points_per_turn / (2 * pi) for t in terms),
            first=starts(grid.size for grid in closed),
            values=np.concatenate([*closed, np.zeros(0)]),
        )

    def reversals(self, terms: Sequence[AngleLoad], rows: AngleLoads) -> Iterator[Reversal]:
        """Yield the loads at the highest point of their grids."""
        for row, term in enumerate(terms):
            grid = rows.values[rows.first[row] : rows.first[row + 1]]
            torque, smooth = float(np.abs(grid).max()), float(rows.inverse_smoothing[row])
            yield Reversal(int(rows.on[row]), GROUND_ROW, torque, smooth, f"the load {term.name!r}")

    def refused(self, terms: Sequence[AngleLoad]) -> Iterator[tuple[str, str]]:
        """Yield all of them."""
        yield from ((term.name, "a load over the angle") for term in terms)

    def steady(self, terms: Sequence[AngleLoad], rows: AngleLoads, speeds: Floats) -> Iterator[tuple[int, float]]:
        """Yield their means."""
        for term, on, smooth in zip(terms, rows.on, rows.inverse_smoothing, strict=True):
            yield int(on), term.process.mean * np.tanh(speeds[on] * smooth)

    def left_out(self, terms: Sequence[AngleLoad], rows: AngleLoads) -> Iterator[str]:
        """Yield all but their means."""
        yield from (f"the load {term.name!r} over the angle but for its mean" for term in terms)


class BladeKind(TermKind[BladeTorque, Blades]):
    """Load pulses of blades that have a size."""

    field = "blades"
    made_from = (BladeTorque,)
    deciding = ("inverse_smoothing",)

    def chosen(self, terms: Sequence[Term]) -> tuple[BladeTorque, ...]:
        """Return the pulses that have a size."""
        return tuple(blade for blade in super().chosen(terms) if blade.amplitude)

    def orders(self, terms: Sequence[BladeTorque]) -> Iterator[tuple[str, float]]:
        """Yield one wave for each, which the kernel rectifies and squares."""
        yield from ((term.on, term.order) for term in terms)

    def rows(self, terms: Sequence[BladeTorque], to: Lowering) -> Blades:
        """Return the load pulses."""
        phases = [phase_of(t.name, Wave(order=t.order, amplitude=1.0, phase=t.phase), to.seed) for t in terms]
        return Blades(
            on=whole(to.number[t.on] for t in terms),
            slot=whole(to.table.slots[(to.number[t.on], t.order)] for t in terms),
            c=floats(cos(phase) for phase in phases),
            s=floats(sin(phase) for phase in phases),
            amplitude=floats(t.amplitude for t in terms),
            inverse_smoothing=floats(0.0 if t.one_way else 1 / t.smoothing for t in terms),
        )


LOADS, ANGLE_LOADS, BLADES = LoadKind(), AngleLoadKind(), BladeKind()
