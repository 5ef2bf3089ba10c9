"""The waves of several rigs in one structure, so that rigs with other lines can be stepped together.

Each rig keeps its orders: the orders of the bases differ from rig to rig, and what a rig does not have is of size zero.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from torquerig.simulation.arrays import Waves
from torquerig.simulation.term_kinds import Terms
from torquerig.simulation.waves import families, ladder_length, orders_of


class _Line(NamedTuple):
    """The node whose angle is taken, and the order."""

    node: int
    order: float


class _Entry(NamedTuple):
    """One wave of a sum: its cosine and sine part."""

    line: _Line
    c: float
    s: float


class _Owner(NamedTuple):
    """What a sum of waves belongs to; ``place`` is the row of a spring or drive, the nodes of a harmonic torque."""

    kind: str
    place: tuple[int, ...]


_Sums = Mapping[_Owner, Sequence[_Entry]]


@dataclass(frozen=True)
class _Plan:
    """The orders of one rig at one node: multiples of ``base`` on a ladder of ``length``, and single ``others``."""

    base: float
    length: int
    multiples: Mapping[float, int]
    others: tuple[float, ...]


NOTHING = _Plan(0.0, 0, {}, ())


def can_share_waves(terms: Terms) -> bool:
    """Return whether all waves of a rig are of harmonic torques, of the springs' errors and of the drives' ripple."""
    return not terms.varied.spring.size and not terms.blades.on.size


def with_shared_waves(rigs: Sequence[Terms]) -> list[Terms]:
    """Return the arrays of rigs, equal in all but their waves, with waves of one structure.

    The motion of a rig does not depend on the others: each order is computed in the same way whichever rigs are
    together, sums are in the order of the slots, and what is added for the others is zero.

    Parameters
    ----------
    rigs : sequence of Terms
        Each as ``can_share_waves`` allows it.
    """
    sums = [_sums(terms) for terms in rigs]
    plans = [_plans(each) for each in sums]
    nodes = sorted({node for each in plans for node in each})
    shape = {
        node: (
            max(each.get(node, NOTHING).length for each in plans),
            max(len(each.get(node, NOTHING).others) for each in plans),
        )
        for node in nodes
    }
    slots = [_slots(each, shape) for each in plans]
    owners = sorted({owner for each in sums for owner in each})
    used = {
        owner: sorted({at[entry.line] for each, at in zip(sums, slots, strict=True) for entry in each.get(owner, ())})
        for owner in owners
    }
    return [
        _rewritten(terms, _waves(plan, shape), _placed(each, at, used))
        for terms, plan, each, at in zip(rigs, plans, sums, slots, strict=True)
    ]


def _sums(terms: Terms) -> _Sums:
    """Return the waves of a rig by what they belong to."""
    lines = [_Line(*line) for line in orders_of(terms.waves)]
    harmonics, springs, drives = terms.harmonics, terms.springs, terms.drives
    pairs = [_Owner("harmonic", (int(on), int(to))) for on, to in zip(harmonics.on, harmonics.against, strict=True)]
    errors = [_Owner("error", (row,)) for row in range(springs.a.size)]
    ripples = [_Owner("ripple", (row,)) for row in range(drives.on.size)]
    found: dict[_Owner, list[_Entry]] = {}
    for owners, first, slot, c, s in (
        (pairs, harmonics.first, harmonics.slot, harmonics.c, harmonics.s),
        (errors, springs.e_first, springs.e_slot, springs.e_cos, springs.e_sin),
        (ripples, drives.r_first, drives.r_slot, drives.r_c, drives.r_s),
    ):
        for row, owner in enumerate(owners):
            within = range(int(first[row]), int(first[row + 1]))
            found[owner] = [_Entry(lines[int(slot[at])], float(c[at]), float(s[at])) for at in within]
    return found


def _plans(sums: _Sums) -> dict[int, _Plan]:
    """Return by node how the orders of one rig are computed: on one ladder, or with a sine each."""
    orders: dict[int, set[float]] = {}
    for entries in sums.values():
        for entry in entries:
            orders.setdefault(entry.line.node, set()).add(entry.line.order)
    return {node: _plan(each) for node, each in orders.items()}


def _plan(orders: set[float]) -> _Plan:
    *_, (base, multiples) = families(orders)
    length = ladder_length(multiples.values())
    within = {order: multiple for order, multiple in multiples.items() if multiple <= length}
    return _Plan(base, length, within, tuple(sorted(orders - set(within))))


def _slots(plans: Mapping[int, _Plan], shape: Mapping[int, tuple[int, int]]) -> dict[_Line, int]:
    """Return where each order of one rig is found."""
    found: dict[_Line, int] = {}
    start = 0
    for node, (length, others) in shape.items():
        plan = plans.get(node, NOTHING)
        found |= {_Line(node, order): start + multiple - 1 for order, multiple in plan.multiples.items()}
        found |= {_Line(node, order): start + length + at for at, order in enumerate(plan.others)}
        start += length + others
    return found


def _waves(plans: Mapping[int, _Plan], shape: Mapping[int, tuple[int, int]]) -> Waves:
    """Return the waves of one rig; bases that it does not have are of order 0."""
    nodes, orders, ladder = [], [], [0]
    for node, (length, others) in shape.items():
        plan = plans.get(node, NOTHING)
        nodes += [node] * (1 + others)
        orders += [plan.base, *plan.others, *[0.0] * (others - len(plan.others))]
        ladder += [ladder[-1] + length, *(ladder[-1] + length + at for at in range(1, others + 1))]
    empty = np.empty(0, dtype=np.uint64)
    return Waves(
        base_node=np.array(nodes, dtype=np.uint64), base_order=np.array(orders, dtype=np.float64),
        ladder=np.array(ladder, dtype=np.uint64), first=empty, second=empty,
    )  # fmt: skip


class _Placed(NamedTuple):
    """The sums of one kind, one after the other, at the slots that any of the rigs uses."""

    owners: list[_Owner]
    first: list[int]
    slot: list[int]
    order: list[float]
    c: list[float]
    s: list[float]


def _placed(sums: _Sums, slots: Mapping[_Line, int], used: Mapping[_Owner, Sequence[int]]) -> dict[str, _Placed]:
    """Return the sums of one rig by kind."""
    found = {kind: _Placed([], [0], [], [], [], []) for kind in ("harmonic", "error", "ripple")}
    for owner, places in used.items():
        made = found[owner.kind]
        at = {slot: row for row, slot in enumerate(places)}
        order, c, s = ([0.0] * len(places) for _ in range(3))
        for entry in sums.get(owner, ()):
            row = at[slots[entry.line]]
            order[row] = entry.line.order
            c[row] += entry.c
            s[row] += entry.s
        made.owners.append(owner)
        made.slot.extend(places)
        made.order.extend(order)
        made.c.extend(c)
        made.s.extend(s)
        made.first.append(len(made.slot))
    return found


def _rewritten(terms: Terms, waves: Waves, placed: Mapping[str, _Placed]) -> Terms:
    pairs, errors, ripples = placed["harmonic"], placed["error"], placed["ripple"]
    whole, floats = np.uint64, np.float64
    return terms._replace(
        waves=waves,
        harmonics=terms.harmonics._replace(
            on=np.array([owner.place[0] for owner in pairs.owners], dtype=whole),
            against=np.array([owner.place[1] for owner in pairs.owners], dtype=whole),
            first=np.array(pairs.first, dtype=whole), slot=np.array(pairs.slot, dtype=whole),
            c=np.array(pairs.c, dtype=floats), s=np.array(pairs.s, dtype=floats),
        ),
        springs=terms.springs._replace(
            e_first=np.array(errors.first, dtype=np.int64), e_slot=np.array(errors.slot, dtype=whole),
            e_order=np.array(errors.order, dtype=floats), e_cos=np.array(errors.c, dtype=floats),
            e_sin=np.array(errors.s, dtype=floats),
        ),
        drives=terms.drives._replace(
            r_first=np.array(ripples.first, dtype=np.int64), r_slot=np.array(ripples.slot, dtype=whole),
            r_c=np.array(ripples.c, dtype=floats), r_s=np.array(ripples.s, dtype=floats),
        ),
    )  # fmt: skip
