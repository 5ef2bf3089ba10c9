"""Runs of rigs that are alike but for their lines and their steps, stepped together eight at a time.

Two things fill the vector registers: waves of one structure (``shared_waves``), and few numbers of steps a sample.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.simulation import kernel
from torquerig.simulation.arrays import Floats
from torquerig.simulation.batch_parts import BatchRun
from torquerig.simulation.inputs import Draws
from torquerig.simulation.kernel.lanes import LANES
from torquerig.simulation.kernel.side_by_side import Memory, integrate_together
from torquerig.simulation.kernel.work import work_for
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.shared_waves import can_share_waves, with_shared_waves
from torquerig.simulation.simulator import recorded


def united(runs: Sequence[BatchRun]) -> list[list[int]]:
    """Return the rows of runs that can be stepped together, in parts of about the same size that fit the lanes.

    They need not have the same lines. Runs with many lines are together: a part takes as long as its longest.
    """
    found: dict[tuple[Hashable, int], list[int]] = {}
    draws = Draws()
    for row, run in enumerate(runs):
        steps = shared_steps(run.steps_without_impacts(draws))
        found.setdefault((run.likeness_but_for_waves, steps), []).append(row)
    parts = []
    for _, rows in sorted(found.items(), key=lambda item: -item[0][1]):  # the longest first
        rows.sort(key=lambda row: runs[row].number_of_waves)
        parts += [[int(row) for row in part] for part in np.array_split(rows, -(-len(rows) // LANES))]
    return parts


def shared_steps(steps: int) -> int:
    """Return the next of 1, 2, 4, 6, 8, 12, 16, 24, 32, ...: few numbers, so that many runs have the same.

    A run is the more accurate for it. From 4 on it takes half as many steps more at most.
    """
    power: int = 1 << (steps - 1).bit_length()
    return 3 * power // 4 if power > 4 and steps <= 3 * power // 4 else power


def simulate_united(
    runs: Sequence[BatchRun], *, scenario: str = "", draws: Draws | None = None, memory: Memory = np.empty
) -> list[Recording]:
    """Return the recordings of at most ``LANES`` runs of a part of ``united``, their step unchecked.

    A rig is stepped as ``step_without_impacts`` says. Where the flanks of a gap met or parted while samples were kept,
    it is simulated again with the steps of ``step_choice``. What a run gets does not depend on the others of its part.

    Parameters
    ----------
    draws : Draws, optional
        Where the random loads are kept for other runs of the same load.
    memory : callable
        Returns an array of a shape for the outputs. The true channels of the recordings are parts of it.

    Raises
    ------
    SimulationError
        As ``simulate`` does, for the first rig that fails.
    """
    held = Draws() if draws is None else draws
    whole = [_prepared(run, scenario=scenario, draws=held) for run in runs]
    done = [_without_impacts(run) for run in whole]
    made = _integrated(done, memory)
    again = [row for row, each in enumerate(made) if each.unsure and whole[row].steps > done[row].steps]
    for row, each in zip(again, _integrated([whole[row] for row in again], np.empty), strict=True):
        done[row], made[row] = whole[row], each
    for run, each in zip(done, made, strict=True):
        if each.failed[0] >= 0:
            raise run.failure(*each.failed)
    return [
        recorded(one.rig, one.outputs, each.kept, rate=one.span.rate, origin=one.origin, staged=run.staged)
        for run, one, each in zip(runs, done, made, strict=True)
    ]


class _Made(NamedTuple):
    """The outputs of a run, whether flanks met or parted, and the sample and node where a speed ceased to be finite."""

    kept: Floats
    parted: bool
    failed: tuple[int, int] = (-1, -1)

    @property
    def unsure(self) -> bool:
        """Whether it needs the steps of a rig whose flanks meet."""
        return self.parted or self.failed[0] >= 0


def _prepared(run: BatchRun, *, scenario: str, draws: Draws) -> Ready:
    made = replace(ready(run.rig, run.span, lowered=run.lowered, scenario=scenario, draws=draws), outputs=run.outputs)
    return _with_steps(made, shared_steps(made.steps))


def _without_impacts(run: Ready) -> Ready:
    return _with_steps(run, shared_steps(run.steps_without_impacts))


def _with_steps(run: Ready, steps: int) -> Ready:
    return run if run.steps == steps else replace(run, steps=steps, origin={**run.origin, "substeps": steps})


def _integrated(runs: Sequence[Ready], memory: Memory) -> list[_Made]:
    """Return what runs, which may differ in their steps, make."""
    made: dict[int, _Made] = {}
    for steps in dict.fromkeys(run.steps for run in runs):
        rows = [row for row, run in enumerate(runs) if run.steps == steps]
        # memory that is used again holds one result at a time
        given = memory if len(rows) == len(runs) else np.empty
        made |= zip(rows, _stepped([runs[row] for row in rows], given), strict=True)
    return [made[row] for row in range(len(runs))]


def _stepped(runs: Sequence[Ready], memory: Memory) -> list[_Made]:
    if all(can_share_waves(run.terms) for run in runs):
        shared = with_shared_waves([run.terms for run in runs])
        runs = [replace(run, terms=terms) for run, terms in zip(runs, shared, strict=True)]
    if len(runs) > 1:
        first, starts = runs[0], [run.start() for run in runs]
        kept, finished, parted = integrate_together(
            [theta for theta, _ in starts], [omega for _, omega in starts], [run.terms for run in runs],
            as_arrays(first.outputs), first.span.rate, first.span.settling, first.steps, first.span.samples,
            memory=memory,
        )  # fmt: skip
        if finished:
            return [_Made(each, bool(met)) for each, met in zip(kept, parted, strict=True)]
    return [_alone(run) for run in runs]  # so that each of the others is there and the one that fails says why


def _alone(run: Ready) -> _Made:
    span, work, (theta, omega) = run.span, work_for(run.terms), run.start()
    kept = np.empty((len(run.outputs), span.samples))
    failed = kernel.integrate_part(
        theta, omega, work, run.terms, as_arrays(run.outputs), span.rate, span.settling, run.steps, kept,
        slice(0, span.settling + span.samples),
    )  # fmt: skip
    return _Made(kept, bool(work.parted[0] > 0), failed)
