"""From a Rig to flat arrays; the kernel and the linear twin read the same arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import (
    GROUND,
    AngleLoad,
    AppliedTorque,
    BladeTorque,
    BristleFriction,
    Drive,
    Friction,
    HarmonicTorque,
    ImposedMotion,
    Inertia,
    Load,
    Spring,
    Term,
    Wave,
)
from torquerig.simulation import rows
from torquerig.simulation.arrays import (
    AngleLoads,
    Blades,
    Bristles,
    Drives,
    Frictions,
    Harmonics,
    Imposed,
    Loads,
    Sensings,
    Springs,
    Varied,
    Waves,
)
from torquerig.simulation.rows import phase_of
from torquerig.simulation.waves import WaveTable

__all__ = ["Lowered", "lower", "lower_terms", "phase_of"]
Kind = TypeVar("Kind", bound=Term)
NODES = ("a", "b", "on", "against", "angle")  # the fields by which terms name nodes


@dataclass(frozen=True)
class Lowered:
    """A rig as arrays. ``nodes`` names the rows; the ground comes after the last one."""

    nodes: tuple[str, ...]
    spring_names: tuple[str, ...]
    drive_names: tuple[str, ...]
    load_terms: tuple[Load | AppliedTorque, ...]
    drive_terms: tuple[Drive, ...]
    imposed_terms: tuple[ImposedMotion, ...]
    angle_load_terms: tuple[AngleLoad, ...]
    inertia: NDArray[np.float64]
    waves: Waves
    springs: Springs
    harmonics: Harmonics
    frictions: Frictions
    blades: Blades
    drives: Drives  # reference and demand still empty: the run fills them
    loads: Loads  # samples still empty: the run fills them
    imposed: Imposed  # motion still empty: the run fills it
    sensings: Sensings
    varied: Varied
    bristles: Bristles
    angle_loads: AngleLoads

    def node(self, name: str) -> int:
        """Return the row of a node; the ground is the last."""
        return len(self.nodes) if name == GROUND else self.nodes.index(name)

    def swings(self) -> NDArray[np.float64]:
        """Return by how much of its mean the stiffness of each spring can vary at most, shape (springs,) [1]."""
        swings = np.zeros(len(self.spring_names))
        sizes = np.hypot(self.varied.c, self.varied.s)
        for row, start, end in zip(self.varied.spring, self.varied.first, self.varied.first[1:], strict=False):
            swings[row] = sizes[start:end].sum()
        return swings

    def leader(self) -> str:
        """Return the node that the run's speed belongs to: the first driven, else the first imposed, else the first."""
        led = [term.on for term in self.drive_terms] + [term.on for term in self.imposed_terms]
        return led[0] if led else self.nodes[0]


def lower(rig: Rig, seed: int) -> Lowered:
    """Return the rig as arrays; phases that are not stated are drawn from ``seed``, each by its own name."""
    return lower_terms(rig.terms(), seed)


def lower_terms(terms: Sequence[Term], seed: int) -> Lowered:
    """Return the same from a rig's physics, without the rig: what asks for matrices alone leaves its waves out."""
    nodes, inertia = _nodes(terms)
    number = {name: row for row, name in enumerate(nodes)} | {GROUND: len(nodes)}
    # a wave of no amplitude must not change how the others are multiplied together
    springs = tuple(
        replace(spring, error=_sounding(spring.error), stiffness_waves=_sounding(spring.stiffness_waves))
        for spring in _of(terms, Spring)
    )
    harmonics = tuple(replace(term, waves=_sounding(term.waves)) for term in _of(terms, HarmonicTorque))
    drives = tuple(replace(drive, ripple=_sounding(drive.ripple)) for drive in _of(terms, Drive))
    blades = tuple(blade for blade in _of(terms, BladeTorque) if blade.amplitude)
    loads: tuple[Load | AppliedTorque, ...] = (*_of(terms, Load), *_of(terms, AppliedTorque))
    imposed, angle_loads = _of(terms, ImposedMotion), _of(terms, AngleLoad)
    _refuse_two_on_a_node(imposed)
    table = WaveTable.of(
        [(number[s.b], w.order) for s in springs for w in (*s.error, *s.stiffness_waves)]
        + [(number[h.angle], w.order) for h in harmonics for w in h.waves]
        + [(number[d.on], w.order) for d in drives for w in d.ripple]
        + [(number[b.on], b.order) for b in blades]
    )
    return Lowered(
        nodes=nodes,
        spring_names=tuple(spring.name for spring in springs),
        drive_names=tuple(drive.name for drive in drives),
        load_terms=loads,
        drive_terms=drives,
        imposed_terms=imposed,
        angle_load_terms=angle_loads,
        inertia=inertia,
        waves=table.lowered(),
        springs=rows.springs_of(springs, number, table, seed),
        harmonics=rows.harmonics_of(harmonics, number, table, seed),
        frictions=rows.frictions_of(rows.merged(_of(terms, Friction)), number),
        blades=rows.blades_of(blades, number, table, seed),
        drives=rows.drives_of(drives, number, table, seed),
        loads=rows.loads_of(loads, number),
        imposed=rows.imposed_of(imposed, number, inertia),
        sensings=rows.sensings_of(drives, number, seed),
        varied=rows.varied_of(springs, number, table, seed),
        bristles=rows.bristles_of(_of(terms, BristleFriction), number),
        angle_loads=rows.angle_loads_of(angle_loads, number, seed),
    )


def _nodes(terms: Sequence[Term]) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Return the nodes and what inertia sits on each; InputError where a term names a node without any."""
    carried: dict[str, float] = {}
    for one in _of(terms, Inertia):
        if one.inertia > 0:
            carried[one.node] = carried.get(one.node, 0.0) + one.inertia
    if not carried:
        raise InputError("the rig has no inertia at all; add a motor or a body")
    for term in terms:
        for name in (getattr(term, field) for field in NODES if hasattr(term, field)):
            if name not in carried and name != GROUND:
                raise InputError(f"{name}: no inertia sits on this shaft; give the part one or fix it to one that has")
    return tuple(carried), np.array(list(carried.values()))


def _refuse_two_on_a_node(imposed: Sequence[ImposedMotion]) -> None:
    first: dict[str, str] = {}
    for term in imposed:
        if term.on in first:
            raise InputError(
                f"{term.name}: the motion of {term.on!r} is imposed by {first[term.on]!r} already; drop one of the two"
            )
        first[term.on] = term.name


def _sounding(waves: Sequence[Wave]) -> tuple[Wave, ...]:
    return tuple(wave for wave in waves if wave.amplitude)


def _of(terms: Sequence[Term], kind: type[Kind]) -> tuple[Kind, ...]:
    return tuple(term for term in terms if isinstance(term, kind))
