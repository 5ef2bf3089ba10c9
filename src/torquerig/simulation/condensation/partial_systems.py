"""The two reductions of a shaft line: a small mass between springs taken quasi-statically, a stiff spring as rigid.

Both keep the whole inertia, the whole viscous drag and the static flexibility between what stays.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from torquerig.rig.terms import GROUND, Friction, ImposedMotion, Inertia, Spring, Term

NODE_FIELDS = ("node", "on", "against", "a", "b")


@dataclass(frozen=True)
class ShaftLine:
    """The physics of a rig on its way to fewer nodes.

    Parameters
    ----------
    terms : tuple of Term
    read_nodes, read_springs : frozenset of str
        What a recording of the rig needs the angle, speed or torque of; it stays.
    joined : dict of str to str
        Nodes that turn rigidly with another, by that other.
    series : dict of str to str
        Springs that are read as another, which carries the same torque.
    left_out : tuple of str
        What was done, one clause each.
    """

    terms: tuple[Term, ...]
    read_nodes: frozenset[str]
    read_springs: frozenset[str]
    joined: dict[str, str]
    series: dict[str, str]
    left_out: tuple[str, ...] = ()

    def springs(self) -> tuple[Spring, ...]:
        """Return the springs."""
        return tuple(term for term in self.terms if isinstance(term, Spring))

    def inertias(self) -> dict[str, float]:
        """Return the inertia on each node [kg m^2]."""
        found: dict[str, float] = {}
        for term in self.terms:
            if isinstance(term, Inertia) and term.node != GROUND:
                found[term.node] = found.get(term.node, 0.0) + term.inertia
        return found

    def occupied(self) -> set[str]:
        """Return the nodes that must stay: read, or with more on them than inertia, plain springs and viscous drag."""
        found = set(self.read_nodes) | {GROUND}
        for term in self.terms:
            if not (isinstance(term, Inertia) or is_drag(term) or (isinstance(term, Spring) and is_plain(term))):
                found |= set(term.nodes)
        return found


class Reduction(NamedTuple):
    """One possible step: ``node`` is taken quasi-statically, or joined with ``into``; its partial frequency [rad/s]."""

    frequency: float
    node: str
    into: str = ""
    spring: str = ""


def is_plain(spring: Spring) -> bool:
    """Whether a spring is linear and the same at every angle."""
    special = spring.gap or spring.error or spring.stiffness_waves or spring.rest
    return not special and spring.efficiency == 1.0 and spring.backward_efficiency in (None, 1.0)


def is_drag(term: Term) -> bool:
    """Whether a term is viscous friction against the frame and nothing else."""
    if not isinstance(term, Friction) or term.against != GROUND or term.viscous_backward is not None:
        return False
    dry = (term.coulomb_forward, term.coulomb_backward, term.static_forward, term.static_backward, term.quadratic)
    return not any(dry)


def small_masses(line: ShaftLine) -> Iterator[Reduction]:
    """Yield each free node between two plain springs, as fast as it is between held ends."""
    occupied, springs = line.occupied(), line.springs()
    for node, inertia in line.inertias().items():
        near = [spring for spring in springs if node in (spring.a, spring.b)]
        if node in occupied or len(near) != 2:
            continue
        read = [spring for spring in near if spring.name in line.read_springs]
        geared = any(spring.ratio != 1.0 for spring in near)
        opposed = near[0].a == near[1].a or near[0].b == near[1].b
        if {near[0].a, near[0].b} == {near[1].a, near[1].b} or (read and (geared or (opposed and len(read) == 2))):
            continue
        stiffness, damping = (sum(getattr(_at(one, node), of) for one in near) for of in ("stiffness", "damping"))
        yield Reduction(fastest(stiffness, damping, 1 / inertia), node)


def stiff_springs(line: ShaftLine) -> Iterator[Reduction]:
    """Yield each plain spring that nothing reads, as fast as it is between its two masses alone.

    The node that stays is the one with more on it.
    """
    inertias, occupied = line.inertias(), line.occupied()
    imposed = {term.on for term in line.terms if isinstance(term, ImposedMotion)} | {GROUND}
    for spring in line.springs():
        if not is_plain(spring) or spring.ratio != 1.0 or spring.name in line.read_springs:
            continue
        ends = {spring.a, spring.b}
        if ends & imposed or sum({other.a, other.b} == ends for other in line.springs()) > 1:
            continue
        first, second = sorted(
            (spring.a, spring.b), key=lambda node: (node in occupied, inertias[node], node), reverse=True
        )
        rate = fastest(spring.stiffness, spring.damping, 1 / inertias[first] + 1 / inertias[second])
        yield Reduction(rate, second, first, spring.name)


def fastest(stiffness: float, damping: float, inverse_inertia: float) -> float:
    """Return the size of the fastest root of ``J s^2 + c s + k`` [1/s]; beyond critical damping it is a decay."""
    square, half = stiffness * inverse_inertia, 0.5 * damping * inverse_inertia
    return float(half + np.sqrt(half**2 - square)) if half**2 > square else float(np.sqrt(square))


def without_mass(line: ShaftLine, step: Reduction) -> ShaftLine:
    """Return the line with a node taken quasi-statically (Guyan 1965, AIAA J. 3(2)), its inertia shared by the lever.

    Its angle is then ``(k1 theta1 + k2 theta2) / (k1 + k2)``, and both springs are one in series. Guyan's mass matrix
    also couples the ends; here each end gets its share alone, so that inertias stay inertias.
    """
    node = step.node
    first, second = (spring for spring in line.springs() if node in (spring.a, spring.b))
    if second.name in line.read_springs:  # the spring that stays has the name and the direction of the one that is read
        first, second = second, first
    towards = second if first.b == node else first  # first.b == node: from first through the node to second
    origin = first if towards is second else second
    x, y = _at(origin, node), _at(towards, node)
    total = x.stiffness + y.stiffness
    share_x, share_y = x.stiffness / total, y.stiffness / total
    # turns of the node per turn of the start, and of the end per turn of the node
    before, behind = x.turns, 1 / y.turns
    joined = Spring(
        name=first.name, a=x.other, b=y.other, stiffness=x.stiffness * share_y / behind**2,
        damping=(x.damping * share_y**2 + y.damping * share_x**2) / behind**2, ratio=1 / (before * behind),
    )  # fmt: skip
    kept: list[Term] = []
    for term in line.terms:
        if term is second:
            continue
        if term is first:
            kept.append(joined)
        elif isinstance(term, Inertia) and term.node == node:
            kept += [
                replace(term, node=x.other, inertia=term.inertia * share_x * before**2),
                replace(term, node=y.other, inertia=term.inertia * share_y / behind**2),
            ]
        elif isinstance(term, Friction) and term.on == node:
            kept += [
                replace(term, on=x.other, viscous=term.viscous * share_x * before**2),
                replace(term, on=y.other, viscous=term.viscous * share_y / behind**2),
            ]
        else:
            kept.append(term)
    series = {name: first.name if into == second.name else into for name, into in line.series.items()}
    series[second.name] = first.name
    reads = line.read_springs | ({first.name} if second.name in line.read_springs else set())
    return replace(
        line, terms=tuple(kept), series=series, read_springs=reads,
        left_out=(*line.left_out, f"the inertia of {node!r} is shared between {x.other!r} and {y.other!r}"),
    )  # fmt: skip


def without_spring(line: ShaftLine, step: Reduction) -> ShaftLine:
    """Return the line with a spring taken as rigid, its flexibility moved into the springs on both sides.

    Of the flexibility e between J1 and J2, the springs beside J1 get ``e J2 / (J1 + J2)`` and those beside J2 the other
    share: the low modes stay to second order (Rivin 1999, Stiffness and Damping in Mechanical Design, section 6).
    """
    inertias = line.inertias()
    gone = next(spring for spring in line.springs() if spring.name == step.spring)
    total = inertias[step.node] + inertias[step.into]
    softer = {step.node: inertias[step.into] / total, step.into: inertias[step.node] / total}
    kept: list[Term] = []
    for term in line.terms:
        if term is gone:
            continue
        if isinstance(term, Spring):
            kept.append(_renamed(_softened(term, gone, softer), step.node, step.into))
        else:
            kept.append(_renamed(term, step.node, step.into))
    joined = {name: step.into if into == step.node else into for name, into in line.joined.items()}
    return replace(
        line, terms=tuple(kept), joined={**joined, step.node: step.into},
        read_nodes=frozenset(step.into if name == step.node else name for name in line.read_nodes),
        left_out=(*line.left_out, f"{gone.name!r} is rigid, {step.node!r} turns with {step.into!r}"),
    )  # fmt: skip


class _Seen(NamedTuple):
    """A spring seen from one of its nodes: the other end, stiffness and damping there, turns of the node per its."""

    other: str
    stiffness: float
    damping: float
    turns: float


def _at(spring: Spring, node: str) -> _Seen:
    if node == spring.b:
        return _Seen(spring.a, spring.stiffness, spring.damping, 1 / spring.ratio)
    squared = spring.ratio**2
    return _Seen(spring.b, spring.stiffness / squared, spring.damping / squared, spring.ratio)


def _softened(spring: Spring, gone: Spring, shares: dict[str, float]) -> Spring:
    """Return a spring with the shares of the flexibility of another that is taken as rigid, by the node between."""
    added = sum(shares[node] / gone.stiffness * _scale(spring, node) for node in {spring.a, spring.b} & set(shares))
    if not added:
        return spring
    softer = 1 / (1 + spring.stiffness * added)
    return replace(spring, stiffness=spring.stiffness * softer, damping=spring.damping * softer**2)


def _scale(spring: Spring, node: str) -> float:
    """Return by what a flexibility at a node is multiplied to be counted on side b of a spring."""
    return 1.0 if node == spring.b else 1 / spring.ratio**2


def _renamed(term: Term, old: str, new: str) -> Term:
    changes = {name: new for name in NODE_FIELDS if getattr(term, name, None) == old}
    return replace(term, **changes) if changes else term  # type: ignore[type-var]
