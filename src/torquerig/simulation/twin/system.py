"""A linear system with names: state equations, transfers, and the same as python-control."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import UnknownNameError, did_you_mean

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LinearSystem:
    """``x' = A x + B u, y = C x + D u``, or ``x[k+1] = A x[k] + B u[k]`` where ``period`` is not 0; SI units.

    Parameters
    ----------
    A, B, C, D : ndarray
        Shapes (states, states), (states, inputs), (outputs, states), (outputs, inputs).
    states, inputs, outputs : tuple of str
        In the order of rows and columns.
    period : float
        [s]; 0 for a continuous system.
    """

    A: Floats
    B: Floats
    C: Floats
    D: Floats
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    period: float = 0.0

    def input(self, name: str) -> int:
        """Return the column of an input; UnknownNameError with the close matches where there is none."""
        return _place(name, self.inputs, "input")

    def output(self, name: str) -> int:
        """Return the row of an output; UnknownNameError with the close matches where there is none."""
        return _place(name, self.outputs, "output")

    def poles(self) -> NDArray[np.complex128]:
        """Return the eigenvalues in the s-plane [1/s]; those of a sampled system are taken back by ``ln z / period``.

        A sampled pole at 0 (dead beat) has no place in the s-plane and is left out.
        """
        found = np.asarray(self.to_control().poles(), dtype=np.complex128)
        return np.asarray(np.log(found[np.abs(found) > 1e-300]) / self.period) if self.period else found

    def response(self, frequencies: Floats) -> NDArray[np.complex128]:
        """Return all transfers at ``frequencies`` [Hz], shape (frequencies, outputs, inputs)."""
        s = 2j * np.pi * np.asarray(frequencies, dtype=np.float64)
        point = np.exp(s * self.period) if self.period else s
        pencil = point[:, None, None] * np.eye(len(self.states)) - self.A
        return np.asarray(self.C @ np.linalg.solve(pencil, self.B.astype(np.complex128)) + self.D)

    def transfer(self, cause: str, effect: str, frequencies: Floats) -> NDArray[np.complex128]:
        """Return the transfer from one input to one output, shape (frequencies,).

        A kinematic error acts by its value and by its rate, two inputs here; the transfer from ``error of G`` takes
        both.
        """
        found = self.response(frequencies)[:, self.output(effect), :]
        values = found[:, self.input(cause)]
        rate = cause.replace("error of ", "error rate of ", 1)
        if rate != cause and rate in self.inputs:
            values = values + 2j * np.pi * np.asarray(frequencies) * found[:, self.inputs.index(rate)]
        return np.asarray(values)

    def only(self, *, inputs: Sequence[str] | None = None, outputs: Sequence[str] | None = None) -> LinearSystem:
        """Return the same system with only the named inputs and outputs, in that order."""
        columns = [self.input(name) for name in (self.inputs if inputs is None else inputs)]
        rows = [self.output(name) for name in (self.outputs if outputs is None else outputs)]
        return LinearSystem(
            self.A, self.B[:, columns], self.C[rows], self.D[np.ix_(rows, columns)], self.states,
            tuple(self.inputs[column] for column in columns), tuple(self.outputs[row] for row in rows), self.period,
        )  # fmt: skip

    def to_control(self) -> Any:
        """Return a python-control StateSpace with the same names (``dt`` is the period where it is sampled)."""
        import control

        return control.ss(
            self.A, self.B, self.C, self.D, self.period or 0,
            inputs=list(self.inputs), outputs=list(self.outputs), states=list(self.states),
        )  # fmt: skip


def sampled(system: LinearSystem, period: float, *, held: Sequence[str] = ()) -> LinearSystem:
    """Return a continuous system sampled exactly: inputs in ``held`` constant over a period, the others straight lines.

    For an input that runs straight from u[k] to u[k+1], the state is moved by a constant times u[k] so that no u[k+1]
    is needed (Franklin, Powell & Workman, Digital Control of Dynamic Systems, section 4.3.2: triangle hold). Outputs
    are exact at the instants of the samples.
    """
    from scipy.linalg import expm

    n, m = system.B.shape
    block = np.zeros((n + 2 * m, n + 2 * m))
    block[:n, :n], block[:n, n : n + m] = system.A * period, system.B * period
    block[n : n + m, n + m :] = np.eye(m)
    power = expm(block)
    A, whole, ramp = power[:n, :n], power[:n, n : n + m], power[:n, n + m :]
    straight = np.array([name not in held for name in system.inputs], dtype=np.float64)
    ramp = ramp * straight
    B = whole - ramp + A @ ramp
    return LinearSystem(
        A, B, system.C, system.D + system.C @ ramp, system.states, system.inputs, system.outputs, period
    )


def _place(name: str, names: tuple[str, ...], what: str) -> int:
    if name not in names:
        raise UnknownNameError(f"the linear twin has no {what} {name!r}; {did_you_mean(name, names)}")
    return names.index(name)
