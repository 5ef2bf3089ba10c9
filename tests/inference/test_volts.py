"""A recording in mV, N m or counts is compared with the sensor's noise and codes as one in volts is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig.inference.engine import prepared
from torquerig.inference.readings.volts import in_volts


@pytest.fixture(scope="module")
def pump(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    return scenario, recorded(scenario)


def in_unit(recording, unit, volts):
    """Return a recording in a unit of so many volts."""
    name = recording.torque_name()
    channel = recording.channels[name]
    return recording.with_channel(
        name, replace(channel, unit=unit, values=channel.values / volts, si_per_unit=channel.si_per_unit * volts)
    )


@pytest.mark.parametrize("unit", ["mV", "N*m", "count"])
def test_every_unit_becomes_volts_of_the_stated_sensitivity(pump, unit):
    scenario, (first, _) = pump
    sensitivity = scenario.rig.part(scenario.rig.measured).sensitivity
    assert first.channels[first.torque_name()].si_per_unit == pytest.approx(1 / sensitivity)
    volts = {"mV": 1e-3, "N*m": sensitivity, "count": 20 / 2**16}[unit]
    made = in_volts(in_unit(first, unit, volts), scenario.rig)
    assert made.channels[made.torque_name()].unit == "V"
    np.testing.assert_allclose(made.torque_values(), first.torque_values(), rtol=1e-12)
    np.testing.assert_allclose(made.torque(), first.torque(), rtol=1e-12)


def test_a_reversed_sensor_keeps_its_sign(pump):
    scenario, (first, _) = pump
    sensitivity = scenario.rig.part(scenario.rig.measured).sensitivity
    made = in_volts(in_unit(first, "N*m", -sensitivity), scenario.rig)
    np.testing.assert_allclose(made.torque_values(), -first.torque_values(), rtol=1e-12)
    np.testing.assert_allclose(made.torque(), first.torque(), rtol=1e-12)


def test_the_evidence_of_the_nominal_rig_does_not_depend_on_the_unit(pump):
    scenario, runs = pump
    sensitivity = scenario.rig.part(scenario.rig.measured).sensitivity
    as_recorded, in_torque = (
        prepared(scenario, each) for each in (runs, [in_unit(run, "N*m", sensitivity) for run in runs])
    )
    assert in_torque.nominal.log_evidence == pytest.approx(as_recorded.nominal.log_evidence, abs=0.01)
    assert in_torque.samples == as_recorded.samples == ()
