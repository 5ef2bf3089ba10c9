"""From a Rig to flat arrays; the kernel and the linear twin read the same arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import GROUND, AngleLoad, AppliedTorque, Drive, ImposedMotion, Inertia, Load, Term
from torquerig.simulation.term_kinds import KINDS, Lowering, Terms
from torquerig.simulation.term_kinds.imposed import IMPOSED
from torquerig.simulation.waves import WaveTable

__all__ = ["Lowered", "lower", "lower_terms"]


class Condensed(Protocol):
    """What is said of a condensed rig; made by ``condensation/``."""

    def sentence(self) -> str:
        """Return what was condensed and the error in the band."""
        ...


@dataclass(frozen=True)
class Lowered:
    """A rig as arrays.

    Parameters
    ----------
    nodes : tuple of str
        The rows of nodes; the ground comes after the last one.
    inertia : ndarray, shape (nodes,)
        [kg m^2]; of the nodes without the ground.
    rows_of : mapping of str to tuple of terms
        By the field of each kind in ``Terms``, the terms that its rows stand for.
    arrays : Terms
        Set-points, demands, samples and motions are still empty: the run fills them.
    in_a_line : frozenset of str
        The nodes that move in a line; their numbers are in kg, N and m.
    joined, series : mapping of str to str
        Of a condensed rig: nodes that turn with another, and springs that carry the torque of another, by that other.
    condensation : Condensation or None
        What was condensed, and what that changes; None for the whole rig.
    """

    nodes: tuple[str, ...]
    inertia: NDArray[np.float64]
    rows_of: Mapping[str, tuple[Any, ...]]
    arrays: Terms
    in_a_line: frozenset[str] = frozenset()
    joined: Mapping[str, str] = field(default_factory=dict)
    series: Mapping[str, str] = field(default_factory=dict)
    condensation: Condensed | None = None

    @property
    def spring_names(self) -> tuple[str, ...]:
        """The names of the springs, in the order of their rows."""
        return tuple(term.name for term in self.rows_of["springs"])

    @property
    def drive_names(self) -> tuple[str, ...]:
        """The names of the drives, in the order of their rows."""
        return tuple(term.name for term in self.drive_terms)

    @property
    def drive_terms(self) -> tuple[Drive, ...]:
        """The drives, in the order of their rows."""
        return self.rows_of["drives"]

    @property
    def load_terms(self) -> tuple[Load | AppliedTorque, ...]:
        """Loads and applied torques, in the order of their rows."""
        return self.rows_of["loads"]

    @property
    def imposed_terms(self) -> tuple[ImposedMotion, ...]:
        """Imposed motions, in the order of their rows."""
        return self.rows_of["imposed"]

    @property
    def angle_load_terms(self) -> tuple[AngleLoad, ...]:
        """Loads over the angle, in the order of their rows."""
        return self.rows_of["angle_loads"]

    def node(self, name: str) -> int:
        """Return the row of a node; the ground is the last."""
        return len(self.nodes) if name == GROUND else self.nodes.index(self.joined.get(name, name))

    def spring(self, name: str) -> int:
        """Return the row of the spring whose torque is that of ``name``."""
        return self.spring_names.index(self.series.get(name, name))

    def leader(self) -> str:
        """Return the node that the run's speed belongs to: the first driven, else the first imposed, else the first."""
        led = [term.on for term in self.drive_terms] + [term.on for term in self.imposed_terms]
        return led[0] if led else self.nodes[0]

    def imposing(self, motion: ImposedMotion) -> Lowered:
        """Return the same with ``motion`` as the one imposed motion."""
        lowering = Lowering(number=_numbers(self.nodes), inertia=self.inertia, table=WaveTable(), seed=0)
        imposed = IMPOSED.rows((motion,), lowering)
        return replace(
            self,
            rows_of={**self.rows_of, IMPOSED.field: (motion,)},
            arrays=self.arrays._replace(imposed=imposed),
        )


def lower(rig: Rig, seed: int) -> Lowered:
    """Return the rig as arrays; phases that are not stated are drawn from ``seed``, each by its own name."""
    moved = frozenset(part.name for part in rig.parts if part.in_a_line)
    return replace(lower_terms(rig.terms(), seed), in_a_line=moved)


def lower_terms(terms: Sequence[Term], seed: int) -> Lowered:
    """Return the same from a rig's physics, without the rig: what asks for matrices alone leaves its waves out."""
    nodes, inertia = _nodes(terms)
    number = _numbers(nodes)
    rows_of = {kind.field: kind.chosen(terms) for kind in KINDS}
    wanted = [(number[node], order) for kind in KINDS for node, order in kind.orders(rows_of[kind.field])]
    lowering = Lowering(number=number, inertia=inertia, table=WaveTable.of(wanted), seed=seed)
    arrays = {kind.field: kind.rows(rows_of[kind.field], lowering) for kind in KINDS}
    inverse = np.append(1 / inertia, 0.0)
    return Lowered(
        nodes=nodes,
        inertia=inertia,
        rows_of=rows_of,
        arrays=Terms(inverse_inertia=inverse, waves=lowering.table.lowered(), **arrays),
    )


def _nodes(terms: Sequence[Term]) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Return the nodes and what inertia sits on each; InputError where a term names a node without any."""
    carried: dict[str, float] = {}
    for one in terms:
        if isinstance(one, Inertia) and one.inertia > 0 and one.node != GROUND:
            carried[one.node] = carried.get(one.node, 0.0) + one.inertia
    if not carried:
        raise InputError("the rig has no inertia at all; add a motor or a body")
    for term in terms:
        for name in term.nodes:
            if name not in carried and name != GROUND:
                raise InputError(f"{name}: no inertia sits on this shaft; give the part one or fix it to one that has")
    return tuple(carried), np.array(list(carried.values()))


def _numbers(nodes: Sequence[str]) -> dict[str, int]:
    return {name: row for row, name in enumerate(nodes)} | {GROUND: len(nodes)}
