"""Springs between shafts, with their gaps, losses, errors and the stiffness that varies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from torquerig.errors import InputError
from torquerig.rig.terms import Spring, Term
from torquerig.simulation.arrays import Floats, Rows, Starts
from torquerig.simulation.term_kinds.kind import Link, Lowering, Phased, TermKind, floats, phased, sounding, whole


class Springs(NamedTuple):
    """Springs, dampers, gaps, gears; ``e`` rows are the kinematic error's waves."""

    a: Rows
    b: Rows
    stiffness: Floats
    damping: Floats
    half_gap: Floats
    rest: Floats
    inverse_ratio: Floats
    loss_forward: Floats  # 1/eta - 1: of the torque on a, while power flows from a to b
    loss_backward: Floats  # 1 - eta_b: the same while it flows back
    inverse_smoothing: Floats
    e_first: Starts  # (springs + 1,) where each spring's error waves start
    e_slot: Rows
    e_order: Floats
    e_cos: Floats
    e_sin: Floats
    swing: Floats  # by how much of its mean the stiffness can vary at most [1]; the kernel reads Varied instead


class Varied(NamedTuple):
    """Springs whose stiffness has waves, relative to its mean."""

    spring: Rows
    damping_follows: Rows  # 1 where the damping varies alike
    first: Starts
    slot: Rows
    order: Floats
    c: Floats
    s: Floats


class SpringKind(TermKind[Spring, Springs]):
    """Springs with the waves of their kinematic errors."""

    field = "springs"
    made_from = (Spring,)
    deciding = ("half_gap",)

    def chosen(self, terms: Sequence[Term]) -> tuple[Spring, ...]:
        """Return all springs, with the waves that have a size."""
        return tuple(sounding(spring, "error", "stiffness_waves") for spring in super().chosen(terms))

    def orders(self, terms: Sequence[Spring]) -> Iterator[tuple[str, float]]:
        """Yield the waves of error and stiffness, of the output side's angle."""
        yield from ((s.b, wave.order) for s in terms for wave in (*s.error, *s.stiffness_waves))

    def rows(self, terms: Sequence[Spring], to: Lowering) -> Springs:
        """Return the springs."""
        number = to.number
        errors = phased([(s.name, number[s.b], s.error) for s in terms], to.table, to.seed)
        return Springs(
            a=whole(number[s.a] for s in terms),
            b=whole(number[s.b] for s in terms),
            stiffness=floats(s.stiffness for s in terms),
            damping=floats(s.damping for s in terms),
            half_gap=floats(0.5 * s.gap for s in terms),
            rest=floats(s.rest for s in terms),
            inverse_ratio=floats(1 / s.ratio for s in terms),
            loss_forward=floats(1 / s.efficiency - 1 for s in terms),
            loss_backward=floats(1 - s.backwards for s in terms),
            inverse_smoothing=floats(1 / s.smoothing for s in terms),
            e_first=errors.first,
            e_slot=errors.slot,
            e_order=errors.order,
            e_cos=errors.c,
            e_sin=errors.s,
            swing=floats(_swing(spring, to) for spring in terms),
        )

    def refused(self, terms: Sequence[Spring]) -> Iterator[tuple[str, str]]:
        """Yield each spring whose zero is not at equal angles."""
        yield from ((spring.name, "a rest angle") for spring in terms if spring.rest)

    def links(self, rows: Springs, *, stiffest: bool) -> Iterator[Link]:
        """Yield the springs with gaps closed and without losses; at their highest stiffness where wanted."""
        stiffness = rows.stiffness * (1 + rows.swing) if stiffest else rows.stiffness
        for row in zip(rows.a, rows.b, stiffness, rows.damping, rows.inverse_ratio, strict=True):
            yield Link(*row)


def _swing(spring: Spring, to: Lowering) -> float:
    """Return by how much of its mean the stiffness of a spring can vary at most [1]."""
    if not spring.stiffness_waves:
        return 0.0
    waves = _stiffness_waves([spring], to)
    return float(np.hypot(waves.c, waves.s).sum())


def _stiffness_waves(springs: Sequence[Spring], to: Lowering) -> Phased:
    owners = [(f"{spring.name}.stiffness", to.number[spring.b], spring.stiffness_waves) for spring in springs]
    return phased(owners, to.table, to.seed)


class VariedKind(TermKind[Spring, Varied]):
    """What of the springs varies with the angle of the output side."""

    field = "varied"
    made_from = (Spring,)

    def chosen(self, terms: Sequence[Term]) -> tuple[Spring, ...]:
        """Return all springs: those that vary are known by their row."""
        return SPRINGS.chosen(terms)

    def rows(self, terms: Sequence[Spring], to: Lowering) -> Varied:
        """Return the springs of varying stiffness; InputError where it would fall to nothing."""
        varied = [(row, spring) for row, spring in enumerate(terms) if spring.stiffness_waves]
        for _, spring in varied:
            swing = sum(abs(wave.amplitude) for wave in spring.stiffness_waves)
            if swing >= 1:
                raise InputError(
                    f"{spring.name}: its stiffness varies by {swing:.3g} of its mean, so that it would not be above 0 "
                    "at all angles; make the sum of the amplitudes smaller than 1"
                )
        waves = _stiffness_waves([spring for _, spring in varied], to)
        return Varied(
            spring=whole(row for row, _ in varied),
            damping_follows=whole(s.damping_follows for _, s in varied),
            first=waves.first,
            slot=waves.slot,
            order=waves.order,
            c=waves.c,
            s=waves.s,
        )

    def refused(self, terms: Sequence[Spring]) -> Iterator[tuple[str, str]]:
        """Yield each spring that varies."""
        yield from ((spring.name, "a stiffness that varies") for spring in terms if spring.stiffness_waves)

    def left_out(self, terms: Sequence[Spring], rows: Varied) -> Iterator[str]:
        """Yield each spring that varies."""
        for spring in terms:
            if spring.stiffness_waves:
                yield f"the varying of the stiffness of {spring.name!r}"


SPRINGS, VARIED = SpringKind(), VariedKind()
