"""From a Rig to flat arrays: one function per kind of term; the kernel and the linear twin read the same arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import cos, pi, sin
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.rig.rig import Rig
from torquerig.rig.terms import (
    GROUND,
    AppliedTorque,
    BladeTorque,
    Drive,
    Friction,
    HarmonicTorque,
    Inertia,
    Load,
    Spring,
    Term,
    Wave,
)
from torquerig.signals.recording import random_for
from torquerig.simulate.arrays import Blades, Drives, Frictions, Harmonics, Loads, Springs, Waves
from torquerig.simulate.waves import WaveTable

Kind = TypeVar("Kind", bound=Term)


@dataclass(frozen=True)
class Lowered:
    """A rig as arrays. ``nodes`` names the rows; the ground comes after the last one."""

    nodes: tuple[str, ...]
    spring_names: tuple[str, ...]
    drive_names: tuple[str, ...]
    load_terms: tuple[Load | AppliedTorque, ...]
    drive_terms: tuple[Drive, ...]
    inertia: NDArray[np.float64]
    waves: Waves
    springs: Springs
    harmonics: Harmonics
    frictions: Frictions
    blades: Blades
    drives: Drives  # reference still empty: the run fills it
    loads: Loads  # samples still empty: the run fills them

    def node(self, name: str) -> int:
        """Return the row of a node; the ground is the last."""
        return len(self.nodes) if name == GROUND else self.nodes.index(name)


def lower(rig: Rig, seed: int) -> Lowered:
    """Return the rig as arrays; phases that are not stated are drawn from ``seed``, each by its own name."""
    terms = rig.terms()
    inertias = _of(terms, Inertia)
    nodes = tuple(dict.fromkeys(term.node for term in inertias if term.inertia > 0))
    if not nodes:
        raise InputError("the rig has no inertia at all; add a motor or a body")
    number = {name: row for row, name in enumerate(nodes)} | {GROUND: len(nodes)}
    for name in _named_nodes(terms):
        if name not in number:
            raise InputError(f"{name}: no inertia sits on this shaft; give the part one or fix it to one that has")
    inertia = np.zeros(len(nodes))
    for term in inertias:
        if term.inertia > 0:
            inertia[number[term.node]] += term.inertia
    # a wave of no amplitude must not change how the others are multiplied together
    springs = tuple(replace(spring, error=_sounding(spring.error)) for spring in _of(terms, Spring))
    harmonics = tuple(replace(term, waves=_sounding(term.waves)) for term in _of(terms, HarmonicTorque))
    drives = tuple(replace(drive, ripple=_sounding(drive.ripple)) for drive in _of(terms, Drive))
    blades = tuple(blade for blade in _of(terms, BladeTorque) if blade.amplitude)
    loads: tuple[Load | AppliedTorque, ...] = (*_of(terms, Load), *_of(terms, AppliedTorque))
    table = WaveTable.of(
        [(number[s.b], w.order) for s in springs for w in s.error]
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
        inertia=inertia,
        waves=table.lowered(),
        springs=_springs(springs, number, table, seed),
        harmonics=_harmonics(harmonics, number, table, seed),
        frictions=_frictions(_merged(_of(terms, Friction)), number),
        blades=_blades(blades, number, table, seed),
        drives=_drives(drives, number, table, seed),
        loads=Loads(
            _rows(number[t.on] for t in loads),
            _floats(1 / t.smoothing if isinstance(t, Load) else 0.0 for t in loads),
            np.zeros((0, 0)),
        ),
    )


def phase_of(owner: str, wave: Wave, seed: int) -> float:
    """Return the phase of a wave [rad]: as stated, else drawn uniformly by seed, owner and key (or order)."""
    if wave.phase is not None:
        return wave.phase
    key = wave.phase_key or f"{owner}.{wave.order:g}"
    return float(random_for(seed, f"phase {key}").uniform(0, 2 * pi))


class _Phased(NamedTuple):
    """Waves of several owners one after the other: where each owner's start, slots, orders, cosine and sine parts."""

    first: NDArray[np.int64]
    slot: NDArray[np.uint64]
    order: NDArray[np.float64]
    c: NDArray[np.float64]
    s: NDArray[np.float64]


def _phased(owners: Sequence[tuple[str, int, Sequence[Wave]]], table: WaveTable, seed: int) -> _Phased:
    """Return the waves of (name, node of the angle, waves) with their phases drawn."""
    flat = [(node, wave, phase_of(name, wave, seed)) for name, node, waves in owners for wave in waves]
    return _Phased(
        first=np.concatenate([[0], np.cumsum([len(waves) for _, _, waves in owners])]).astype(np.int64),
        slot=_rows(table.slots[(node, wave.order)] for node, wave, _ in flat),
        order=_floats(wave.order for _, wave, _ in flat),
        c=_floats(wave.amplitude * cos(phase) for _, wave, phase in flat),
        s=_floats(wave.amplitude * sin(phase) for _, wave, phase in flat),
    )


