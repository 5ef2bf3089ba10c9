"""Torques that are periodic in an angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from torquerig.rig.terms import HarmonicTorque, Term
from torquerig.simulation.arrays import Floats, Rows
from torquerig.simulation.term_kinds.kind import Lowering, TermKind, phased, sounding, whole


class Harmonics(NamedTuple):
    """Torques, each a sum of ``cos * c - sin * s`` of its slots, on a node and against another."""

    on: Rows  # (pairs of nodes,)
    against: Rows
    first: Rows  # (pairs + 1,) where the waves of each pair start
    slot: Rows
    c: Floats
    s: Floats


class HarmonicKind(TermKind[HarmonicTorque, Harmonics]):
    """Periodic torques, one row per pair of nodes: what acts between the same two is one sum."""

    field = "harmonics"
    made_from = (HarmonicTorque,)

    def chosen(self, terms: Sequence[Term]) -> tuple[HarmonicTorque, ...]:
        """Return the torques with the waves that have a size."""
        return tuple(sounding(term, "waves") for term in super().chosen(terms))

    def orders(self, terms: Sequence[HarmonicTorque]) -> Iterator[tuple[str, float]]:
        """Yield the waves."""
        yield from ((term.angle, wave.order) for term in terms for wave in term.waves)

    def rows(self, terms: Sequence[HarmonicTorque], to: Lowering) -> Harmonics:
        """Return the periodic torques."""
        pairs = {
            (t.on, t.against): [u for u in terms if (u.on, u.against) == (t.on, t.against)] for t in terms if t.waves
        }
        owners = [(t.name, to.number[t.angle], t.waves) for of in pairs.values() for t in of]
        waves = phased(owners, to.table, to.seed)
        counts = [sum(len(t.waves) for t in of) for of in pairs.values()]
        return Harmonics(
            on=whole(to.number[on] for on, _ in pairs),
            against=whole(to.number[against] for _, against in pairs),
            first=np.cumsum([0, *counts], dtype=np.uint64),
            slot=waves.slot,
            c=waves.c,
            s=waves.s,
        )


HARMONICS = HarmonicKind()
