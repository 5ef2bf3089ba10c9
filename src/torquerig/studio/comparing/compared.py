"""The job of a study: it reports each drive that is done, and returns ranking, matrices and report as plain values."""

from __future__ import annotations

from contextlib import nullcontext

from torquerig.cases.kept_folder import kept_folder, kept_limit
from torquerig.cases.kept_results import KeptResults, opened_results
from torquerig.catalog.search import catalog_for
from torquerig.document import parse_document
from torquerig.studio.comparing.question import StudyQuestion, StudyShown
from torquerig.studio.jobs.child import Report
from torquerig.studio.shown_answer import ShownAnswer, figures_of


def compared(question: StudyQuestion, report: Report) -> StudyShown:
    """Return every motor, gearbox and filter of a study, simulated, measured and ranked.

    Each drive is kept as soon as it is measured: a study that was cancelled goes on where it was.

    Parameters
    ----------
    report : callable
        Called with ``done=``, ``total=`` and ``name=`` after each drive.

    Raises
    ------
    InputError
        For anything in scenario, filters or catalog that cannot be used, before a run is started.
    """
    report(stage="checking the study")
    folder = kept_folder()
    with nullcontext() if folder is None else opened_results(folder, limit=kept_limit()) as kept:
        return _compared(question, report, kept)


def _compared(question: StudyQuestion, report: Report, kept: KeptResults | None) -> StudyShown:
    from torquerig.reporting.json_results.compare import not_ranked
    from torquerig.reporting.moving.matrix_model import study_model
    from torquerig.reporting.study.budget_table import TONES
    from torquerig.reporting.study.page import study_page
    from torquerig.study.definition import open_study
    from torquerig.study.run_study import run_study
    from torquerig.study.scoring import combinations, criteria_matrix, decide
    from torquerig.study.verdict import verdict

    study = open_study(parse_document(question.text, question.path), catalog_for(question.path, question.catalogs))

    def counted(done: int, total: int, name: str) -> None:
        report(done=done, total=total, name=name)

    runs = run_study(study, progress=counted, workers=question.workers, kept=kept)
    report(stage="rating and drawing")
    decided = decide(runs)
    answer = verdict(decided)
    made = combinations(runs)
    drive_of = {one.name: one.drive.candidate.name for one in made}
    model = study_model(decided.requirements, criteria_matrix(runs, made), baseline=decided.baseline, drive_of=drive_of)
    said = answer.answer
    return StudyShown(
        answer=ShownAnswer(tuple(said.sentences), figures_of(said.figures), TONES.get(answer.certainty, "open")),
        model=model,
        not_ranked=tuple((one.drive, one.decision, "; ".join(one.reasons)) for one in not_ranked(runs, decided)),
        drives=len(runs.drives),
        from_store=runs.from_store,
        page=study_page(runs, decided, answer),
    )
