"""A mechanism that a later addition makes needless leaves the model; one that is needed stays."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.inference.addition import Addition
from torquerig.inference.dropped import without_needless
from torquerig.inference.engine import prepared
from torquerig.inference.fit import fitted
from torquerig.inference.knobs import Knob
from torquerig.inference.model import Model

DRIFT = Addition(
    mechanism="sensor_drift", parts=(mechanisms.SensorDrift(name="drift", span=0.0, time_constant=None),),
    knobs=(Knob("drift", "span", 0.3, factor=False),), starts=((0.3,),), log_odds=-3.7,
)  # fmt: skip
STEP = Addition(
    kind="level_course", parts=(mechanisms.ReadingCourse(name="course", shape="step", at=0.45),),
    knobs=(Knob("course", "zero", 0.3, factor=False),), starts=((0.3,),), log_odds=-7.7,
)  # fmt: skip


def by_eight_nats(_, model, less):
    return model.log_odds - less.log_odds >= 8.0


def with_both(tmp_path, *hidden, step=0.0):
    """Return the data of runs with hidden effects, and the model with a drift and a step, fitted from ``step`` [V]."""
    scenario = pump_scenario(tmp_path)
    ready = prepared(scenario, recorded(scenario, *hidden))
    rig, knobs = ready.nominal.rig, ready.nominal.knobs
    for each in (DRIFT, STEP):
        rig, knobs = each.added_to(rig), (*knobs, *each.knobs)
    start = np.append(np.zeros(len(knobs) - 1), step / 0.3)
    return ready.data, Model(fitted(rig, knobs, ready.data, start=start), (DRIFT, STEP), ())


@pytest.mark.parametrize("zero", [0.5, -0.5])
def test_a_drift_that_a_step_makes_needless_is_dropped(tmp_path, zero):
    hidden = mechanisms.ReadingCourse(name="hidden", shape="step", at=0.45, zero=zero)
    data, both = with_both(tmp_path, hidden, step=zero)
    model = without_needless(both, data, (), wins=by_eight_nats)
    assert model.additions == (STEP,)
    assert both.log_odds - model.log_odds < 8.0
    assert model.fit.fitted_rig.part("course").zero == pytest.approx(zero, rel=0.2)


def test_a_drift_that_is_there_stays(tmp_path):
    data, both = with_both(tmp_path, mechanisms.SensorDrift(name="hidden", span=1.0, time_constant=None))
    assert without_needless(both, data, (), wins=by_eight_nats) is both
