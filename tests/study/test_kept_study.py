"""Kept results of a study: what has changed is simulated, nothing else, and the results are those without them."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import get_args

import pytest

from torquerig.cases.content import content_digest
from torquerig.cases.kept_results import KeptResults
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.rig.parts.gear_stage import GearStage
from torquerig.scenario.kinds import KINDS
from torquerig.scenario.overrides import overridden
from torquerig.scenario.sections import USUAL
from torquerig.study import simulated_drives as simulated
from torquerig.study.candidates import candidates
from torquerig.study.definition import Study, open_study
from torquerig.study.exchange import STAGE_KINDS
from torquerig.study.kept_study import KeptStudy
from torquerig.study.results import StudyRuns
from torquerig.study.run_study import run_study

TINY = (
    "study.duration=1 s", "study.draws=0", "study.motors=[bldc-12n14p, HDS5C-102A]",
    "study.gearboxes=[reference-5-1]", "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip
WEIGHTS = ("study.criteria.reading error.weight=0.1", "study.criteria.price.weight=0.3",
           "study.requirements.continuous torque.min=1.2")  # fmt: skip


def study_with(settings: Sequence[str] = (), *, scenario: Path | None = None, catalog: Path | None = None) -> Study:
    document = overridden(read_document(scenario or shipped_scenarios() / "wear_rig.yaml"), (*TINY, *settings))
    return open_study(document, load_catalog(catalog or shipped_folder()))


def figures(runs: StudyRuns) -> str:
    """Return the digest of all that a page is made of."""
    return content_digest([replace(one, simulated=None) for one in runs.drives], runs.mean_load, runs.output_speed)


@pytest.fixture
def simulations(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the drives that were simulated."""
    names: list[str] = []
    before = simulated.planned_drive

    def noted(candidate, scenario, study):
        names.append(candidate.name)
        return before(candidate, scenario, study)

    monkeypatch.setattr(simulated, "planned_drive", noted)
    return names


def test_a_second_run_simulates_nothing_and_has_the_same_figures(tmp_path: Path, simulations: list[str]) -> None:
    kept = KeptResults(tmp_path)
    first = run_study(study_with(), kept=kept)
    assert simulations == ["bldc-12n14p 5:1", "HDS5C-102A 5:1"]
    again = run_study(study_with(WEIGHTS), kept=KeptResults(tmp_path))
    assert len(simulations) == 2
    assert (first.from_store, again.from_store) == (0, 2)
    alone = run_study(study_with())
    assert figures(first) == figures(again) == figures(alone)
    for one, other in zip(alone.drives, again.drives, strict=True):
        assert one.recording is not None
        assert other.recording is not None
        assert (one.recording.torque() == other.recording.torque()).all()


def test_a_scenario_under_another_name_is_the_same_study(tmp_path: Path, simulations: list[str]) -> None:
    results = KeptResults(tmp_path / "kept")
    first = run_study(study_with(), kept=results)
    renamed = tmp_path / "renamed.yaml"
    for name in ("wear_rig.yaml", "filters.yaml"):
        shutil.copy(shipped_scenarios() / name, tmp_path)
    (tmp_path / "wear_rig.yaml").rename(renamed)
    simulations.clear()
    assert figures(run_study(study_with(scenario=renamed), kept=results)) == figures(first)
    assert simulations == []


def test_a_changed_motor_is_simulated_alone(tmp_path: Path, simulations: list[str]) -> None:
    catalog = tmp_path / "catalog"
    shutil.copytree(shipped_folder(), catalog)
    run_study(study_with(catalog=catalog), kept=KeptResults(tmp_path / "kept"))
    del simulations[:]
    real = study_with().catalog.motor("HDS5C-102A").stands_for
    path = next(one for one in (catalog / "motors").glob("*.yaml") if f"name: {real}\n" in one.read_text())
    text = path.read_text()
    line = next(one for one in text.splitlines() if one.startswith("rotor_inertia:"))
    path.write_text(text.replace(line, "rotor_inertia: {value: 2.5e-5 kg*m^2, source: a test, evidence: DOC}"))
    changed = run_study(study_with(catalog=catalog), kept=KeptResults(tmp_path / "kept"))
    assert simulations == ["HDS5C-102A 5:1"]
    assert changed.from_store == 1
    assert figures(changed) == figures(run_study(study_with(catalog=catalog)))


