"""Friction with bristles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from torquerig.errors import InputError
from torquerig.rig.terms import BristleFriction
from torquerig.simulation.arrays import Floats, Rows
from torquerig.simulation.term_kinds.kind import Link, Lowering, TermKind, by_direction, floats, whole


class Bristles(NamedTuple):
    """Bristle frictions; column 0 backward, column 1 forward."""

    on: Rows
    against: Rows
    stiffness: Floats
    damping: Floats
    coulomb: Floats  # (bristles, 2)
    excess: Floats  # (bristles, 2): static minus Coulomb
    inverse_stribeck: Floats
    viscous: Floats


class BristleKind(TermKind[BristleFriction, Bristles]):
    """Bristle friction; each row has a state of its own in the kernel."""

    field = "bristles"
    made_from = (BristleFriction,)

    def rows(self, terms: Sequence[BristleFriction], to: Lowering) -> Bristles:
        """Return the bristle frictions; InputError where one has no stiffness or no grip."""
        for t in terms:
            if min(t.coulomb_forward, t.coulomb_backward, t.static_forward, t.static_backward, t.stiffness) <= 0:
                raise InputError(f"{t.name}: bristles need a stiffness, Coulomb and static torque above 0; state them")
        return Bristles(
            on=whole(to.number[t.on] for t in terms),
            against=whole(to.number[t.against] for t in terms),
            stiffness=floats(t.stiffness for t in terms),
            damping=floats(t.damping for t in terms),
            coulomb=by_direction((t.coulomb_backward, t.coulomb_forward) for t in terms),
            excess=by_direction(
                (t.static_backward - t.coulomb_backward, t.static_forward - t.coulomb_forward) for t in terms
            ),
            inverse_stribeck=floats(1 / t.stribeck for t in terms),
            viscous=floats(t.viscous for t in terms),
        )

    def links(self, rows: Bristles, *, stiffest: bool) -> Iterator[Link]:
        """Yield the viscous part of bristles that slide; where wanted all of bristles that stick."""
        for on, against, k, c, viscous in zip(*rows[:4], rows.viscous, strict=True):
            yield Link(on, against, k, viscous + c) if stiffest else Link(on, against, 0.0, viscous)

    def refused(self, terms: Sequence[BristleFriction]) -> Iterator[tuple[str, str]]:
        """Yield each by the shaft that it is on."""
        yield from ((term.on, "friction with bristles") for term in terms)


BRISTLES = BristleKind()
