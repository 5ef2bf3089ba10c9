"""Exact recursion of a sampled linear system, a block of samples at a time, by matrix products.

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

from torquerig.simulation.twin import kernel
from torquerig.simulation.twin.line_inputs import LineInputs
from torquerig.simulation.twin.system import LinearSystem

Floats = NDArray[np.float64]

BLOCK = 32  # [samples] measured best for 10 states and 20 lines; longer ones multiply more zeros
CHUNK = 512  # [blocks] at a time, so that the matrices stay in the cache of the processor


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
    block, samples = step.block, inputs.shape[1]
    blocks, first_kept = -(-samples // block), skipped // block
    made = np.empty((len(outputs), (blocks - first_kept) * block))
    state, finite = start, True
    phasors = np.exp(1j * np.outer(np.arange(CHUNK), lines.angular * (block * period)))
    for first in range(0, blocks, CHUNK):
        now = phasors * np.exp(1j * lines.angular * (first * block * period))
        entering = _entering(inputs[:, first * block : (first + CHUNK) * block], now, block)
        states = np.empty((entering.shape[0] + 1, state.size))
        states[0] = state
        finite = kernel.carry(step.transition, entering @ step.onto_states, states) and finite
        state = states[-1]
        whole = np.hstack([states[:-1], entering])[max(0, first_kept - first) :]
        at = (max(first, first_kept) - first_kept) * block
        for row, output in enumerate(outputs):
            made[row, at : at + whole.shape[0] * block] = (whole @ step.onto_outputs[output]).ravel()
    within = skipped - first_kept * block
    return made[:, within : within + samples - skipped], bool(finite)


def _entering(inputs: Floats, phasors: NDArray[np.complex128], block: int) -> Floats:
    """Return what enters the blocks of a chunk beside their states, shape (blocks, 2 lines + inputs x block)."""
    m, samples = inputs.shape
    blocks = -(-samples // block)
    if samples < blocks * block:
        inputs = np.hstack([inputs, np.zeros((m, blocks * block - samples))])
    arriving = inputs.reshape(m, blocks, block).transpose(1, 0, 2).reshape(blocks, m * block)
    return np.hstack([phasors.real[:blocks], phasors.imag[:blocks], arriving])