def test_another_motor_in_the_list_is_simulated_alone(tmp_path: Path, simulations: list[str]) -> None:
    run_study(study_with(), kept=KeptResults(tmp_path))
    del simulations[:]
    more = ["study.motors=[HDS5C-102A, GP-71M, bldc-12n14p]"]
    runs = run_study(study_with(more), kept=KeptResults(tmp_path))
    assert simulations == ["GP-71M 5:1"]
    assert [one.candidate.name for one in runs.drives] == ["HDS5C-102A 5:1", "GP-71M 5:1", "bldc-12n14p 5:1"]


def test_an_interrupted_run_goes_on_where_it_was(tmp_path: Path, simulations: list[str]) -> None:
    def stop(done: int, total: int, name: str) -> None:
        if done:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(study_with(), kept=KeptResults(tmp_path), progress=stop)
    runs = run_study(study_with(), kept=KeptResults(tmp_path))
    assert runs.from_store == 1
    assert len(simulations) == 3
    assert figures(runs) == figures(run_study(study_with()))


def key_of(study: Study, tmp_path: Path) -> str:
    store = KeptStudy(KeptResults(tmp_path), study)
    return store.row_key(candidates(study)[0])


SHOWN = ("study.motors=[bldc-12n14p]", "study.criteria.price.points={0: 5, 3000: 1}", *WEIGHTS)
COUNTED = (
    "load.occupancy=11", "study.seed=2", "study.duration=2 s", "study.draws=1", "study.sensor_limit=9 N*m",
    "study.speed_loop.crossover=20 Hz", "study.filters.names=[none]", "recording.sample_rate=10 kHz",
    "rig.coupling.catalog=other", "study.criteria.disturbance.metric=residual_disturbance",
)  # fmt: skip


@pytest.mark.parametrize("setting", SHOWN)
def test_a_key_does_not_depend_on_what_is_rated_afterwards(tmp_path: Path, setting: str) -> None:
    assert key_of(study_with([setting]), tmp_path) == key_of(study_with(), tmp_path)


@pytest.mark.parametrize("setting", COUNTED)
def test_a_key_depends_on_all_that_a_figure_depends_on(tmp_path: Path, setting: str) -> None:
    study = study_with()
    first = candidates(study)[0]
    other = KeptStudy(KeptResults(tmp_path), study_with([setting]))
    assert other.row_key(first) != KeptStudy(KeptResults(tmp_path), study).row_key(first)


def test_a_point_with_fewer_draws_than_its_document_is_kept_apart(tmp_path: Path) -> None:
    study = study_with(["study.draws=1"])
    point = replace(study, settings=study.settings.model_copy(update={"draws": 0}))
    assert key_of(point, tmp_path) != key_of(study, tmp_path)


def test_a_key_depends_on_the_content_of_named_files_and_on_no_comment(tmp_path: Path) -> None:
    for name in ("wear_rig.yaml", "filters.yaml"):
        shutil.copy(shipped_scenarios() / name, tmp_path)
    path = tmp_path / "wear_rig.yaml"
    study = study_with(scenario=path)
    first = candidates(study)[0]

    def key() -> str:
        return KeptStudy(KeptResults(tmp_path / "kept"), study_with(scenario=path)).row_key(first)

    before = key()
    path.write_text("# a comment\n\n" + path.read_text())
    assert key() == before
    (tmp_path / "bldc-12n14p").write_text("a file that a text of the scenario names")
    assert key() != before


def test_a_damaged_row_is_computed_again_with_a_note(tmp_path: Path, simulations: list[str]) -> None:
    first = run_study(study_with(), kept=KeptResults(tmp_path))
    kept = KeptResults(tmp_path)
    path = kept._path(first.row_keys["HDS5C-102A 5:1"])
    path.write_bytes(path.read_bytes()[:-20])
    del simulations[:]
    again = run_study(study_with(), kept=kept)
    assert simulations == ["HDS5C-102A 5:1"]
    assert kept.notes == [f"{path}: this kept result was damaged; it was removed and is computed again"]
    assert figures(again) == figures(first)


def test_the_words_of_stages_are_those_of_the_kinds() -> None:
    assert tuple(word for word, kind in KINDS.items() if issubclass(kind, get_args(GearStage))) == STAGE_KINDS
    assert not KINDS[USUAL].in_a_line
