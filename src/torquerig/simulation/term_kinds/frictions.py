"""Friction by the speed: Coulomb, Stribeck, viscous and quadratic."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from torquerig.rig.terms import Friction, Term
from torquerig.simulation.arrays import Floats, Rows
from torquerig.simulation.term_kinds.kind import Link, Lowering, Reversal, TermKind, by_direction, floats, whole


class Frictions(NamedTuple):
    """Coulomb and static torque by direction: column 0 backward, column 1 forward."""

    on: Rows
    against: Rows
    coulomb: Floats  # (frictions, 2)
    excess: Floats  # (frictions, 2): static minus Coulomb
    inverse_stribeck: Floats
    viscous: Floats
    backward_extra: Floats  # viscous friction backward less that forward
    quadratic: Floats
    inverse_smoothing: Floats


class FrictionKind(TermKind[Friction, Frictions]):
    """Friction, in as few rows as give the same torque."""

    field = "frictions"
    made_from = (Friction,)
    deciding = ("inverse_smoothing",)

    def chosen(self, terms: Sequence[Term]) -> tuple[Friction, ...]:
        """Return the same friction in fewer terms: what is only viscous or quadratic joins another of its shafts."""
        given = super().chosen(terms)
        dry = [term for term in given if _grips(term)]
        smooth: dict[tuple[str, str], Friction] = {}
        for term in given:
            if not _grips(term) and (term.viscous or term.viscous_backward or term.quadratic):
                key = (term.on, term.against)
                before = smooth.get(key)
                smooth[key] = term if before is None else _with_drag(before, term)
        for row, term in enumerate(dry):
            if drag := smooth.pop((term.on, term.against), None):
                dry[row] = _with_drag(term, drag)
        return (*dry, *smooth.values())

    def rows(self, terms: Sequence[Friction], to: Lowering) -> Frictions:
        """Return the frictions."""
        return Frictions(
            on=whole(to.number[t.on] for t in terms),
            against=whole(to.number[t.against] for t in terms),
            coulomb=by_direction((t.coulomb_backward, t.coulomb_forward) for t in terms),
            excess=by_direction(
                (t.static_backward - t.coulomb_backward, t.static_forward - t.coulomb_forward) for t in terms
            ),
            inverse_stribeck=floats(1 / t.stribeck for t in terms),
            viscous=floats(t.viscous for t in terms),
            backward_extra=floats(_viscous_backward(t) - t.viscous for t in terms),
            quadratic=floats(t.quadratic for t in terms),
            inverse_smoothing=floats(1 / t.smoothing for t in terms),
        )

    def links(self, rows: Frictions, *, stiffest: bool) -> Iterator[Link]:
        """Yield the viscous friction, the forward one."""
        for on, against, viscous in zip(rows.on, rows.against, rows.viscous, strict=True):
            yield Link(on, against, 0.0, viscous)

    def reversals(self, terms: Sequence[Friction], rows: Frictions) -> Iterator[Reversal]:
        """Yield the dry friction."""
        for row, term in enumerate(terms):
            grip = float((rows.coulomb[row] + np.maximum(0.0, rows.excess[row])).max())
            if grip:
                on, against, smooth = int(rows.on[row]), int(rows.against[row]), float(rows.inverse_smoothing[row])
                yield Reversal(on, against, grip, smooth, f"the dry friction on {term.on!r}")

    def left_out(self, terms: Sequence[Friction], rows: Frictions) -> Iterator[str]:
        """Yield each quadratic drag."""
        yield from (f"the quadratic drag on {term.on!r} but for its slope" for term in terms if term.quadratic)


def _grips(term: Friction) -> bool:
    return any((term.coulomb_forward, term.coulomb_backward, term.static_forward, term.static_backward))


def _with_drag(term: Friction, drag: Friction) -> Friction:
    return replace(
        term,
        viscous=term.viscous + drag.viscous,
        viscous_backward=_viscous_backward(term) + _viscous_backward(drag),
        quadratic=term.quadratic + drag.quadratic,
    )


def _viscous_backward(term: Friction) -> float:
    return term.viscous if term.viscous_backward is None else term.viscous_backward


FRICTIONS = FrictionKind()
