"""A sensor that reads with the other sign, and what only looks like it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded, simulated
from torquerig.inference.engine import prepared
from torquerig.inference.readings import sensor_sign
from torquerig.recordings.recording import Channel

COUNTS = 4096


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    return scenario, recorded(scenario)


def changed(recordings, factor, shift):
    """Return the recordings with the voltage times ``factor`` plus ``shift`` [V]."""
    name = recordings[0].torque_name()
    return [one.with_values(name, factor * one.channels[name].values + shift) for one in recordings]


@pytest.mark.long
@pytest.mark.parametrize(("factor", "shift", "kinds"), [(-1.0, 0.0, ["sensor_sign"]), (1.0, -3.5, []), (1.0, 0.0, [])])
def test_a_zero_that_turns_the_sign_of_all_means_is_no_other_sign(bench, factor, shift, kinds):
    scenario, recordings = bench
    found = prepared(scenario, changed(recordings, factor, shift))
    assert [fault.kind for fault in found.setup] == kinds


def test_a_zero_that_the_fit_has_moved_does_not_hide_the_sign(monkeypatch):
    """It moves until all mean torques have the measured sign; they then fall where the load rises."""
    rig, fitted = (SimpleNamespace(measured="sensor", part=lambda _, z=zero: SimpleNamespace(zero=z))
                   for zero in (0.0, -2.0))  # fmt: skip
    run = SimpleNamespace(name="run1", torque=np.ones(3), speed_factor=1.0)
    seen = SimpleNamespace(run=run, level=np.array([-1.2, -1.2, -2.9]))
    expected = SimpleNamespace(level=np.array([-1.1, -1.1, -0.2]))
    fit = SimpleNamespace(expected=[expected], fitted_rig=fitted, knobs=(), log_evidence=0.0)
    monkeypatch.setattr(sensor_sign, "sketched_like", lambda *_: SimpleNamespace(log_evidence=100.0))
    monkeypatch.setattr(sensor_sign, "gain_of", lambda again, fit: again.log_evidence - fit.log_evidence)
    monkeypatch.setattr(sensor_sign, "replace", lambda one, **changed: SimpleNamespace(**(vars(one) | changed)))
    reading = SimpleNamespace(runs=(run,), data=SimpleNamespace(seen=(seen,)), fit=fit, faults=())
    found = sensor_sign.other_sign(reading, rig)
    assert [fault.kind for fault in found.faults] == ["sensor_sign"]
    fit.fitted_rig = rig  # mean torques that are below zero without a moved zero
    assert sensor_sign.other_sign(reading, rig) is reading


@pytest.mark.long
def test_an_encoder_that_turns_against_the_set_points_counts_backwards(bench):
    """The torque agrees with the set-points: a sensor of the other sense would need a set-point without its sign."""
    scenario, _ = bench
    per_count = -2 * np.pi / COUNTS
    backwards = [
        one.without_truth().with_channel("count", Channel(
            values=np.round(one.channels[str(one.find("motor_angle", truth=True))].in_si() / per_count),
            quantity="motor_angle", unit="count", si_per_unit=-per_count))
        for one in simulated(scenario)
    ]  # fmt: skip
    (fault,) = prepared(scenario, backwards).setup
    assert (fault.kind, fault.of, fault.equivalent_to) == ("counts_per_rev", "encoder", ("sensor_sign",))
    assert (fault.stated, fault.estimated) == (COUNTS, -COUNTS)
