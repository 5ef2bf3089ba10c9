"""The diagnosis of simulated rigs: nothing where nothing is missing, and what was left out."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded, simulated
from torquerig import mechanisms
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.recordings.recording import Channel


@pytest.fixture(scope="module")
def scenario(tmp_path_factory):
    return pump_scenario(tmp_path_factory.mktemp("pump"))


def answered(scenario, *added):
    return as_json(diagnose(scenario, recorded(scenario, *added)))


@pytest.mark.long
def test_a_complete_model_is_adequate(scenario):
    data = answered(scenario)
    assert data["verdict"] == "adequate"
    assert not data["findings"]
    assert not data["unnamed"]
    assert 0.6 < data["fit"]["before"]["heldout_misfit"] < 1.5  # some 250 features: 1 +- 0.15 for a true model


@pytest.mark.long
def test_hum_is_named_with_its_size(scenario):
    data = answered(scenario, mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(0.02,)))
    assert data["verdict"] == "missing_physics"
    (finding,) = data["findings"]
    assert finding["mechanism"] == "mains_interference"
    low, high = finding["parameters"]["amplitude_V"]["ci95"]
    assert low < 0.02 < high
    assert data["fit"]["after"]["heldout_misfit"] < 0.8 * data["fit"]["before"]["heldout_misfit"]


@pytest.mark.long
def test_blades_are_named_by_the_sizes_of_their_harmonics(scenario):
    blades = mechanisms.BladePass(name="blades", at="pump", order_output=5.0, amplitude=0.8)
    data = answered(scenario, blades)
    (finding,) = data["findings"]
    assert finding["mechanism"] == "blade_pass"
    assert finding["parameters"]["order_output"]["value"] == 5.0
    low, high = finding["parameters"]["amplitude_Nm"]["ci95"]
    assert low < 0.8 < high


def multiplied(recordings, factor):
    name = recordings[0].torque_name()
    return [one.with_values(name, factor * one.channels[name].values) for one in recordings]


@pytest.mark.long
@pytest.mark.parametrize(("factor", "kind", "estimated"), [(-1.0, "sensor_sign", -1.0), (10.0, "sensor_scale", 10.0)])
def test_a_fault_of_the_set_up_is_reported_as_such(scenario, factor, kind, estimated):
    data = as_json(diagnose(scenario, multiplied(recorded(scenario), factor)))
    (fault,) = data["setup"]
    assert (fault["kind"], fault["of"]) == (kind, "sensor")
    # a scale is known as well as the stated sensitivity, whose standard deviation is 0.2 %
    assert fault["estimated"]["value"] == pytest.approx(estimated, rel=0.008)
    low, high = fault["estimated"]["ci95"]
    assert low <= estimated <= high
    assert not data["findings"]


@pytest.mark.long
def test_wrong_counts_of_the_encoder_are_reported(scenario):
    recordings = []
    for made, run in zip(simulated(scenario), recorded(scenario), strict=True):
        counts = np.floor(made.channels["true_motor_angle_rad"].values / (2 * np.pi) * 4096)
        channel = Channel(values=counts, quantity="motor_angle", unit="count", si_per_unit=2 * np.pi / 1024)
        recordings.append(run.with_channel("encoder_count", channel))
    data = as_json(diagnose(scenario, recordings))
    (fault,) = data["setup"]
    assert fault["kind"] == "counts_per_rev"
    assert (fault["stated"], fault["estimated"]["value"]) == pytest.approx((1024, 4096))
    low, high = fault["estimated"]["ci95"]
    assert low < 4096 < high < 4200
    assert not data["findings"]


@pytest.mark.long
def test_a_line_that_no_mechanism_makes_is_in_the_model_without_a_name(scenario):
    odd = mechanisms.TorqueRipple(name="odd", at="pump", group="mechanical", amplitudes={3.37: 0.4})
    data = answered(scenario, odd)
    assert data["verdict"] == "unexplained"
    assert not data["findings"]
    (unnamed,) = data["unnamed"]
    assert (unnamed["kind"], unnamed["axis"]) == ("line_family", "motor_shaft")
    assert unnamed["at"] == pytest.approx(3.37, abs=0.01)
    assert data["fit"]["after"]["heldout_misfit"] < 0.8 * data["fit"]["before"]["heldout_misfit"]
