"""The job of a diagnosis: it reports its stages, and returns the answer as plain values."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from hashlib import sha256
from typing import Any

from torquerig.catalog.search import catalog_folders, catalog_for
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar import sidecar_path
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.writing import scenario_text
from torquerig.studio.diagnosing.each_effect import each_effect
from torquerig.studio.diagnosing.question import DiagnosisQuestion, DiagnosisShown
from torquerig.studio.jobs.child import Report
from torquerig.studio.shown_answer import ShownAnswer, figures_of, pictures_in

HEAD = "Written by the studio of torquerig: the nominal rig with fitted parameters and the findings."
COMMAND = "torquerig studio, step Diagnose"


def diagnosed(question: DiagnosisQuestion, report: Report) -> DiagnosisShown:
    """Return the diagnosis of recordings of one rig.

    Parameters
    ----------
    report : callable
        Called with ``stage=`` at each stage.

    Raises
    ------
    InputError, RecordingError
        Where scenario and recordings cannot be used or do not fit each other.
    """
    from torquerig.parallel import parallel_processes

    def staged(stage: str) -> None:
        report(stage=stage)

    staged("reading the recordings")
    catalog = catalog_for(question.path, question.catalogs)
    scenario = read_scenario(parse_document(question.text, question.path), catalog, seed=question.seed)
    recordings = _read(question)
    with parallel_processes(question.workers):
        return _ENGINES[question.engine](scenario, recordings, question, staged)


def _read(question: DiagnosisQuestion) -> list[Recording]:
    if not question.recordings:
        raise InputError("a diagnosis needs at least one recording; choose one")
    return [read_recording(path) for path in question.recordings]


def _by_rules(
    scenario: Scenario, recordings: Sequence[Recording], question: DiagnosisQuestion, staged: Callable[[str], None]
) -> DiagnosisShown:
    from torquerig.diagnosis.any_rig import diagnosed as by_rules
    from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
    from torquerig.diagnosis.outcome import as_json
    from torquerig.diagnosis.showing.effect_at_sensor import effect_at_sensor
    from torquerig.reporting.diagnosis.answer_text import answer_lines
    from torquerig.reporting.diagnosis.motion_page import motion_page
    from torquerig.reporting.diagnosis.page import diagnosis_page
    from torquerig.reporting.diagnosis.page_answer import diagnosis_answer
    from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL, MOTION_RESIDUAL, verdict_sentence

    outcome = by_rules(scenario, recordings, seed=question.seed, progress=staged)
    staged("simulating with and without each effect")
    effect = effect_at_sensor(outcome, nominal=scenario.rig, seed=question.seed)
    is_motion = isinstance(outcome, MotionOutcome)
    data = outcome.as_json() if isinstance(outcome, MotionOutcome) else as_json(outcome.diagnosis)
    measure = MOTION_RESIDUAL if is_motion else FEATURE_RESIDUAL
    sentence = verdict_sentence(outcome.diagnosis, outcome.left, measure=measure)
    remarks = outcome.diagnosis.remarks
    lines = answer_lines(data, verdict=sentence, effect="" if effect is None else effect.sentence, remarks=remarks)
    each = () if is_motion else each_effect(outcome.completed, scenario.rig, recordings, seed=question.seed)
    staged("drawing")
    how: dict[str, Any] = {
        "title": scenario.title,
        "command": COMMAND,
        "model": None,
        "seed": question.seed,
        "effect": effect,
    }
    page = motion_page(outcome, **how) if isinstance(outcome, MotionOutcome) else diagnosis_page(outcome, **how)
    answer = diagnosis_answer(data, effect, percent=is_motion)
    return DiagnosisShown(
        data=_with_provenance(data, question),
        answer=ShownAnswer(answer.sentences, figures_of(answer.figures), answer.tone),
        lines=tuple(lines),
        pictures=pictures_in(page),
        model=_model(outcome.completed, scenario) if outcome.completes else None,
        page=page,
        each=each,
    )


def _by_likelihood(
    scenario: Scenario, recordings: Sequence[Recording], question: DiagnosisQuestion, staged: Callable[[str], None]
) -> DiagnosisShown:
    from torquerig.inference.answer import as_json
    from torquerig.inference.engine import diagnose
    from torquerig.reporting.diagnosis.answer_text import answer_lines
    from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
    from torquerig.reporting.diagnosis.likelihood.page import likelihood_page
    from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
    from torquerig.rig.imposed_part import imposed_part
    from torquerig.scenario.recorded.compared_channel import as_measured

    if imposed_part(scenario.rig) is not None:
        raise InputError(
            "the studio does not compare rigs whose motion was measured by the engine likelihood yet; choose rules, or "
            "use torquerig diagnose --engine likelihood"
        )
    outcome = diagnose(scenario, as_measured(recordings, scenario.rig), progress=staged)
    data = as_json(outcome)
    staged("simulating with and without each effect")
    each = each_effect(outcome.completed, scenario.rig, recordings, seed=question.seed)
    staged("drawing")
    page = likelihood_page(outcome, data, title=scenario.title, command=COMMAND, model=None, seed=question.seed)
    answer = first_screen(data)
    return DiagnosisShown(
        data=_with_provenance(data, question),
        answer=ShownAnswer(answer.sentences, figures_of(answer.figures), answer.tone),
        lines=tuple(answer_lines(data, verdict=verdict_of(data), remarks=remarks_of(data))),
        pictures=pictures_in(page),
        model=_model(outcome.completed, scenario) if outcome.completes else None,
        page=page,
        each=each,
    )


_ENGINES: dict[str, Callable[..., DiagnosisShown]] = {"rules": _by_rules, "likelihood": _by_likelihood}


def _model(completed: Rig, scenario: Scenario) -> str:
    point = scenario.document.data.get("operating_point", {})
    return scenario_text(completed, title=scenario.title, operating_point=point, head=HEAD)


def _with_provenance(data: dict[str, Any], question: DiagnosisQuestion) -> dict[str, Any]:
    """Return the diagnosis with the files, seed and version that made it."""
    from torquerig.reporting.json_results.provenance import provenance_of
    from torquerig.reporting.json_results.values import plain_values

    files = (*question.recordings, *map(sidecar_path, question.recordings), question.path)
    made = provenance_of(
        files, seed=question.seed, catalogs=catalog_folders(question.path, question.catalogs),
        options={"engine": question.engine},
    )  # fmt: skip
    plain = plain_values(made)[0]
    hashes = {**plain["inputs_sha256"], question.path.name: sha256(question.text.encode()).hexdigest()}
    return {**data, "provenance": {**plain, "inputs_sha256": hashes}}
