"""A mechanism that leaves much of the line that it should make is not its cause."""

from __future__ import annotations

import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference.addition import Addition
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, fitted
from torquerig.inference.knobs import with_free_load
from torquerig.inference.model import Model
from torquerig.inference.own_features import refuted
from torquerig.inference.parameters import parameters
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run


def ripple(amplitude):
    return mechanisms.TorqueRipple(name="x", at="pump", group="mechanical", amplitudes={5.0: amplitude})


@pytest.mark.parametrize(("share", "is_refuted"), [(1.0, False), (0.9, False), (0.4, True)])
def test_a_name_that_makes_a_part_of_its_line_is_refuted(tmp_path, share, is_refuted):
    scenario, places = pump_scenario(tmp_path), [order(1.0), order(5.0)]
    rig = with_free_load(scenario.rig)
    run = drawn_run(1, speed=steady(1000), orders={1.0: 0.3, 5.0: 0.3})
    data = Data.of([run_features(run, places)])
    made = float(expected_run(rig + ripple(1.0), data.seen[0]).line_power[0, data.seen[0].places.index(order(5.0))])
    part = ripple(share * 0.3 / made**0.5)
    fit = fitted(rig + part, parameters(scenario, rig, [run]), data)
    named = Addition(mechanism="commutation_ripple", parts=(part,))
    nameless = Addition(kind="line_family", parts=(part,))
    assert bool(refuted(Model(fit, (named,), ()), data, data)) == is_refuted
    assert refuted(Model(fit, (nameless,), ()), data, data) == ()
