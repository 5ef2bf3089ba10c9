"""A narrowed library, an oracle that no threshold stops, and thresholds from the tail of clean gains."""

from types import SimpleNamespace

import numpy as np
import pytest
from click.testing import CliRunner

from proof import oracle as room
from proof.library import CLASSES, library_of
from proof.null import clean_jobs
from proof.null import main as null_table_made
from proof.null_gains import NullGain, as_rows, from_rows
from proof.oracle import oracle
from proof.rig_program.draw import answer_of
from proof.thresholds import FALSE_ALARM, FEWEST, best_gains, exceeded_once, thresholds
from torquerig import mechanisms


def test_the_library_is_narrowed_and_put_back():
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())
    with library_of({"gear_mesh"}):
        assert [name for name, one in CLASSES.items() if hasattr(mechanisms, one)] == ["gear_mesh"]
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())
    with pytest.raises(ZeroDivisionError), library_of(()):
        1 / 0  # noqa: B018 (an error within)
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())


def test_the_oracle_adds_what_the_diagnosis_doubts(monkeypatch):
    """With a gain below every threshold, the true mechanism is fitted all the same; others never are."""
    seen = {}
    part = SimpleNamespace(name="windage")
    rig = SimpleNamespace(parts=())
    case = SimpleNamespace(model=SimpleNamespace(rig=rig))
    done = SimpleNamespace(model=SimpleNamespace(rig=SimpleNamespace(parts=(part,))))
    outcome = SimpleNamespace(
        diagnosis=_Diagnosis(findings=()), after=case, completed=rig, held=(),
        before=SimpleNamespace(nominal="nominal", model=SimpleNamespace(rig="calibrated"), runs=()),
    )  # fmt: skip

    def diagnosed(*_args, **_kwargs):
        seen["library"] = [name for name, one in CLASSES.items() if hasattr(mechanisms, one)]
        return outcome

    def trial(name, gain):
        return SimpleNamespace(candidate=SimpleNamespace(mechanism=name, variant=""), model=None, gain=gain)

    tried = SimpleNamespace(fitted=(trial("backlash", 90.0), trial("quadratic_drag", 0.5), trial("quadratic_drag", 3)))
    monkeypatch.setattr(room, "diagnose", diagnosed)
    monkeypatch.setattr(room, "trials", lambda case: tried)
    monkeypatch.setattr(room, "extended", lambda case, best: seen.setdefault("best", best) and done)
    monkeypatch.setattr(room, "identifying", lambda *_: {})
    monkeypatch.setattr(room, "held_out", lambda *args, seed, untold: args[:3])
    monkeypatch.setattr(room, "replace", lambda one, **changed: _Diagnosis(**changed))
    found = oracle("scenario", [], true={"quadratic_drag"})
    assert seen["library"] == ["quadratic_drag"]
    assert seen["best"].gain == 3
    assert [one.mechanism for one in found.findings] == ["quadratic_drag"]
    assert found.fit == ("nominal", "calibrated", done.model.rig)
    outcome.diagnosis = _Diagnosis(findings=(SimpleNamespace(mechanism="quadratic_drag"),))
    assert oracle("scenario", [], true={"quadratic_drag"}) is outcome.diagnosis


class _Diagnosis:
    def __init__(self, findings, fit=None):
        self.findings, self.fit = findings, fit


def test_the_threshold_of_an_exponential_tail_is_its_quantile():
    """Of gains that are exponential with mean m one in 1/chance exceeds m ln(1/chance)."""
    rng = np.random.default_rng(8)
    found = [exceeded_once(rng.exponential(5.0, 400).tolist(), rigs=400) for _ in range(40)]
    # the largest of 400 is never undercut, and it lies at ln(400) + 0.577 = 6.6 means, beyond ln(500) = 6.2
    assert np.mean(found) == pytest.approx(5.0 * np.log(1 / FALSE_ALARM), rel=0.15)
    assert exceeded_once([9.0], rigs=50) == 9.0
    assert exceeded_once([], rigs=50) == 0.0


def test_only_what_could_have_been_named_counts():
    rigs = [
        (NullGain(mechanism="backlash", gain=90.0, share=0.2), NullGain(mechanism="gear_mesh", gain=g, share=0.95))
        for g in np.linspace(1.0, 30.0, FEWEST)
    ]
    found = {one.mechanism: one for one in thresholds(rigs, least_share=0.8)}
    assert (found["backlash"].passed, found["backlash"].gain) == (0, 0.0)
    assert found["gear_mesh"].gain >= 30.0
    assert found["gear_mesh"].largest == 30.0
    assert max(best_gains(rigs, least_share=0.8)) == 30.0
    few = thresholds(rigs[:3], least_share=0.8)
    assert [one.gain for one in few] == [None, None]
    assert from_rows(as_rows(rigs[0])) == rigs[0]


@pytest.mark.long
def test_a_null_table_is_made_of_rigs_with_nothing_hidden(tmp_path):
    jobs = clean_jobs(5, 40, tmp_path)
    assert len(jobs) == 13
    assert all(answer_of(job.case)["effects"] == [] for job in jobs)
    assert len({job.gains for job in jobs}) == 13


@pytest.mark.long
def test_too_few_clean_rigs_make_no_table(tmp_path):
    told = CliRunner().invoke(null_table_made, ["--seed", "5", "--cases", "20", "--out", str(tmp_path / "clean")])
    assert told.exit_code != 0
    assert "clean rigs are too few" in told.output
    assert not (tmp_path / "clean").exists()
