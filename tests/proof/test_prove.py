"""Sealed before diagnosed, each case once, and a page that holds every figure: with diagnoses made by the test."""

import json
import os
from pathlib import Path

import pytest
import yaml

from proof.errors import ProofError
from proof.page.proof_page import write_pages
from proof.prove import campaign, diagnosing
from proof.prove.campaign import ProofResults, prove
from proof.prove.diagnosing import job_of, refusal_path, write_json
from proof.prove.jobs import no_progress, run_jobs
from proof.prove.opened import opened_jobs
from proof.prove.plan import Plan
from proof.prove.practice import practice_answers, practice_cases
from proof.prove.scored import OURS, scored
from proof.prove.trial_set import blind_set, is_recorded, riddle_set, sealed_digest
from proof.scoring.outcome import Outcome
from proof.sealed import SEAL


def said(verdict, *names, confidence=0.9, before=1.5, after=1.0, equivalent=()):
    findings = [
        {"mechanism": name, "confidence": confidence, "parameters": {}, "equivalent_to": list(equivalent),
         "next_experiment": "run at 400 rpm" if equivalent else None}
        for name in names
    ]  # fmt: skip
    fit = {"before": {"heldout_misfit": before}, "after": {"heldout_misfit": after if names else before}}
    return {"verdict": verdict, "findings": findings, "fit": fit}


def canned(job):
    """Write what a diagnosis would, without one."""
    write_json(job.folder / "costs" / f"{job.name}.json", {"seconds": 1, "processor_seconds": 1, "peak_MiB": 100})
    for name in job.baselines:
        write_json(job.folder / "baselines" / name / f"{job.name}.json", said("missing_physics", "cogging"))
    write_json(job.folder / "diagnoses" / f"{job.name}.json", said("adequate"))
    return job.name


@pytest.fixture
def _canned(monkeypatch):
    monkeypatch.setattr(campaign, "diagnosed", canned)
    monkeypatch.setattr(campaign, "opened", lambda job: job.name)


@pytest.fixture
def _no_recordings(monkeypatch):
    monkeypatch.setattr(campaign, "is_recorded", lambda case, trials: True)


def plan_of(folder: Path, **changed) -> Plan:
    return Plan(**{"seeds": (5,), "cases": 2, "out": folder, "duration": 2.0} | changed)


@pytest.mark.long
@pytest.mark.usefixtures("_canned")
def test_the_seal_is_told_before_anything_is_recorded_or_diagnosed(tmp_path):
    told = []

    def stage(name):
        told.append(name)
        return no_progress

    prove(plan_of(tmp_path, oracle_cases=0), report=told.append, stage=stage)
    seal = (tmp_path / "seed-5" / SEAL).read_text().strip()
    assert told == [f"seed 5: answers sealed, SHA-256 {seal}", "recording", "diagnosing"]
    assert all(
        is_recorded(case, trials) for trials in [blind_set(5, 2, tmp_path, duration=2.0)] for case in trials.cases
    )


@pytest.mark.usefixtures("_canned", "_no_recordings")
def test_a_case_whose_diagnosis_is_there_is_not_run_again(tmp_path, monkeypatch):
    first = prove(plan_of(tmp_path, cases=3), report=str, stage=lambda _: no_progress)
    run = []
    monkeypatch.setattr(campaign, "diagnosed", lambda job: run.append(job.name) or canned(job))
    again = prove(plan_of(tmp_path, cases=3), report=str, stage=lambda _: no_progress)
    assert run == []
    assert again.blind == first.blind
    (tmp_path / "seed-5" / "diagnoses" / "case-002.json").unlink()
    prove(plan_of(tmp_path, cases=3), report=str, stage=lambda _: no_progress)
    assert run == ["case-002"]
    (tmp_path / "seed-5" / "baselines" / "refit_only" / "case-001.json").unlink()
    prove(plan_of(tmp_path, cases=3), report=str, stage=lambda _: no_progress)
    assert run == ["case-002", "case-001"]
    assert not list((tmp_path / "seed-5").rglob("*.partial"))


def test_a_folder_of_other_trials_is_refused(tmp_path):
    trials = blind_set(5, 2, tmp_path, duration=2.0)
    digest = sealed_digest(trials)
    assert sealed_digest(trials) == digest
    with pytest.raises(ProofError, match="do not match this seed"):
        sealed_digest(blind_set(5, 3, tmp_path, duration=2.0))
    (tmp_path / "seed-6").mkdir()
    (tmp_path / "seed-6" / "mine.txt").write_text("kept")
    with pytest.raises(ProofError, match="has no seal"):
        sealed_digest(blind_set(6, 2, tmp_path, duration=2.0))


