"""Transfers of a rig's shafts to its reading, solved once on a grid of frequencies and shared by like runs."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.linear_twin.kernel import between_points
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import GROUND, Drive, Friction, Inertia, Spring, Term
from torquerig.simulation.linear import Matrices, matrices
from torquerig.simulation.lower import lower_terms

Response = NDArray[np.complex128]

_FINE, _COARSE = 40, 8  # points per octave, where shafts ring and elsewhere
_RINGING = (10.0, 1500.0)  # [Hz]
_RANGE = (0.04, 13_000.0)  # [Hz]
_SHARP = 0.03  # damping ratio below which a mode needs points of its own
_BESIDE = np.array([0.2, 0.5, 0.85, 1.2, 1.6, 2.1, 2.7, 3.4, 4.3, 5.5, 7.0, 9.0, 12.0, 17.0])  # [half-widths]
_AROUND = np.concatenate([-_BESIDE[::-1], [0.0], _BESIDE])
_KEPT = 64


@dataclass(frozen=True, eq=False)
class Shafts:
    """Responses to a torque on each node, on a grid that is finer around lightly damped modes.

    Parameters
    ----------
    frequency : ndarray, shape (points,)
        [Hz], ascending.
    reading : dict of ndarray, shape (points,)
        Torque in the measured spring per torque on a node [1].
    drive : dict of ndarray, shape (points,)
        Torque that the speed loop answers with [1]; empty without a speed loop.
    angle : dict of ndarray, shape (points,)
        By which the motor's shaft sways [rad/(N m)]; empty without a speed loop.
    angles : dict of dict of ndarray, shape (points,)
        By which each node sways per torque on each node [rad/(N m)].
    """

    frequency: NDArray[np.float64]
    reading: dict[str, Response]
    drive: dict[str, Response]
    angle: dict[str, Response]
    angles: dict[str, dict[str, Response]]

    def at(self, response: Response, frequencies: NDArray[np.float64]) -> Response:
        """Return a response at other frequencies [Hz], by its real and imaginary part over the logarithm."""
        return np.asarray(self.each_at([response], frequencies[None])[0])

    def each_at(
        self, responses: Sequence[Response], frequencies: NDArray[np.float64], which: NDArray[np.intp] | None = None
    ) -> Response:
        """Return responses at frequencies [Hz], shape (n, points): each at its own row, or ``which`` says whose it is.

        Parameters
        ----------
        responses : sequence of ndarray, shape (grid points,)
        frequencies : ndarray, shape (n, points)
        which : ndarray, shape (n,), optional
            The response that each row is of.
        """
        different = {id(response): response for response in responses}
        named = {each: row for row, each in enumerate(different)}
        row = np.array([named[id(response)] for response in responses], dtype=np.intp)
        table = np.stack(list(different.values()))
        own = row if which is None else row[which]
        return np.asarray(between_points(table, self._log, own, np.log(np.clip(frequencies, *_RANGE))))

    @cached_property
    def _log(self) -> NDArray[np.float64]:
        return np.log(self.frequency)


_solved: OrderedDict[Hashable, Shafts] = OrderedDict()


def _even_grid() -> NDArray[np.float64]:
    edges = [_RANGE[0], *_RINGING, _RANGE[1]]
    parts = [
        np.geomspace(low, high, int(np.log2(high / low) * density), endpoint=False)
        for low, high, density in zip(edges[:-1], edges[1:], (_COARSE, _FINE, _COARSE), strict=True)
    ]
    return np.concatenate([*parts, [_RANGE[1]]])


_EVEN = _even_grid()


def on_grid(rig: Rig, terms: Sequence[Term]) -> Shafts:
    """Return the transfers of a torque on each node.

    The speed loops are closed, the sampled control taken as continuous (true far below the sample rate); losses of the
    gears are those of power that flows to the load.
    """
    structure = _structure(terms)
    key = (rig.measured, structure)
    if key not in _solved:
        _solved[key] = _solve(rig.measured, structure)
        if len(_solved) > _KEPT:
            _solved.popitem(last=False)
    _solved.move_to_end(key)
    return _solved[key]


def _structure(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Return what the transfers depend on: inertias, springs, viscous friction, controllers."""
    kept: list[Term] = []
    for term in terms:
        if isinstance(term, Inertia):
            kept.append(term)
        elif isinstance(term, Spring):
            waves = term.error or term.stiffness_waves
            kept.append(replace(term, error=(), stiffness_waves=()) if waves else term)
        elif isinstance(term, Friction):
            kept.append(Friction(name=term.name, on=term.on, against=term.against, viscous=term.viscous))
        elif isinstance(term, Drive):
            kept.append(replace(term, ripple=()) if term.ripple else term)
    return tuple(kept)


