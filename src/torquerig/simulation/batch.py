"""Many runs of similar rigs at once: eight per vector register, in parallel on all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np

from torquerig.errors import InputError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation.arrays import Floats
from torquerig.simulation.batch_parts import BatchRun, alike
from torquerig.simulation.inputs import Draws, Span
from torquerig.simulation.kernel.lanes import LANES
from torquerig.simulation.kernel.side_by_side import integrate_together
from torquerig.simulation.lost_friction import friction_lost
from torquerig.simulation.motor_limit import limits_reached
from torquerig.simulation.outputs import as_arrays
from torquerig.simulation.ready import Ready, ready
from torquerig.simulation.sampling import SAMPLE_RATE, SETTLING
from torquerig.simulation.simulator import checked, recorded, stepped
from torquerig.simulation.step_watch import ALLOWED, OF_HALF, has_gaps, rms

_Way = Callable[[Sequence[Ready], Sequence[bool]], list[Recording]]

FIRST = 0.5  # [s] of a run without gaps that is repeated with half the step
WORTHWHILE = 2  # rigs from which on a step of all lanes (76 ns) takes less time than one step of each (50 ns)


def simulate_batch(
    rigs: Sequence[Rig], *, seeds: Sequence[int], duration: float, sample_rate: float = SAMPLE_RATE,
    wander: float | Sequence[float] = 0.0, settling: float = SETTLING, scenario: str = "", substeps: int | None = None,
    most_steps: int | None = None, workers: int | None = None,
) -> list[Recording]:  # fmt: skip
    """Return the recordings that ``simulate`` returns for each of the rigs, computed together.

    Rigs of one shape (the same parts and effects, other numbers) are stepped together; what is like no other is
    simulated by itself. The arithmetic is that of ``simulate``, in the same order, so that the recordings are equal.

    Where neither ``substeps`` nor ``most_steps`` is given, the step is checked: rigs that are stepped together run
    again with half the step, those without gaps for their first ``FIRST`` s. Where that changes what is measured by
    more than half of ``step_watch.ALLOWED``, the rig is simulated by itself, with the warnings of ``simulate``.

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

    way = _checked if substeps is None and most_steps is None else _stepped

    def of_part(part: Sequence[int]) -> list[Recording]:
        here = [runs[row] for row in part]
        made = _prepared(here, scenario=scenario, substeps=substeps, most_steps=most_steps, draws=Draws())
        return _together(made, [run.staged for run in here], way)

    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        done = {row: made for part, each in zip(parts, pool.map(of_part, parts), strict=True)
                for row, made in zip(part, each, strict=True)}  # fmt: skip
    return [done[row] for row in range(len(rigs))]


def simulate_part(
    runs: Sequence[BatchRun], *, scenario: str = "", substeps: int | None = None, most_steps: int | None = None,
    draws: Draws | None = None,
) -> list[Recording]:  # fmt: skip
    """Return the recordings of at most ``LANES`` runs that are alike, their step unchecked.

    Parameters
    ----------
    draws : Draws, optional
        Where the random loads are kept for other runs of the same load; drawn anew for each part when not given.
    """
    held = Draws() if draws is None else draws
    prepared = _prepared(runs, scenario=scenario, substeps=substeps, most_steps=most_steps, draws=held)
    return _together(prepared, [run.staged for run in runs], _stepped)


def _prepared(
    runs: Sequence[BatchRun], *, scenario: str, substeps: int | None, most_steps: int | None, draws: Draws
) -> list[Ready]:
    return [
        replace(
            ready(run.rig, run.span, lowered=run.lowered, scenario=scenario, substeps=substeps, most_steps=most_steps,
                  draws=draws),
            outputs=run.outputs,
        )
        for run in runs
    ]  # fmt: skip


def _together(runs: Sequence[Ready], staged: Sequence[bool], way: _Way) -> list[Recording]:
    """Return the recordings of runs that differ only in their step size."""
    done: dict[int, Recording] = {}
    for steps in dict.fromkeys(run.steps for run in runs):
        rows = [row for row, run in enumerate(runs) if run.steps == steps]
        done |= zip(rows, way([runs[row] for row in rows], [staged[row] for row in rows]), strict=True)
    return [done[row] for row in range(len(runs))]


def _stepped(runs: Sequence[Ready], staged: Sequence[bool]) -> list[Recording]:
    """Return the recordings of runs of one step size, unchecked."""
    kept = _kept(runs) if len(runs) >= WORTHWHILE else None
    if kept is None:  # singly, so that each of the others is there and the one that fails says why
        return [stepped(run, staged=each) for run, each in zip(runs, staged, strict=True)]
    return [
        recorded(run.rig, run.outputs, values, rate=run.span.rate, origin=run.origin, staged=each)
        for run, values, each in zip(runs, kept, staged, strict=True)
    ]


def _checked(runs: Sequence[Ready], staged: Sequence[bool]) -> list[Recording]:
    """Return the recordings of runs of one step size with their warnings; all of them staged."""
    kept = _kept(runs) if len(runs) >= WORTHWHILE else None
    changes = None if kept is None else _changes(runs, kept)
    if kept is None or changes is None:
        return [checked(run) for run in runs]
    made = []
    for run, values, change in zip(runs, kept, changes, strict=True):
        if change > OF_HALF * ALLOWED:
            made.append(checked(run))
            continue
        warnings = [*limits_reached(run, values), *friction_lost(run, values)]
        origin = {**run.origin, "warnings": warnings} if warnings else run.origin
        made.append(recorded(run.rig, run.outputs, values, rate=run.span.rate, origin=origin))
    return made


def _changes(runs: Sequence[Ready], kept: Floats) -> list[float] | None:
    """Return the rms change by half the step of what is measured, over its rms [1]; None where a run fails.

    Of rigs with gaps the whole run is repeated, because impacts come at any time; of others the first ``FIRST`` s of
    it, with the step of the run and half of it.
    """
    whole = has_gaps(runs[0])
    if whole:
        coarse: Floats | None = kept
    else:
        runs = [replace(run, span=_first(run.span)) for run in runs]
        coarse = _kept([replace(run, outputs=run.outputs[:1]) for run in runs])
    fine = _kept([replace(run, steps=2 * run.steps, outputs=run.outputs[:1]) for run in runs])
    if coarse is None or fine is None:
        return None
    sizes = [rms(one[0]) for one in coarse]
    return [
        rms(after[0] - before[0]) / size if size else 0.0
        for before, after, size in zip(coarse, fine, sizes, strict=True)
    ]


def _first(span: Span) -> Span:
    """Return the start of a run, its settling kept as well."""
    return replace(span, settling=0, samples=min(span.settling + span.samples, max(2, round(FIRST * span.rate))))


def _kept(runs: Sequence[Ready]) -> Floats | None:
    """Return the outputs of runs of one step size, shape (runs, outputs, samples); None where one of them fails."""
    first, starts = runs[0], [run.start() for run in runs]
    kept, finished, _ = integrate_together(
        [theta for theta, _ in starts], [omega for _, omega in starts], [run.terms for run in runs],
        as_arrays(first.outputs), first.span.rate, first.span.settling, first.steps, first.span.samples,
    )  # fmt: skip
    # where few lanes have a rig a copy frees the memory of the others
    return None if not finished else kept if 2 * len(runs) > LANES else kept.copy()