def test_a_diagnosis_that_fails_leaves_its_reason_and_is_not_tried_again(tmp_path):
    job = job_of("case-001", tmp_path / "nowhere", tmp_path)
    diagnosing.diagnosed(job)  # no recordings
    assert refusal_path(tmp_path, "diagnoses", "case-001").read_text().startswith("IndexError")
    assert diagnosing.is_diagnosed(job)
    answers = {"case-001": {"verdict": "adequate", "effects": [], "plan": "typical", "wrong_parameters": False}}
    judged = scored("seed 1", tmp_path, answers, seal="")
    assert judged.trials[OURS][0].outcome is Outcome.NO_ANSWER
    assert "IndexError" in judged.refusals["seed 1, case-001"]


def test_oracle_and_gains_are_asked_for_where_they_are_due(tmp_path):
    effect = {"mechanism": "gear_mesh", "in_library": True}
    answers = {
        "clean": {"effects": []},
        "mesh": {"effects": [effect]},
        "chirp": {"effects": [effect | {"mechanism": "linear_chirp", "in_library": False}]},
        "both": {"effects": [effect, effect | {"mechanism": "linear_chirp", "in_library": False}]},
    }
    jobs = {job.name: job.true for job in opened_jobs(answers, tmp_path)}
    assert jobs == {"mesh": ("gear_mesh",), "both": ("gear_mesh",)}
    write_json(tmp_path / "oracle" / "mesh.json", {})
    assert {job.name for job in opened_jobs(answers, tmp_path)} == {"both"}


@pytest.mark.long
def test_jobs_are_done_in_several_processes_and_progress_counts_them():
    seen = []
    run_jobs(str, list(range(5)), workers=2, progress=lambda done, total, name: seen.append((done, total, name)))
    assert [row[:2] for row in seen] == [(done, 5) for done in range(6)]
    assert {row[2] for row in seen} == {"", *"01234"}


def threads_of_linear_algebra(_: int) -> str:
    import scipy.linalg  # noqa: F401
    from threadpoolctl import threadpool_info

    return str({each["num_threads"] for each in threadpool_info() if each["user_api"] == "blas"})


@pytest.mark.long
@pytest.mark.parametrize("workers", [1, 2])
def test_linear_algebra_of_a_job_has_one_thread_even_in_libraries_that_it_loads_itself(workers, monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "2")  # what a machine of two cores sets where nobody does
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    seen = set()
    run_jobs(threads_of_linear_algebra, [0, 1], workers=workers, progress=lambda _d, _t, name: seen.add(name))
    assert seen == {"", "{1}"}


def test_practice_answers_are_told_in_the_contracts_words(tmp_path):
    left = {
        "a": {"left_out": {"gear_mesh": {"teeth": 72.0, "amplitudes_rad": [5e-5, 1e-6], "planet_modulation": 0.1}}},
        "b": {"left_out": {}},
        "c": {"left_out": {"unknown_chirp": {"f0": 400.0}}},
        "d": {"left_out": {"mains_interference": {"grid": 1.2, "amplitudes_V": [0.1, 0.02]}}},
    }
    (tmp_path / "answers.yaml").write_text(yaml.safe_dump(left))
    found = practice_answers(tmp_path)
    assert [found[name]["verdict"] for name in "abcd"] == [
        "missing_physics", "adequate", "unexplained", "missing_physics"
    ]  # fmt: skip
    assert found["a"]["effects"][0]["parameters"] == {"order_output": 72.0, "transmission_error_rad": 5e-5}
    assert found["d"]["effects"][0]["parameters"] == {"frequency_Hz": 60.0, "amplitude_V": 0.1}
    with pytest.raises(ProofError, match="no folder with recordings"):
        practice_cases(tmp_path)
    with pytest.raises(ProofError, match="not found"):
        practice_cases(tmp_path / "nowhere")


@pytest.mark.usefixtures("_canned", "_no_recordings")
def test_practice_rigs_and_the_same_laws_have_their_chapters(tmp_path):
    rigs = tmp_path / "rigs"
    for name in ("a", "b"):
        (rigs / name).mkdir(parents=True)
        (rigs / name / "run1.parquet").touch()
    left = {"a": {"left_out": {}}, "b": {"left_out": {"blade_pass": {"blades": 6.0, "amplitude_Nm": 0.5}}}}
    (rigs / "answers.yaml").write_text(yaml.safe_dump(left))
    plan = plan_of(tmp_path / "out", cases=3, oracle_cases=0, same_laws=True, practice=rigs)
    proved = prove(plan, report=str, stage=lambda _: no_progress)
    text = write_pages(proved).markdown.read_text()
    assert "1 of 2 exactly right." in text.split("## Practice recordings")[1]
    assert "blade\\_pass | adequate | missed" in text
    assert "## Effect of laws that differ from the simulator" in text
    assert "Comparison with the baselines" in text  # they cost next to nothing
    assert "--oracle-cases 0 --same-laws" in text


