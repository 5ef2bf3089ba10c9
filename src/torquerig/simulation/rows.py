"""The rows of each kind of term: one function per kind, from terms to the arrays of ``arrays.py``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import cos, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.recording import random_for
from torquerig.rig.terms import (
    AngleLoad,
    AppliedTorque,
    BladeTorque,
    BristleFriction,
    Drive,
    Friction,
    HarmonicTorque,
    ImposedMotion,
    Load,
    Spring,
    Wave,
)
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
)
from torquerig.simulation.waves import WaveTable

Numbers = Mapping[str, int]
UNFILLED = np.zeros((0, 0))  # the run fills it


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


def springs_of(springs: Sequence[Spring], number: Numbers, table: WaveTable, seed: int) -> Springs:
    """Return the springs with the waves of their kinematic errors."""
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


def varied_of(springs: Sequence[Spring], number: Numbers, table: WaveTable, seed: int) -> Varied:
    """Return the springs of varying stiffness; InputError where it would fall to nothing."""
    varied = [(row, spring) for row, spring in enumerate(springs) if spring.stiffness_waves]
    for _, spring in varied:
        swing = sum(abs(wave.amplitude) for wave in spring.stiffness_waves)
        if swing >= 1:
            raise InputError(
                f"{spring.name}: its stiffness varies by {swing:.3g} of its mean, so that it would not be above 0 at "
                "all angles; make the sum of the amplitudes smaller than 1"
            )
    waves = _phased([(f"{s.name}.stiffness", number[s.b], s.stiffness_waves) for _, s in varied], table, seed)
    return Varied(
        spring=_rows(row for row, _ in varied),
        damping_follows=_rows(s.damping_follows for _, s in varied),
        first=waves.first,
        slot=waves.slot,
        order=waves.order,
        c=waves.c,
        s=waves.s,
    )


def harmonics_of(terms: Sequence[HarmonicTorque], number: Numbers, table: WaveTable, seed: int) -> Harmonics:
    """Return the periodic torques, one row per pair of nodes: what acts between the same two is one sum."""
    pairs = {(t.on, t.against): [u for u in terms if (u.on, u.against) == (t.on, t.against)] for t in terms if t.waves}
    waves = _phased([(t.name, number[t.angle], t.waves) for of in pairs.values() for t in of], table, seed)
    counts = [sum(len(t.waves) for t in of) for of in pairs.values()]
    return Harmonics(
        on=_rows(number[on] for on, _ in pairs),
        against=_rows(number[against] for _, against in pairs),
        first=np.cumsum([0, *counts], dtype=np.uint64),
        slot=waves.slot,
        c=waves.c,
        s=waves.s,
    )


def merged(terms: Sequence[Friction]) -> list[Friction]:
    """Return the same friction in fewer terms: what is only viscous or quadratic joins another term of its shafts."""
    dry = [term for term in terms if _grips(term)]
    smooth: dict[tuple[str, str], Friction] = {}
    for term in terms:
        if not _grips(term) and (term.viscous or term.viscous_backward or term.quadratic):
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
    return replace(
        term,
        viscous=term.viscous + drag.viscous,
        viscous_backward=_viscous_backward(term) + _viscous_backward(drag),
        quadratic=term.quadratic + drag.quadratic,
    )


def _viscous_backward(term: Friction) -> float:
    return term.viscous if term.viscous_backward is None else term.viscous_backward


def frictions_of(terms: Sequence[Friction], number: Numbers) -> Frictions:
    """Return the frictions; column 0 of what depends on the direction is backward."""
    coulomb = [(t.coulomb_backward, t.coulomb_forward) for t in terms]
    excess = [(t.static_backward - t.coulomb_backward, t.static_forward - t.coulomb_forward) for t in terms]
    return Frictions(
        on=_rows(number[t.on] for t in terms),
        against=_rows(number[t.against] for t in terms),
        coulomb=np.array(coulomb, dtype=np.float64).reshape(-1, 2),
        excess=np.array(excess, dtype=np.float64).reshape(-1, 2),
        inverse_stribeck=_floats(1 / t.stribeck for t in terms),
        viscous=_floats(t.viscous for t in terms),
        backward_extra=_floats(_viscous_backward(t) - t.viscous for t in terms),
        quadratic=_floats(t.quadratic for t in terms),
        inverse_smoothing=_floats(1 / t.smoothing for t in terms),
    )


def bristles_of(terms: Sequence[BristleFriction], number: Numbers) -> Bristles:
    """Return the bristle frictions; column 0 of what depends on the direction is backward."""
    for t in terms:
        if min(t.coulomb_forward, t.coulomb_backward, t.static_forward, t.static_backward, t.stiffness) <= 0:
            raise InputError(f"{t.name}: bristles need a stiffness, Coulomb and static torque above 0; state them")
    coulomb = [(t.coulomb_backward, t.coulomb_forward) for t in terms]
    excess = [(t.static_backward - t.coulomb_backward, t.static_forward - t.coulomb_forward) for t in terms]
    return Bristles(
        on=_rows(number[t.on] for t in terms),
        against=_rows(number[t.against] for t in terms),
        stiffness=_floats(t.stiffness for t in terms),
        damping=_floats(t.damping for t in terms),
        coulomb=np.array(coulomb, dtype=np.float64).reshape(-1, 2),
        excess=np.array(excess, dtype=np.float64).reshape(-1, 2),
        inverse_stribeck=_floats(1 / t.stribeck for t in terms),
        viscous=_floats(t.viscous for t in terms),
    )


def angle_loads_of(terms: Sequence[AngleLoad], number: Numbers, seed: int) -> AngleLoads:
    """Return the torques over the angle, drawn from the seed by their names."""
    grids = [t.process.sample(random_for(seed, t.name)) for t in terms]
    closed = [np.append(grid, grid[:1]) for grid in grids]
    return AngleLoads(
        on=_rows(number[t.on] for t in terms),
        inverse_smoothing=_floats(1 / t.smoothing for t in terms),
        points_per_radian=_floats(t.process.points_per_turn / (2 * pi) for t in terms),
        first=np.concatenate([[0], np.cumsum([grid.size for grid in closed])]).astype(np.int64),
        values=np.concatenate([*closed, np.zeros(0)]),
    )


def blades_of(terms: Sequence[BladeTorque], number: Numbers, table: WaveTable, seed: int) -> Blades:
    """Return the load pulses."""
    phases = [phase_of(t.name, Wave(order=t.order, amplitude=1.0, phase=t.phase), seed) for t in terms]
    return Blades(
        on=_rows(number[t.on] for t in terms),
        slot=_rows(table.slots[(number[t.on], t.order)] for t in terms),
        c=_floats(cos(phase) for phase in phases),
        s=_floats(sin(phase) for phase in phases),
        amplitude=_floats(t.amplitude for t in terms),
        inverse_smoothing=_floats(0.0 if t.one_way else 1 / t.smoothing for t in terms),
    )


def loads_of(terms: Sequence[Load | AppliedTorque], number: Numbers) -> Loads:
    """Return the torques over time, their samples still empty."""
    return Loads(
        on=_rows(number[t.on] for t in terms),
        inverse_smoothing=_floats(1 / t.smoothing if isinstance(t, Load) else 0.0 for t in terms),
        samples=UNFILLED,
    )


def sensings_of(terms: Sequence[Drive], number: Numbers, seed: int) -> Sensings:
    """Return what the drives see of their speeds."""
    senses = [(t.name, number[t.on], t.sensing.error) for t in terms]
    waves = _phased(senses, WaveTable.of((node, w.order) for _, node, ws in senses for w in ws), seed)
    return Sensings(
        ideal=_rows(t.sensing.ideal for t in terms),
        step=_floats(2 * pi / t.sensing.counts if t.sensing.counts else 0.0 for t in terms),
        filter_time=_floats(t.sensing.filter_time for t in terms),
        first=waves.first,
        order=waves.order,
        c=waves.c,
        s=waves.s,
    )


def imposed_of(terms: Sequence[ImposedMotion], number: Numbers, inertia: NDArray[np.float64]) -> Imposed:
    """Return the imposed motions, their angles, speeds and release still empty."""
    return Imposed(
        on=_rows(number[t.on] for t in terms),
        inertia=_floats(inertia[number[t.on]] for t in terms),
        release=np.zeros(0, dtype=np.int64),
        angle=UNFILLED,
        speed=UNFILLED,
    )


def drives_of(terms: Sequence[Drive], number: Numbers, table: WaveTable, seed: int) -> Drives:
    """Return the drives, their set-points and demands still empty."""
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
        breakdown=_floats(t.breakdown for t in terms),
        reference=UNFILLED,
        demand=UNFILLED,
    )


def _rows(values: object) -> NDArray[np.uint64]:
    return np.array(list(values), dtype=np.uint64)  # type: ignore[call-overload]


def _floats(values: object) -> NDArray[np.float64]:
    return np.array(list(values), dtype=np.float64)  # type: ignore[call-overload]
