"""Every motor x gearbox x filter of a study, on all cores."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed

from torquerig.rig.reading_place import reading_place
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.scenario.mean_load import mean_load
from torquerig.study.candidates import candidates, scenario_of
from torquerig.study.definition import Study
from torquerig.study.drive_run import run_drive
from torquerig.study.preflight import check_study
from torquerig.study.results import DriveResult, StudyRuns

Progress = Callable[[int, int, str], None]


def run_study(study: Study, *, progress: Progress | None = None, workers: int | None = None) -> StudyRuns:
    """Simulate and measure every candidate of a study.

    ``progress(done, total, name)`` is called after each drive. The result does not depend on the number of workers:
    every random number is determined by its seed and name. The compiled kernel and the transforms run outside the
    interpreter's lock, so threads are enough.

    Raises
    ------
    InputError
        For anything in the scenario, the filters or the catalog that cannot be used, before a run is started.
    """
    from threadpoolctl import threadpool_limits

    listed = candidates(study)
    scenarios = [scenario_of(one, study, seed=study.settings.seed) for one in listed]
    check_study(study, dict(zip(listed, scenarios, strict=True)))
    results: dict[int, DriveResult] = {}
    # linear algebra in several threads under several workers spins for minutes on two cores
    with threadpool_limits(limits=1, user_api="blas"), ThreadPoolExecutor(workers or os.cpu_count() or 1) as pool:
        jobs = {pool.submit(run_drive, one, study): row for row, one in enumerate(listed)}
        try:
            for done, job in enumerate(as_completed(jobs), start=1):
                results[jobs[job]] = job.result()
                if progress is not None:
                    progress(done, len(jobs), results[jobs[job]].candidate.name)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    rig, point = scenarios[0].rig, scenarios[0].operating_point
    run = rig.run
    return StudyRuns(
        study=study,
        drives=tuple(results[row] for row in range(len(listed))),
        mean_load=mean_load(scenarios[0].rig),
        occupancy_percent=point.load.occupancy,
        particle_size=point.load.particle_size,
        output_speed=(run.speed or 0.0) * turns_per_motor_turn(rig, reading_place(rig)),
    )
