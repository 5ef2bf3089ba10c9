"""Faults of samples without a mechanism: repaired, stated by recording, and no verdict but ``unexplained``."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.inference.answer.located import fault_place
from torquerig.inference.answer.verdict import verdict
from torquerig.inference.sample_faults import sample_faults
from torquerig.inference.set_points import off_set_points
from torquerig.inference.untrue_samples import samples_as_compared

START, STOP = 4000, 4080  # of the samples that were written twice


@pytest.fixture(scope="module")
def pump(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    return scenario.rig, recorded(scenario)


def shown(rig, runs):
    return samples_as_compared(runs, rig, sample_faults(runs, rig))


def with_samples(run, change):
    volts = run.torque_values().copy()
    change(volts)
    return run.with_values(run.torque_name(), volts)


def copied(volts):
    volts[START:STOP] = volts[2 * START - STOP : START]


def test_recordings_without_faults_are_compared_as_they_were_read(pump):
    rig, runs = pump
    made = shown(rig, runs)
    assert all(one is other for one, other in zip(made.faults.recordings, runs, strict=True))
    assert (made.untrue, made.sentences) == ((), ())
    assert not any(lost.any() for lost in made.faults.lost)


def test_samples_written_twice_are_bridged_at_their_seams_and_stated(pump):
    rig, (first, second) = pump
    made = shown(rig, [with_samples(first, copied), second])
    (sentence,) = made.sentences
    assert sentence.startswith("run1.parquet: at 2 s samples repeat earlier ones exactly")
    assert sentence.endswith("the seams were bridged")
    lost = np.flatnonzero(made.faults.lost[0])
    assert np.abs(lost - START).min() <= 1
    assert np.abs(lost - STOP).min() <= 1
    assert lost.size < 20  # two seams of 1.5 ms to either side
    assert made.faults.recordings[1] is second
    assert not made.faults.lost[1].any()


def test_moments_without_a_signal_are_stated_with_their_share(pump):
    rig, runs = pump

    def drop(volts):
        for start in range(1000, 11000, 1000):
            volts[start : start + 30] = 0.0

    made = shown(rig, [with_samples(runs[0], drop), runs[1]])
    assert [each.mechanism for each in made.faults.additions] == ["signal_dropout"]
    (sentence,) = made.sentences
    assert sentence.startswith("run1.parquet: 10 moments without a signal, 2.5 % of the samples, were interpolated")


def test_what_the_library_cannot_name_is_a_fault_of_the_samples(pump, monkeypatch):
    """A library without dropouts: the moments are still bridged, and the verdict is not ``adequate``."""
    rig, runs = pump
    monkeypatch.delattr(mechanisms, "SignalDropout")

    def drop(volts):
        for start in range(1000, 11000, 1000):
            volts[start : start + 30] = 0.0

    made = shown(rig, [with_samples(runs[0], drop), runs[1]])
    assert made.faults.additions == ()
    (fault,) = made.untrue
    assert fault.recording == "run1.parquet"
    assert fault.place.at == pytest.approx(0.5)
    assert made.faults.lost[0].sum() >= 300


def test_a_limit_that_the_library_cannot_name_counts_where_most_blocks_are_at_it(pump, monkeypatch):
    rig, runs = pump
    monkeypatch.delattr(mechanisms, "Clipping")
    limit = float(np.quantile(np.abs(runs[0].torque_values()), 0.6))
    made = shown(rig, [with_samples(run, lambda volts: np.clip(volts, -limit, limit, out=volts)) for run in runs])
    assert made.faults.unusable[0].any()
    assert {fault.mechanism for fault in made.untrue} == {"clipping"}
    assert verdict(SimpleNamespace(untrue=made.untrue)) == "unexplained"


def test_samples_at_a_limit_are_stated(pump):
    rig, runs = pump
    limit = float(np.quantile(np.abs(runs[0].torque_values()), 0.985))
    made = shown(rig, [with_samples(run, lambda volts: np.clip(volts, -limit, limit, out=volts)) for run in runs])
    assert [each.mechanism for each in made.faults.additions] == ["clipping"]
    assert made.sentences[0].startswith("run1.parquet: ")
    assert "of the samples are at a limit" in made.sentences[0]


def test_untrue_samples_leave_no_verdict_but_unexplained_and_are_located(pump):
    rig, (first, second) = pump
    untrue = shown(rig, [with_samples(first, copied), second]).untrue
    assert verdict(SimpleNamespace(untrue=untrue)) == "unexplained"
    place = fault_place(untrue[0])
    assert (place["domain"], place["axis"], place["at"]) == ("time", "s", pytest.approx(2.0))
    assert (place["width"], place["recordings"]) == (pytest.approx(0.04), ["run1.parquet"])


@pytest.mark.parametrize(("stated", "said"), [(1.0, 0), (1.014, 0), (1.02, 1), (1.3, 1)])
def test_a_sidecar_of_another_speed_is_stated(stated, said):
    run = SimpleNamespace(name="run1.parquet", is_steady=True, has_encoder=True, speed_factor=1.0, mean_speed=100.0,
                          run=SimpleNamespace(speed=100.0 * stated))  # fmt: skip
    sentences = [*off_set_points([run], error=0.01)]
    assert len(sentences) == said
    if said:
        rpm = 100 * stated * 30 / np.pi
        assert f"the sidecar states {rpm:.4g} rpm, but its measured angle shows 954.9 rpm" in sentences[0]
        assert "sample_rate_Hz, the counts per turn and the set-point" in sentences[0]
    assert not [*off_set_points([replace_steady(run)], error=0.01)]


def replace_steady(run):
    return SimpleNamespace(**{**vars(run), "is_steady": False})
