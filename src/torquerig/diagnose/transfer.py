"""Transfers of a rig's shafts to its reading, solved once on a grid of frequencies and shared by like runs."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable, Sequence
from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.rig import Rig
from torquerig.rig.terms import Drive, Friction, Inertia, Spring, Term
from torquerig.simulate.linear import matrices
from torquerig.simulate.lower import lower

Response = NDArray[np.complex128]

_FINE, _COARSE = 40, 8  # points per octave, where shafts ring and elsewhere
_RINGING = (10.0, 1500.0)  # [Hz]
_RANGE = (0.04, 13_000.0)  # [Hz]
_KEPT = 64

_solved: OrderedDict[Hashable, dict[str, Response]] = OrderedDict()


def _grid() -> NDArray[np.float64]:
    edges = [_RANGE[0], *_RINGING, _RANGE[1]]
    parts = [
        np.geomspace(low, high, int(np.log2(high / low) * density), endpoint=False)
        for low, high, density in zip(edges[:-1], edges[1:], (_COARSE, _FINE, _COARSE), strict=True)
    ]
    return np.concatenate([*parts, [_RANGE[1]]])


GRID = _grid()
LOG_GRID = np.log(GRID)


def on_grid(rig: Rig, terms: Sequence[Term]) -> dict[str, Response]:
    """Return the transfer of a torque on each node to the torque in the measured spring [1], shapes (GRID.size,).

    The speed loops are closed, the sampled control taken as continuous (true far below the sample rate); losses of the
    gears are those of power that flows to the load.
    """
    key = (rig.measured, _structure(terms))
    if key not in _solved:
        _solved[key] = _solve(rig, terms)
        if len(_solved) > _KEPT:
            _solved.popitem(last=False)
    return _solved[key]


def at(response: Response, frequencies: NDArray[np.float64]) -> Response:
    """Return a response of the grid at other frequencies [Hz], by its real and imaginary part over the logarithm."""
    where = np.log(np.clip(frequencies, *_RANGE))
    return np.asarray(np.interp(where, LOG_GRID, response.real) + 1j * np.interp(where, LOG_GRID, response.imag))


def _structure(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Return what the transfers depend on: inertias, springs, viscous friction, controllers."""
    kept: list[Term] = []
    for term in terms:
        if isinstance(term, Inertia):
            kept.append(term)
        elif isinstance(term, Spring):
            kept.append(replace(term, error=()))
        elif isinstance(term, Friction):
            kept.append(Friction(name=term.name, on=term.on, against=term.against, viscous=term.viscous))
        elif isinstance(term, Drive):
            kept.append(replace(term, ripple=()))
    return tuple(kept)


def _solve(rig: Rig, terms: Sequence[Term]) -> dict[str, Response]:
    system, s = matrices(lower(rig, 0)), 2j * pi * GRID
    wide = s[:, None, None]
    dynamic = np.asarray(wide**2 * system.mass + wide * system.damping + system.stiffness, dtype=np.complex128)
    row = {name: index for index, name in enumerate(system.nodes)}
    for lossy in (term for term in terms if isinstance(term, Spring) and term.efficiency < 1):
        share = (1 / lossy.efficiency - 1) / lossy.ratio
        back = np.asarray(share * (lossy.stiffness + s * lossy.damping), dtype=np.complex128)
        dynamic[:, row[lossy.a], row[lossy.a]] += back / lossy.ratio
        dynamic[:, row[lossy.a], row[lossy.b]] -= back
    for drive in (term for term in terms if isinstance(term, Drive)):
        dynamic[:, row[drive.on], row[drive.on]] += (drive.kp * s + drive.ki) / (1 + s * drive.lag)
    spring = next(term for term in terms if isinstance(term, Spring) and term.name == rig.measured)
    twist = np.zeros((s.size, len(row), 1), dtype=complex)
    twist[:, row[spring.a], 0] += 1 / spring.ratio
    twist[:, row[spring.b], 0] -= 1.0
    adjoint = np.linalg.solve(np.transpose(dynamic, (0, 2, 1)), twist)[:, :, 0]
    force = spring.stiffness + s * spring.damping
    return {name: np.asarray(force * adjoint[:, index], dtype=np.complex128) for name, index in row.items()}
