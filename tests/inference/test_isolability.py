"""Smallest visible sizes and parallel hypotheses, against simulated rigs."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.errors import InputError
from torquerig.inference.addition import Addition, Reported
from torquerig.inference.context import Context
from torquerig.inference.engine import diagnose, prepared
from torquerig.inference.isolability.beforehand import beforehand
from torquerig.inference.isolability.classes import ALIKE, inseparable, separation
from torquerig.inference.isolability.limits import as_limit, best_by_mechanism, smallest, smallest_of_each
from torquerig.inference.isolability.probes import hypotheses, probed
from torquerig.inference.isolability.separating import separating_run
from torquerig.inference.isolability.signatures import Projection, Signature


@pytest.fixture(scope="module")
def scenario(tmp_path_factory):
    return pump_scenario(tmp_path_factory.mktemp("pump"))


@pytest.fixture(scope="module")
def ready(scenario):
    return prepared(scenario, recorded(scenario))


@pytest.fixture(scope="module")
def limits(ready):
    return {each["mechanism"]: each for each in beforehand(ready).upper_limits}


def signature_of(mechanism, change, *, two_sided=False):
    each = Addition(mechanism=mechanism, label=mechanism)
    return Signature(each, Reported("a", "a", "1"), 1.0, np.zeros(1), np.array(change), False, two_sided)


def test_parallel_changes_are_one_class_and_right_angles_are_two():
    one, other = signature_of("gear_mesh", [6.0, 1.0]), signature_of("blade_pass", [12.0, 2.0])
    assert separation(one, other) == pytest.approx(0.0, abs=1e-9)
    assert [pair.nats for pair in inseparable([one, other])] == pytest.approx([0.0], abs=1e-9)
    apart = signature_of("blade_pass", [1.0, -6.0])
    # twice the size: four times half the square
    assert separation(one, apart) == pytest.approx(2 * 37.0)
    assert not inseparable([one, apart])


def test_opposite_changes_are_alike_only_where_an_effect_has_a_sign():
    one = signature_of("sensor_drift", [5.0, 0.0], two_sided=True)
    assert separation(one, signature_of("quadratic_drag", [-5.0, 0.0])) < ALIKE
    assert separation(signature_of("blade_pass", [5.0, 0.0]), signature_of("gear_mesh", [-5.0, 0.0])) == np.inf


@pytest.mark.long
@pytest.mark.parametrize(("times", "is_found"), [(2.0, True), (0.4, False)])
def test_hum_is_found_above_its_smallest_visible_size_only(scenario, limits, times, is_found):
    amplitude = times * limits["mains_interference"]["value"]
    hum = mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(amplitude,))
    found = diagnose(scenario, recorded(scenario, hum)).model.additions
    assert [each.mechanism for each in found] == (["mains_interference"] if is_found else [])


@pytest.mark.long
@pytest.mark.parametrize(("times", "is_found"), [(2.0, True), (0.4, False)])
def test_drag_is_found_above_its_smallest_visible_size_only(scenario, limits, times, is_found):
    coefficient = times * limits["quadratic_drag"]["value"]
    drag = mechanisms.QuadraticDrag(name="drag", at="pump", coefficient=coefficient)
    found = diagnose(scenario, recorded(scenario, drag)).model.additions
    assert bool(found) is is_found


@pytest.mark.long
def test_a_second_speed_separates_an_order_from_a_tone(scenario):
    ready = prepared(scenario, recorded(scenario, speeds=(1000.0,)))
    rig = ready.nominal.fitted_rig
    hum = rig + mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(0.05,))
    line = rig + mechanisms.TorqueRipple(name="odd", at="pump", group="mechanical", amplitudes={3.0: 0.1})
    names = ("mains_interference", "blade_pass")
    said = separating_run(hum, line, ready.data.seen, ready.nominal, names=names)
    assert said.startswith("Record a steady run at")
    assert "1000 rpm" not in said


@pytest.mark.long
def test_no_run_separates_a_model_from_itself(ready):
    rig = ready.nominal.fitted_rig
    said = separating_run(rig, rig, ready.data.seen, ready.nominal, names=("gear_mesh", "cogging"))
    assert said.startswith("No other speed, load, run-up or reversal separates gear mesh from cogging.")


@pytest.mark.long
def test_what_a_diagnosis_refuses_is_refused_beforehand(scenario):
    with pytest.raises(InputError, match="no recording has this name"):
        prepared(scenario, recorded(scenario), held_out=["other.parquet"])


def test_a_change_is_computed_once_for_a_hypothesis_at_a_position(ready):
    drift = mechanisms.SensorDrift(name="drift", span=1.0, time_constant=None)
    each = Addition(mechanism="sensor_drift", parts=(drift,), label="drift")
    projection = Projection(Context(ready.nominal, ready.data, ()))
    change = projection.change(each, np.zeros(0))
    assert np.abs(change).max() > 0
    assert projection.change(each, np.zeros(0)) is change


def test_what_is_smaller_than_another_shows_is_not_followed(ready):
    context, places = probed(ready.nominal, ready.runs, ready.known)
    proposed = list(hypotheses(context, places))
    every, few = Projection(context), Projection(context)
    best = best_by_mechanism(smallest(every, proposed))
    assert [as_limit(each) for each in smallest_of_each(few, proposed)] == [as_limit(each) for each in best]
    assert len(few._kept) < 0.9 * len(every._kept)
