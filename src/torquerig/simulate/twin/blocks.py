"""A sampled linear system through many samples, exactly, a block of samples at a time by matrix products.

The state-space recursion ``x[k+1] = A x[k] + B u[k]`` is the same whether it is done one sample or thirty-two at a
time. In blocks nearly all of its work is a product of two large matrices, which is what processors do fastest, and no
eigenvectors are needed: a double root (a shaft that turns freely) is as good as any. Transfer-function coefficients,
which lose digits on stiff plants, occur nowhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.simulate.twin import kernel
from torquerig.simulate.twin.line_inputs import LineInputs
from torquerig.simulate.twin.system import LinearSystem

Floats = NDArray[np.float64]

BLOCK = (
    32  # [samples] measured best for 10 states and 20 lines: longer ones multiply more zeros, shorter ones loop more
)


@dataclass(frozen=True)
class Lifted:
    """A block of samples as one step.

    Rows of ``onto_states`` and ``onto_outputs`` are what a block starts from: states, then cosine and sine of each
    line, then the inputs of its samples, input by input.

    Parameters
    ----------
    transition : ndarray, shape (states, states)
        States after a block per states before it.
    onto_states : ndarray, shape (rows, states)
        Without the rows of the states themselves.
    onto_outputs : ndarray, shape (outputs, states + rows, block)
    """

    transition: Floats
    onto_states: Floats
    onto_outputs: Floats
    block: int


def lifted(system: LinearSystem, lines: LineInputs, *, block: int = BLOCK) -> Lifted:
    """Return ``block`` samples of a sampled system as one step, by running the recursion on unit inputs."""
    n, m, count = len(system.states), len(system.inputs), lines.angular.size
    turn = np.exp(1j * lines.angular * system.period)
    width = n + 2 * count + m * block
    state = np.zeros((n, width))
    state[:, :n] = np.eye(n)
    outputs = np.zeros((block, len(system.outputs), width))
    phasors = np.ones(count, dtype=np.complex128)
    for sample in range(block):
        into, out = lines.onto_states * phasors, lines.onto_outputs * phasors
        at = n + 2 * count + sample + block * np.arange(m)
        outputs[sample] = system.C @ state
        outputs[sample][:, n : n + 2 * count] += np.hstack([out.real, -out.imag])
        outputs[sample][:, at] += system.D
        state = system.A @ state
        state[:, n : n + 2 * count] += np.hstack([into.real, -into.imag])
        state[:, at] += system.B
        phasors = phasors * turn
    return Lifted(state[:, :n].copy(), state[:, n:].T.copy(), np.ascontiguousarray(outputs.transpose(1, 2, 0)), block)


def run(
    step: Lifted,
    lines: LineInputs,
    *,
    period: float,
    start: Floats,
    inputs: Floats,
    skipped: int,
    outputs: Sequence[int],
) -> tuple[Floats, bool]:
    """Return the outputs at each sample, and whether all stayed finite.

    Parameters
    ----------
    start : ndarray, shape (states,)
    inputs : ndarray, shape (inputs, samples)
    skipped : int
        Samples at the start that are run through and not returned.
    outputs : sequence of int
        Rows of the system's outputs to return.

    Returns
    -------
    values : ndarray, shape (outputs, samples - skipped)
    """
    block, n, count = step.block, start.size, lines.angular.size
    m, samples = inputs.shape
    blocks = -(-samples // block)
    entering = np.empty((blocks, n + 2 * count + m * block))
    phasors = turning(lines.angular * (block * period), blocks)
    entering[:, n : n + count], entering[:, n + count : n + 2 * count] = phasors.real, phasors.imag
    whole = samples // block
    for row in range(m):
        at = n + 2 * count + row * block
        entering[:whole, at : at + block] = inputs[row, : whole * block].reshape(whole, block)
        if whole < blocks:
            entering[whole, at : at + block] = 0.0
            entering[whole, at : at + samples - whole * block] = inputs[row, whole * block :]
    states = np.zeros((blocks + 1, n))
    states[0] = start
    finite = kernel.carry(step.transition, entering[:, n:] @ step.onto_states, states)
    entering[:, :n] = states[:-1]
    first = skipped // block
    made = np.empty((len(outputs), samples - skipped))
    for row, output in enumerate(outputs):
        values = (entering[first:] @ step.onto_outputs[output]).ravel()
        made[row] = values[skipped - first * block : samples - first * block]
    return made, bool(finite)


def turning(angles: Floats, count: int) -> NDArray[np.complex128]:
    """Return ``exp(i k angles)`` for k = 0 .. count - 1, shape (count, angles): coarse turns times fine ones."""
    fine = np.exp(1j * np.outer(np.arange(64), angles))
    coarse = np.exp(64j * np.outer(np.arange(-(-count // 64)), angles))
    return np.asarray((coarse[:, None, :] * fine[None, :, :]).reshape(-1, angles.size)[:count])