def _springs(springs: Sequence[Spring], number: dict[str, int], table: WaveTable, seed: int) -> Springs:
    errors = _phased([(s.name, number[s.b], s.error) for s in springs], table, seed)
    return Springs(
        a=_rows(number[s.a] for s in springs),
        b=_rows(number[s.b] for s in springs),
        stiffness=_floats(s.stiffness for s in springs),
        damping=_floats(s.damping for s in springs),
        half_gap=_floats(0.5 * s.gap for s in springs),
        inverse_ratio=_floats(1 / s.ratio for s in springs),
        loss_mean=_floats(0.5 * (1 / s.efficiency + s.efficiency) for s in springs),
        loss_half=_floats(0.5 * (1 / s.efficiency - s.efficiency) for s in springs),
        e_first=errors.first,
        e_slot=errors.slot,
        e_order=errors.order,
        e_cos=errors.c,
        e_sin=errors.s,
    )


def _harmonics(terms: Sequence[HarmonicTorque], number: dict[str, int], table: WaveTable, seed: int) -> Harmonics:
    waves = _phased([(t.name, number[t.angle], t.waves) for t in terms], table, seed)
    return Harmonics(
        on=_rows(number[t.on] for t in terms for _ in t.waves),
        against=_rows(number[t.against] for t in terms for _ in t.waves),
        slot=waves.slot,
        c=waves.c,
        s=waves.s,
    )


def _merged(terms: Sequence[Friction]) -> list[Friction]:
    """Return the same friction in fewer terms: what is only viscous or quadratic joins another term of its shafts."""
    dry = [term for term in terms if _grips(term)]
    smooth: dict[tuple[str, str], Friction] = {}
    for term in terms:
        if not _grips(term) and (term.viscous or term.quadratic):
            key = (term.on, term.against)
            before = smooth.get(key)
            smooth[key] = term if before is None else _with_drag(before, term)
    for row, term in enumerate(dry):
        if drag := smooth.pop((term.on, term.against), None):
            dry[row] = _with_drag(term, drag)
    return [*dry, *smooth.values()]


def _grips(term: Friction) -> bool:
    return any((term.coulomb_forward, term.coulomb_backward, term.static_forward, term.static_backward))


def _with_drag(term: Friction, drag: Friction) -> Friction:
    return replace(term, viscous=term.viscous + drag.viscous, quadratic=term.quadratic + drag.quadratic)


def _frictions(terms: Sequence[Friction], number: dict[str, int]) -> Frictions:
    coulomb = [(t.coulomb_backward, t.coulomb_forward) for t in terms]
    excess = [(t.static_backward - t.coulomb_backward, t.static_forward - t.coulomb_forward) for t in terms]
    return Frictions(
        on=_rows(number[t.on] for t in terms),
        against=_rows(number[t.against] for t in terms),
        coulomb=np.array(coulomb, dtype=np.float64).reshape(-1, 2),
        excess=np.array(excess, dtype=np.float64).reshape(-1, 2),
        inverse_stribeck=_floats(1 / t.stribeck for t in terms),
        viscous=_floats(t.viscous for t in terms),
        quadratic=_floats(t.quadratic for t in terms),
        inverse_smoothing=_floats(1 / t.smoothing for t in terms),
    )


def _blades(terms: Sequence[BladeTorque], number: dict[str, int], table: WaveTable, seed: int) -> Blades:
    phases = [phase_of(t.name, Wave(order=t.order, amplitude=1.0, phase=t.phase), seed) for t in terms]
    return Blades(
        on=_rows(number[t.on] for t in terms),
        slot=_rows(table.slots[(number[t.on], t.order)] for t in terms),
        c=_floats(cos(phase) for phase in phases),
        s=_floats(sin(phase) for phase in phases),
        amplitude=_floats(t.amplitude for t in terms),
        inverse_smoothing=_floats(1 / t.smoothing for t in terms),
    )


def _drives(terms: Sequence[Drive], number: dict[str, int], table: WaveTable, seed: int) -> Drives:
    ripple = _phased([(t.name, number[t.on], t.ripple) for t in terms], table, seed)
    return Drives(
        on=_rows(number[t.on] for t in terms),
        against=_rows(number[t.against] for t in terms),
        kp=_floats(t.kp for t in terms),
        ki=_floats(t.ki for t in terms),
        limit=_floats(t.torque_limit for t in terms),
        inverse_lag=_floats(1 / t.lag for t in terms),
        r_first=ripple.first,
        r_slot=ripple.slot,
        r_c=ripple.c,
        r_s=ripple.s,
        reference=np.zeros((0, 0)),
    )


def _sounding(waves: Sequence[Wave]) -> tuple[Wave, ...]:
    return tuple(wave for wave in waves if wave.amplitude)


def _of(terms: Sequence[Term], kind: type[Kind]) -> tuple[Kind, ...]:
    return tuple(term for term in terms if isinstance(term, kind))


def _named_nodes(terms: Sequence[Term]) -> list[str]:
    names: list[str] = []
    for term in terms:
        if isinstance(term, Spring):
            names += [term.a, term.b]
        elif isinstance(term, HarmonicTorque):
            names += [term.on, term.against, term.angle]
        elif isinstance(term, Friction | Drive):
            names += [term.on, term.against]
        elif isinstance(term, Load | AppliedTorque | BladeTorque):
            names.append(term.on)
    return names


def _rows(values: object) -> NDArray[np.uint64]:
    return np.array(list(values), dtype=np.uint64)  # type: ignore[call-overload]


def _floats(values: object) -> NDArray[np.float64]:
    return np.array(list(values), dtype=np.float64)  # type: ignore[call-overload]
