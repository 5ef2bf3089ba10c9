"""The figures of drives at one draw each, by the compiled batch."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.cases import Case, Failed
from torquerig.cases.case import Scalar
from torquerig.catalog.chosen_draws import ChosenDraws
from torquerig.errors import InputError
from torquerig.filters.chains.all_chains import filtered_by
from torquerig.metrics.shares import sensed
from torquerig.metrics.truth_error import truth_error
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.simulation.batch_parts import BatchRun
from torquerig.simulation.true_lines import without_lines
from torquerig.simulation.united_runs import simulate_united, united
from torquerig.study.loop_figures import UNSTABLE
from torquerig.study.loop_margin import has_stable_loop
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, error_column, residual_column
from torquerig.study.monte_carlo.replayed_files import changed_file
from torquerig.study.planned_drive import sample_span
from torquerig.study.preflight import beyond_the_drive

Row = Mapping[str, Scalar]


@dataclass(frozen=True)
class _Drawn:
    """One case with its rig, and its rows of the batch: with and, where a criterion needs it, without lines."""

    scenario: Scenario
    runs: tuple[BatchRun, ...]


def drawn_rows(drawn: DrawnStudy, cases: Sequence[Case]) -> list[Row | Failed]:
    """Return the figures of each case: reading error behind each filter, and what else a criterion uses.

    All cases have the load of the study's seed; their draws change the drive. A draw whose speed loop is unstable has
    no figures, but the reason in ``out_of_reach``. Cases of one drive fill the vector registers best.
    """
    made = [_drawn(drawn, case) for case in cases]
    runs = [run for one in made if isinstance(one, _Drawn) for run in one.runs]
    recordings: dict[int, Recording] = {}
    for part in united(runs):
        found = simulate_united([runs[row] for row in part], draws=drawn.loads)
        recordings |= {id(runs[row]): one for row, one in zip(part, found, strict=True)}
    if changed := changed_file(drawn.replayed):  # after the runs, which read it
        said = f"{changed} changed while the study ran; delete the store and run the study again"
        return [Failed(said) for _ in cases]
    return [
        _measured(drawn, one, [recordings.pop(id(run)) for run in one.runs]) if isinstance(one, _Drawn) else one
        for one in made
    ]


def _drawn(drawn: DrawnStudy, case: Case) -> _Drawn | Row | Failed:
    study, name = drawn.study, str(case.values["drive"])
    stated = case.values.get("quantiles")
    seed = ChosenDraws(case.seed, json.loads(str(stated))) if stated else case.seed
    candidate = drawn.drives[name]
    try:
        scenario = drawn.scenario(name, seed=seed)
    except InputError as error:
        return Failed(str(error))
    reason = beyond_the_drive(candidate, scenario, study)
    if reason:
        return {"out_of_reach": reason}
    span = sample_span(scenario, study, number=case.seed - study.settings.seed)
    runs = [BatchRun.of(scenario.rig, span)]
    if not has_stable_loop(scenario.rig, rate=span.rate, lowered=runs[0].lowered):
        return {"out_of_reach": f"{UNSTABLE} at this draw; lower study: speed_loop: crossover"}
    if drawn.metrics & {"disturbance", "residual_disturbance"}:
        quiet = without_lines(scenario.rig)
        runs.append(BatchRun.of(quiet, span, staged="residual_disturbance" in drawn.metrics))
    return _Drawn(scenario, tuple(runs))


def _measured(drawn: DrawnStudy, one: _Drawn, recordings: Sequence[Recording]) -> Row:
    whole, *quiet = recordings
    chains = drawn.study.chains(one.scenario)
    calm = dict(filtered_by(chains, quiet[0])) if "residual_disturbance" in drawn.metrics else {}
    row: dict[str, Scalar] = {}
    for name, after in filtered_by(chains, whole):
        row[error_column(name)] = truth_error(after, whole)
        if calm:
            row[residual_column(name)] = float(np.std(after.torque() - calm[name].torque()))
    if "disturbance" in drawn.metrics:
        row["disturbance"] = float(np.std(sensed(whole) - sensed(quiet[0])))
    return row
