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
from torquerig.reporting.diagnosis.likelihood import made
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.writing import scenario_text
from torquerig.studio.diagnosing.each_effect import each_effect
from torquerig.studio.diagnosing.question import DiagnosisQuestion, DiagnosisShown
from torquerig.studio.jobs.child import Report
from torquerig.studio.shown_answer import ShownAnswer, figures_of, pictures_in

Staged = Callable[[str], None]

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
        return _shown(scenario, recordings, question, staged)


def _read(question: DiagnosisQuestion) -> list[Recording]:
    if not question.recordings:
        raise InputError("a diagnosis needs at least one recording; choose one")
    return [read_recording(path) for path in question.recordings]


def _shown(
    scenario: Scenario, recordings: Sequence[Recording], question: DiagnosisQuestion, staged: Staged
) -> DiagnosisShown:
    found = made.diagnosed(scenario, recordings, seed=question.seed, progress=staged)
    staged("simulating with and without each effect")
    is_motion = imposed_part(scenario.rig) is not None
    each = (
        ()
        if is_motion or found.completed is None
        else each_effect(found.completed, scenario.rig, recordings, seed=question.seed)
    )
    staged("drawing")
    page, answer = found.page(found.data, command=COMMAND, model=None), found.answer()
    return DiagnosisShown(
        data=_with_provenance(found.data, question),
        answer=ShownAnswer(answer.sentences, figures_of(answer.figures), answer.tone),
        lines=tuple(found.lines(found.data)),
        pictures=pictures_in(page),
        model=None if found.completed is None else _model(found.completed, scenario),
        page=page,
        each=each,
    )


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
        options={},
    )  # fmt: skip
    plain = plain_values(made)[0]
    hashes = {**plain["inputs_sha256"], question.path.name: sha256(question.text.encode()).hexdigest()}
    return {**data, "provenance": {**plain, "inputs_sha256": hashes}}