def _solve(measured: str, terms: Sequence[Term]) -> Shafts:
    system = matrices(lower_terms(terms, 0))
    grid = _refined(system)
    s = 2j * pi * grid
    wide = s[:, None, None]
    dynamic = np.asarray(wide**2 * system.mass + wide * system.damping + system.stiffness, dtype=np.complex128)
    row = {name: index for index, name in enumerate(system.nodes)}
    for lossy in (term for term in terms if isinstance(term, Spring) and term.efficiency < 1):
        share = (1 / lossy.efficiency - 1) / lossy.ratio
        back = np.asarray(share * (lossy.stiffness + s * lossy.damping), dtype=np.complex128)
        dynamic[:, row[lossy.a], row[lossy.a]] += back / lossy.ratio
        dynamic[:, row[lossy.a], row[lossy.b]] -= back
    drives = [term for term in terms if isinstance(term, Drive)]
    loops = [np.asarray((drive.kp * s + drive.ki) / (1 + s * drive.lag)) for drive in drives]
    for drive, loop in zip(drives, loops, strict=True):  # its encoder sees the rotor against the housing
        for on, sign in _ends(drive, row):
            for seen, way in _ends(drive, row):
                dynamic[:, on, seen] += sign * way * loop
    spring = next(term for term in terms if isinstance(term, Spring) and term.name == measured)
    count, first = len(row), 1 + len(drives[:1])
    asked = np.zeros((s.size, count, first + count), dtype=complex)
    asked[:, :, first:] = np.eye(count)
    for node, lever in ((spring.a, 1 / spring.ratio), (spring.b, -1.0)):
        if node != GROUND:
            asked[:, row[node], 0] += lever
    for seen, way in _ends(drives[0], row) if drives else ():
        asked[:, seen, 1] = way
    adjoint = np.linalg.solve(np.transpose(dynamic, (0, 2, 1)), asked)
    force = spring.stiffness + s * spring.damping
    reading = {name: np.asarray(force * adjoint[:, at, 0], dtype=np.complex128) for name, at in row.items()}
    angle = {name: np.asarray(adjoint[:, at, 1], dtype=np.complex128) for name, at in row.items() if drives}
    angles = {name: {on: np.asarray(adjoint[:, other, first + at], dtype=np.complex128) for on, other in row.items()}
              for name, at in row.items()}  # fmt: skip
    answered = {name: np.asarray(-loops[0] * swayed) for name, swayed in angle.items()}
    return Shafts(grid, reading, answered, angle, angles)


def _ends(drive: Drive, row: Mapping[str, int]) -> list[tuple[int, float]]:
    """Return the nodes between which a drive acts, with the sign of its torque; without the frame."""
    return [(row[node], sign) for node, sign in ((drive.on, 1.0), (drive.against, -1.0)) if node != GROUND]


def _refined(system: Matrices) -> NDArray[np.float64]:
    """Return the even grid with points around each lightly damped mode, within its half-widths."""
    from scipy.linalg import eigh

    squares, shapes = eigh(system.stiffness, system.mass)
    modal = np.einsum("ij,ik,kj->j", shapes, system.damping, shapes)  # 2 zeta omega, shapes being of unit modal mass
    omega = np.sqrt(np.maximum(squares, 0.0))
    rings = (omega > 2 * pi * _RINGING[0]) & (omega < 2 * pi * _RINGING[1]) & (modal < 2 * _SHARP * omega)
    own = [omega[rings, None] / (2 * pi) * np.exp(0.5 * (modal / np.maximum(omega, 1.0))[rings, None] * _AROUND)]
    return np.unique(np.concatenate([_EVEN, *own], axis=None))
