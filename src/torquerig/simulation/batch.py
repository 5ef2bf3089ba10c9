"""Many runs of similar rigs at once: eight per vector register, in parallel on all cores."""

from __future__ import annotations

import os
from collections.abc import Hashable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation.condensation.lowered_for import lower_for
from torquerig.simulation.inputs import Span, held_while_settling
from torquerig.simulation.kernel.lanes import LANES
from torquerig.simulation.kernel.side_by_side import integrate_together
from torquerig.simulation.outputs import as_arrays, outputs_of
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.simulator import SAMPLE_RATE, SETTLING, recorded, stepped
from torquerig.simulation.term_kinds import KINDS

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

    runs = list(zip(rigs, spans, strict=True))
    parts = _parts([_likeness(rig, span) for rig, span in runs])

    def of_part(part: Sequence[int]) -> list[Recording]:
        return _together(
            [ready(*runs[row], scenario=scenario, substeps=substeps, most_steps=most_steps) for row in part]
        )

    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        done = {row: made for part, each in zip(parts, pool.map(of_part, parts), strict=True)
                for row, made in zip(part, each, strict=True)}  # fmt: skip
    return [done[row] for row in range(len(rigs))]


def _likeness(rig: Rig, span: Span) -> Hashable:
    """Return the structure that rigs must share to be integrated together: all whole numbers and kinds of laws."""
    lowered = held_while_settling(lower_for(rig, span.seed, rate=span.rate), span)
    arrays = [(array, False) for array in lowered.arrays.waves]
    for kind in KINDS:
        rows = getattr(lowered.arrays, kind.field)
        arrays += [(array, name in kind.deciding) for name, array in rows._asdict().items()]
    shared = tuple((array.shape, _shared(array, decides=decides).tobytes()) for array, decides in arrays)
    return lowered.nodes, outputs_of(rig, lowered), shared


def _shared(array: NDArray[Any], *, decides: bool) -> NDArray[Any]:
    if array.dtype != np.float64:
        return array
    return array == 0 if decides else array[:0]


def _parts(likeness: Sequence[Hashable]) -> list[list[int]]:
    """Return the rows of rigs that are alike, in parts of about the same size that fit the lanes."""
    alike: dict[Hashable, list[int]] = {}
    for row, key in enumerate(likeness):
        alike.setdefault(key, []).append(row)
    return [
        [int(row) for row in part] for rows in alike.values() for part in np.array_split(rows, -(-len(rows) // LANES))
    ]


def _together(runs: Sequence[Ready]) -> list[Recording]:
    """Return the recordings of runs that differ only in their step size."""
    done: dict[int, Recording] = {}
    for steps in dict.fromkeys(run.steps for run in runs):
        rows = [row for row, run in enumerate(runs) if run.steps == steps]
        done |= zip(rows, _of_one_step([runs[row] for row in rows]), strict=True)
    return [done[row] for row in range(len(runs))]


def _of_one_step(runs: Sequence[Ready]) -> list[Recording]:
    if len(runs) < WORTHWHILE:
        return [stepped(run) for run in runs]
    first, starts = runs[0], [run.start() for run in runs]
    kept, finished = integrate_together(
        [theta for theta, _ in starts], [omega for _, omega in starts], [run.terms for run in runs],
        as_arrays(first.outputs), first.span.rate, first.span.settling, first.steps, first.span.samples,
    )  # fmt: skip
    if not finished:  # singly, so that each of the others is there and the one that fails says why
        return [stepped(run) for run in runs]
    return [
        recorded(run.rig, run.outputs, each, rate=run.span.rate, origin=run.origin)
        for run, each in zip(runs, kept, strict=True)
    ]
