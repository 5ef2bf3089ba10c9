"""Many runs of similar rigs at once: eight per vector register, in parallel on all cores."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation.batch_parts import BatchRun, alike
from torquerig.simulation.inputs import Draws, Span
from torquerig.simulation.kernel.side_by_side import integrate_together
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.simulator import SAMPLE_RATE, SETTLING, recorded, stepped

WORTHWHILE = 2  # rigs from which on a step of all lanes (76 ns) takes less time than one step of each (50 ns)


def simulate_batch(
    rigs: Sequence[Rig], *, seeds: Sequence[int], duration: float, sample_rate: float = SAMPLE_RATE,
    wander: float | Sequence[float] = 0.0, settling: float = SETTLING, scenario: str = "", substeps: int | None = None,
    most_steps: int | None = None, workers: int | None = None,
) -> list[Recording]:  # fmt: skip
    """Return the recordings that ``simulate`` returns for each of the rigs, computed together.

    Rigs of one shape (the same parts and effects, other numbers) are stepped together; what is like no other is
    simulated by itself. The arithmetic is that of ``simulate``, in the same order, so that the recordings are equal.

    Parameters
    ----------
    seeds : sequence of int
        One for each rig.
    duration, sample_rate, settling, substeps, most_steps
        As ``simulate`` takes them, for all rigs.
    wander : float or sequence of float
        Relative rms of the slow wander of the speed [1], of all or of each.
    workers : int, optional
        Threads; one a core when not given.

    Raises
    ------
    InputError
        When there is not one seed for each rig.
    SimulationError
        As ``simulate`` does, for the first rig that fails.
    """
    if len(rigs) != len(seeds):
        raise InputError(f"{len(rigs)} rigs and {len(seeds)} seeds: give one seed for each rig")
    spans = [
        Span.of(duration=duration, settling=settling, rate=sample_rate, seed=seed, wander=float(each))
        for seed, each in zip(seeds, np.broadcast_to(wander, len(seeds)), strict=True)
    ]
    runs = [BatchRun.of(rig, span) for rig, span in zip(rigs, spans, strict=True)]
    parts = alike(runs)

    def of_part(part: Sequence[int]) -> list[Recording]:
        return simulate_part([runs[row] for row in part], scenario=scenario, substeps=substeps, most_steps=most_steps)

    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        done = {row: made for part, each in zip(parts, pool.map(of_part, parts), strict=True)
                for row, made in zip(part, each, strict=True)}  # fmt: skip
    return [done[row] for row in range(len(rigs))]


def simulate_part(
    runs: Sequence[BatchRun], *, scenario: str = "", substeps: int | None = None, most_steps: int | None = None,
    draws: Draws | None = None,
) -> list[Recording]:  # fmt: skip
    """Return the recordings of at most ``LANES`` runs that are alike.

    Parameters
    ----------
    draws : Draws, optional
        Where the random loads are kept for other runs of the same load; drawn anew for each part when not given.
    """
    held = Draws() if draws is None else draws
    prepared = [
        replace(
            ready(run.rig, run.span, lowered=run.lowered, scenario=scenario, substeps=substeps, most_steps=most_steps,
                  draws=held),
            outputs=run.outputs,
        )
        for run in runs
    ]  # fmt: skip
    return _together(prepared, [run.staged for run in runs])


def _together(runs: Sequence[Ready], staged: Sequence[bool]) -> list[Recording]:
    """Return the recordings of runs that differ only in their step size."""
    done: dict[int, Recording] = {}
    for steps in dict.fromkeys(run.steps for run in runs):
        rows = [row for row, run in enumerate(runs) if run.steps == steps]
        done |= zip(rows, _of_one_step([runs[row] for row in rows], [staged[row] for row in rows]), strict=True)
    return [done[row] for row in range(len(runs))]


def _of_one_step(runs: Sequence[Ready], staged: Sequence[bool]) -> list[Recording]:
    if len(runs) < WORTHWHILE:
        return [stepped(run, staged=each) for run, each in zip(runs, staged, strict=True)]
    first, starts = runs[0], [run.start() for run in runs]
    kept, finished = integrate_together(
        [theta for theta, _ in starts], [omega for _, omega in starts], [run.terms for run in runs],
        as_arrays(first.outputs), first.span.rate, first.span.settling, first.steps, first.span.samples,
    )  # fmt: skip
    if not finished:  # singly, so that each of the others is there and the one that fails says why
        return [stepped(run, staged=each) for run, each in zip(runs, staged, strict=True)]
    return [
        recorded(run.rig, run.outputs, values, rate=run.span.rate, origin=run.origin, staged=each)
        for run, values, each in zip(runs, kept, staged, strict=True)
    ]
