"""The runs of several drives of a study in batches, on all cores."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from typing import TYPE_CHECKING

from torquerig.simulation.inputs import Draws
from torquerig.simulation.reused_memory import ReusedMemory
from torquerig.simulation.united_runs import simulate_united, united
from torquerig.study.planned_drive import planned_drive
from torquerig.study.sample_runs import DriveSamples, SampleRun

if TYPE_CHECKING:
    from torquerig.scenario.model import Scenario
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study
    from torquerig.study.results import DriveResult

AT_ONCE = 10  # drives whose runs are in memory together; more fill the vector registers no better


def simulated_drives(
    scenarios: Mapping[Candidate, Scenario], study: Study, *, workers: int | None = None
) -> Iterator[tuple[int, DriveResult]]:
    """Yield the row and the results of each candidate, given with its scenario, as they are ready.

    The runs of all drives that are alike but for their lines go through the compiled batch together, whichever drive
    and sample they belong to; what is not needed any more is given up at once.
    """
    from threadpoolctl import threadpool_limits

    # linear algebra in several threads under several workers spins for minutes on two cores
    with threadpool_limits(limits=1, user_api="blas"), ThreadPoolExecutor(workers or os.cpu_count() or 1) as pool:
        try:
            draws, memory, listed = Draws(), ReusedMemory(), list(scenarios)
            by_stage = sorted(range(len(listed)), key=lambda row: listed[row].gearbox)  # of one speed and step
            waiting: dict[Future[list[int]], dict[int, DriveSamples]] = {}
            for first in range(0, len(listed), AT_ONCE):
                rows = by_stage[first : first + AT_ONCE]
                planned = (_planned(row, listed[row], scenarios[listed[row]], study) for row in rows)
                drives = {drive.row: drive for drive in planned}
                yield from ((row, drive.result()) for row, drive in drives.items() if not drive.planned.samples)
                runs = [run for drive in drives.values() for run in drive.runs()]
                queued = {pool.submit(_simulated, part, drives, draws, memory): drives for part in _parts(runs)}
                # the workers have the runs of these drives while those of the drives before are waited for
                yield from _completed(waiting)
                waiting = queued
            yield from _completed(waiting)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def _completed(jobs: Mapping[Future[list[int]], dict[int, DriveSamples]]) -> Iterator[tuple[int, DriveResult]]:
    """Yield the row and the results of each drive as its last run is measured."""
    for job in as_completed(jobs):
        yield from ((row, jobs[job][row].result()) for row in job.result())


def _parts(runs: Sequence[SampleRun]) -> list[list[SampleRun]]:
    """Return runs that go through the batch together; those of true values first, for they wait in less memory."""
    parts = [[runs[row] for row in part] for part in united([run.run for run in runs])]
    return sorted(parts, key=lambda part: part[0].run.staged)


def _planned(row: int, candidate: Candidate, scenario: Scenario, study: Study) -> DriveSamples:
    return DriveSamples(row, planned_drive(candidate, scenario, study), study)


def _simulated(
    part: Sequence[SampleRun], drives: dict[int, DriveSamples], draws: Draws, memory: ReusedMemory
) -> list[int]:
    """Simulate and measure some runs; return the rows of the drives that are complete."""
    title = drives[part[0].drive].planned.samples[0].title
    made = simulate_united([run.run for run in part], scenario=title, draws=draws, memory=memory.array)
    return [run.drive for run, recording in zip(part, made, strict=True) if drives[run.drive].add(run, recording)]
