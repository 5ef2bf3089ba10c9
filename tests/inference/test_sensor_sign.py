"""A sensor that reads with the other sign, and what only looks like it."""

from __future__ import annotations

import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig.inference.engine import prepared


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
