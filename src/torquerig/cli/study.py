"""``torquerig study``: thousands of draws of what the data sheets leave open, stored and resumed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option, set_option
from torquerig.cli.json_option import json_option
from torquerig.cli.progress import case_progress
from torquerig.document import read_document
from torquerig.plain_table import wrapped
from torquerig.reporting.json_results.draws import (
    DecisiveValue,
    DrawnCombination,
    OpenValue,
    StudyResult,
    drawn_combinations,
    open_values,
)
from torquerig.reporting.study.draws_text import (
    answer_text,
    convergence_text,
    left_out_text,
    lost_draws_text,
    ranked_draws_text,
)
from torquerig.reporting.study.sensitivity_text import asked_first_text, decisive_text, effects_text, too_few_text
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.left_out import left_out_gearboxes

if TYPE_CHECKING:
    from torquerig.cases.block import Engine
    from torquerig.study.monte_carlo.design import Method
    from torquerig.study.monte_carlo.lost_draws import LostDraws

_POINTS = {None: "draws", "sobol": "base points", "morris": "paths"}


@click.command("study")
@click.argument("scenario", type=click.Path(path_type=Path))
@click.option("--draws", type=click.IntRange(1), default=1000, show_default=True,
              help="Monte Carlo draws of each drive from the catalog's intervals.")  # fmt: skip
@click.option("--sensitivity", "method", type=click.Choice(["sobol", "morris"]), default=None,
              help="Which open value matters: by --draws base points (sobol) or paths (morris, quicker).")  # fmt: skip
@click.option("--store", type=click.Path(path_type=Path), default=None,
              help="Folder of the results, which later calls continue; default studies/NAME-OF-SCENARIO.")  # fmt: skip
@click.option("--workers", type=click.IntRange(1), default=None, help="Processes. Default: one per core.")
@click.option("--cluster", default=None, metavar="ADDRESS",
              help="Compute on a Dask cluster, such as tcp://host:8786, in place of this machine.")  # fmt: skip
@set_option
@catalog_option
@json_option("study", reads=("scenario",))
def command(
    *, scenario: Path, draws: int, method: Method | None, store: Path | None, workers: int | None, cluster: str | None,
    settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> StudyResult:  # fmt: skip
    """Compute the distribution of the reading error and of the ranking of SCENARIO's study over many draws.

    What is computed is kept in the store: a call that was stopped goes on where it was, and more draws are added to
    those that are there.

    Example: torquerig study scenarios/wear_rig.yaml --draws 1000 --set study.duration=2s
    """
    from torquerig.study.monte_carlo.drawn_study import drawn_study
    from torquerig.study.monte_carlo.running import run_design, run_draws

    if cluster is not None and workers is not None:
        raise click.UsageError("--workers is for this machine; a cluster has a fixed number; leave one of the two out")
    document = overridden(read_document(scenario), settings)
    study = open_study(document, catalog_for(scenario, catalogs))
    drawn, not_compared = drawn_study(study), wrapped(left_out_gearboxes(study))
    folder = store or Path("studies") / (f"{scenario.stem}-{method}" if method else scenario.stem)
    engine, unit = _engine(workers, cluster), drawn.study.effort_unit
    combinations: tuple[DrawnCombination, ...] = ()
    eliminated: dict[str, str] = {}
    lost: Mapping[str, LostDraws] = {}
    effects: tuple[OpenValue, ...] = ()
    decisive: tuple[DecisiveValue, ...] = ()
    with case_progress(f"{draws} {_POINTS[method]} of {len(drawn.drives)} drives") as progress:
        if method is None:
            found = run_draws(drawn, draws, folder=folder, engine=engine, progress=progress)
            texts = [
                wrapped(answer_text(found.ranking)), ranked_draws_text(drawn, found.ranking, found.tables),
                lost_draws_text(found.lost), convergence_text(found.ranking), left_out_text(drawn, found.ranking),
            ]  # fmt: skip
            run, sentence = found.run, answer_text(found.ranking)
            combinations, eliminated = drawn_combinations(drawn, found), dict(found.ranking.eliminated)
            lost = found.lost
        else:
            made = run_design(drawn, method, draws, folder=folder, engine=engine, progress=progress)
            texts = [
                too_few_text(made.found), wrapped(asked_first_text(made.found, unit=unit)), decisive_text(made.found),
                effects_text(made.found, made.design, unit=unit),
            ]  # fmt: skip
            run, sentence = made.run, asked_first_text(made.found, unit=unit)
            effects, decisive = open_values(made, unit=unit)
    click.echo("\n\n".join(text for text in (*texts, not_compared, *run.notes) if text))
    click.echo(f"\n{run.total} cases, {run.computed} of them computed now in {run.seconds:.1f} s")
    if run.failed or run.unfinished:
        click.echo(f"{run.failed} cases failed and {run.unfinished} are unfinished: see the column error")
    click.echo(f"rows: {run.folder}/rows/*.parquet")
    notes = (*([left_out_gearboxes(study)] if not_compared else []), *run.notes)
    return StudyResult(
        seed=study.settings.seed, method=method or "draws", sentence=sentence, combinations=combinations,
        eliminated=eliminated, not_simulated=dict(drawn.left_out), lost=lost, effects=effects, decisive=decisive,
        cases=run.total, failed=run.failed, unfinished=run.unfinished, notes=notes,
        rows=f"{run.folder.as_posix()}/rows/*.parquet",
    )  # fmt: skip


def _engine(workers: int | None, cluster: str | None) -> Engine:
    from torquerig.cases import ThisMachine

    if cluster is None:
        return ThisMachine(workers)
    from torquerig.cases.cluster import Cluster

    return Cluster(cluster)