@pytest.fixture
def proved(tmp_path) -> ProofResults:
    """Twelve cases of which one is right, one falsely named, one in the class, one without diagnosis."""
    trials = blind_set(7, 12, tmp_path, duration=2.0)
    folder, answers = trials.folder, trials.answers
    rows = sorted(answers.items(), key=lambda row: row[1]["verdict"] != "missing_physics")
    for place, (name, answer) in enumerate(rows):
        true = [row["mechanism"] for row in answer["effects"] if row["in_library"]]
        text = said(answer["verdict"], *true)
        if place == 0:
            text = said("missing_physics", "no_such_thing", confidence=0.99, after=1.6)
        if place == 1:
            text = said("missing_physics", "cogging", equivalent=(*true, "clipping"))
        if place != 2:
            write_json(folder / "diagnoses" / f"{name}.json", text)
        cost = {"seconds": 10.0 + place, "processor_seconds": 9.0, "peak_MiB": 500.0}
        write_json(folder / "costs" / f"{name}.json", cost)
        write_json(folder / "baselines" / "refit_only" / f"{name}.json", said("unexplained"))
        if true:
            write_json(folder / "oracle" / f"{name}.json", said("missing_physics", *true, after=0.9))
        if not answer["effects"]:
            gains = [{"mechanism": "gear_mesh", "gain": 12.5, "share": 0.9}]
            write_json(folder / "null" / f"{name}.json", gains)
    blind = scored(trials.name, folder, answers, seal=sealed_digest_of(answers), baselines=["refit_only"])
    riddles = riddle_set(7, tmp_path, duration=2.0)
    for name in riddles.answers:
        text = said("missing_physics", "gear_mesh", equivalent=["pwm_aliasing"])
        write_json(riddles.folder / "diagnoses" / f"{name}.json", text)
    riddle = scored(riddles.name, riddles.folder, riddles.answers, seal="r" * 64)
    return ProofResults(plan=plan_of(tmp_path, seeds=(7,), cases=12, riddle=True), blind=(blind,), riddle=(riddle,),
                  same_laws=(blind,))  # fmt: skip


def sealed_digest_of(answers):
    from proof.sealed import seal_of

    return seal_of(answers)


@pytest.mark.long
def test_the_page_holds_every_figure_in_both_forms(proved):
    written = write_pages(proved)
    html, text = written.html.read_text(), written.markdown.read_text()
    summary = written.summary
    exact, within = summary.groups["all"]["all"]
    assert f"{exact.hits} of {exact.trials} blind trials are exactly right" in html
    assert within.hits == exact.hits + 1
    for page in (html, text):
        for word in (
            "Results", "Comparison with the baselines", "Scores by group", "Calibration",
            "The 280 Hz line: mesh, comb or resonance", "Failures", "refitting parameters only", proved.blind[0].seal,
        ):  # fmt: skip
            assert word in page
    assert f"≥ {100 * exact.lower:.1f} %" in html
    assert "run at 400 rpm" in html
    assert 'src="data:image/svg+xml' in html
    assert "python -m proof --seed 7 --cases 12 --duration 2 --riddle" in html
    assert "http" not in html.replace("http://www.w3.org", "")


@pytest.mark.long
def test_every_failure_is_on_the_page(proved):
    written = write_pages(proved)
    text = written.markdown.read_text().split("## Failures")[1]
    wrong = [t for t in proved.blind[0].trials[OURS] if t.outcome not in (Outcome.EXACT, Outcome.IN_CLASS)]
    assert len(wrong) >= 2
    for trial in wrong:
        assert trial.name in text
    assert "no\\_such\\_thing (0.99)" in text
    assert "no diagnosis" in text


def test_the_oracle_stands_beside_the_diagnosis_alone(proved):
    ours, theirs = (proved.blind[0].trials[name] for name in (OURS, "refit_only"))
    named = [t for t in ours if t.matches and t.matches[0].effect and t.improvement.of_oracle is not None]
    assert named
    assert named[0].improvement.of_oracle == pytest.approx((0.5 / 1.5) / (0.6 / 1.5))
    assert all(t.improvement.of_oracle is None for t in theirs)


def test_the_oracle_may_be_run_on_the_first_rigs_only(tmp_path):
    trials = blind_set(7, 12, tmp_path, duration=2.0)
    every = [job.name for job in opened_jobs(trials.answers, tmp_path)]
    some = [job.name for job in opened_jobs(trials.answers, tmp_path, 5)]
    assert some == [name for name in every if name <= "case-005"]
    assert 0 < len(some) < len(every)
    assert list(opened_jobs(trials.answers, tmp_path, 0)) == []


def test_jsons_are_written_whole(tmp_path):
    write_json(tmp_path / "a" / "b.json", {"x": 1})
    assert json.loads((tmp_path / "a" / "b.json").read_text()) == {"x": 1}
    assert [path.name for path in (tmp_path / "a").iterdir()] == ["b.json"]


def dies_at_three(number: int) -> str:
    if number == 3:
        os._exit(1)
    return str(number)


@pytest.mark.long
def test_a_job_whose_worker_dies_does_not_take_the_others_along():
    seen = []
    with pytest.raises(ProofError, match="1 of 5 jobs have no answer; the first is 3: given up after 2 tries"):
        run_jobs(dies_at_three, list(range(5)), workers=2, progress=lambda _d, _t, name: seen.append(name))
    assert sorted(seen) == ["", "0", "1", "2", "4"]
