"""Every motor x gearbox x filter of a study: what is kept is read, the other drives are simulated."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from torquerig.study.kept_study import KeptStudy
from torquerig.study.results import DriveResult, Point, StudyRuns

if TYPE_CHECKING:
    from torquerig.cases.kept_results import KeptResults
    from torquerig.scenario.model import Scenario
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study

Progress = Callable[[int, int, str], None]


def run_study(
    study: Study, *, progress: Progress | None = None, workers: int | None = None, kept: KeptResults | None = None
) -> StudyRuns:
    """Simulate and measure every candidate of a study, or read what is kept of an earlier run.

    ``progress(done, total, name)`` is called after each drive. The result does not depend on the number of workers:
    every random number is determined by its seed and name. The compiled kernel and the transforms run outside the
    interpreter's lock, so threads are enough. It does not depend on what is kept either: a drive is kept under all that
    determines its figures, and as soon as it is measured, so that a run that is interrupted goes on where it was.

    Parameters
    ----------
    kept : KeptResults, optional
        Where results of drives are read and kept; nothing is kept when not given.

    Raises
    ------
    InputError
        For anything in the scenario, the filters or the catalog that cannot be used, before a run is started.
    """
    store = None if kept is None else KeptStudy(kept, study)
    listed = _listed(study, store)
    point = None if store is None else store.point(listed)
    found = {} if store is None else store.rows(listed)
    results, from_store = dict(found), len(found)
    if point is None or len(found) < len(listed):
        point = _completed(study, listed, results, store, progress=progress, workers=workers)
    keys = {} if store is None else {one.name: store.row_key(one) for one in listed}
    return StudyRuns(
        study=study, drives=tuple(results[one] for one in listed), from_store=from_store, kept=kept, row_keys=keys,
        **vars(point),
    )  # fmt: skip


def run_drive(candidate: Candidate, study: Study) -> DriveResult:
    """Return the results of one candidate alone: margins, shares of the reading, and every filter."""
    from torquerig.study.candidates import scenario_of
    from torquerig.study.simulated_drives import simulated_drives

    scenario = scenario_of(candidate, study, seed=study.settings.seed)
    return next(iter(simulated_drives({candidate: scenario}, study)))[1]


def drives_of(study: Study, kept: KeptResults | None = None) -> tuple[Candidate, ...]:
    """Return the drives of a study, kept or read from its scenario and catalog; errors as of :func:`run_study`."""
    return _listed(study, None if kept is None else KeptStudy(kept, study))


def _listed(study: Study, store: KeptStudy | None) -> tuple[Candidate, ...]:
    found = None if store is None else store.candidates()
    if found is None:
        from torquerig.study.candidates import candidates

        found = candidates(study)
        if store is not None:
            store.keep_candidates(found)
    return found


def _completed(
    study: Study, listed: tuple[Candidate, ...], results: dict[Candidate, DriveResult], store: KeptStudy | None, *,
    progress: Progress | None, workers: int | None,
) -> Point:  # fmt: skip
    """Check the study, add the results that are missing, and return the operating point."""
    from torquerig.study.candidates import scenario_of
    from torquerig.study.preflight import check_study
    from torquerig.study.simulated_drives import simulated_drives

    missing = [one for one in listed if one not in results]
    # a drive that is kept passed the check; it needs the present motor, and the operating point is that of the first
    checked = {*missing, listed[0], *(one for one in listed if one.motor == study.settings.present.motor)}
    scenarios = {one: scenario_of(one, study, seed=study.settings.seed) for one in listed if one in checked}
    check_study(study, scenarios)
    if missing and progress is not None:
        progress(len(results), len(listed), "")
    for row, result in simulated_drives({one: scenarios[one] for one in missing}, study, workers=workers):
        results[missing[row]] = result
        if store is not None:
            store.keep(result)
        if progress is not None:
            progress(len(results), len(listed), result.candidate.name)
    point = _point(scenarios[listed[0]])
    if store is not None:
        store.keep_point(listed, point)
    return point


def _point(scenario: Scenario) -> Point:
    from torquerig.rig.reading_place import reading_place
    from torquerig.rig.turns import turns_per_motor_turn
    from torquerig.scenario.mean_load import mean_load

    rig, load = scenario.rig, scenario.operating_point.load
    return Point(
        mean_load=mean_load(rig),
        occupancy_percent=load.occupancy,
        particle_size=load.particle_size,
        output_speed=(rig.run.speed or 0.0) * turns_per_motor_turn(rig, reading_place(rig)),
    )
