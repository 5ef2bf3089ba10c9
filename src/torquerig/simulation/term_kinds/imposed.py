"""Motions that are given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from torquerig.errors import InputError
from torquerig.rig.terms import ImposedMotion
from torquerig.simulation.arrays import Floats, Rows, Starts
from torquerig.simulation.term_kinds.kind import UNFILLED, Lowering, TermKind, floats, whole


class Imposed(NamedTuple):
    """Nodes whose motion is given at every sample."""

    on: Rows
    inertia: Floats  # what sits on the node: it moves by its torques once it is released
    release: Starts  # sample from which on it is no longer imposed
    angle: Floats  # (imposed, settling + samples + 1)
    speed: Floats


class ImposedKind(TermKind[ImposedMotion, Imposed]):
    """Imposed motions, at most one on a node."""

    field = "imposed"
    made_from = (ImposedMotion,)

    def rows(self, terms: Sequence[ImposedMotion], to: Lowering) -> Imposed:
        """Return the motions, angles, speeds and release still empty; InputError where two are on one node."""
        first: dict[str, str] = {}
        for term in terms:
            if term.on in first:
                raise InputError(
                    f"{term.name}: the motion of {term.on!r} is imposed by {first[term.on]!r} already; drop one of "
                    "the two"
                )
            first[term.on] = term.name
        return Imposed(
            on=whole(to.number[t.on] for t in terms),
            inertia=floats(to.inertia[to.number[t.on]] for t in terms),
            release=np.zeros(0, dtype=np.int64),
            angle=UNFILLED,
            speed=UNFILLED,
        )

    def refused(self, terms: Sequence[ImposedMotion]) -> Iterator[tuple[str, str]]:
        """Yield all of them."""
        yield from ((term.name, "an imposed motion") for term in terms)


IMPOSED = ImposedKind()
