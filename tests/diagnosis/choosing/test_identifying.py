"""Intervals hold what a fit tells and what no law of the model tells, together."""

from __future__ import annotations

from dataclasses import replace
from math import exp, hypot

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.identifying import identifying
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.outcome import Stated
from torquerig.inference.knobs import Knob
from torquerig.mechanisms import QuadraticDrag, StribeckFriction
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario


def told(scenario: Scenario, part: Part, fields: dict[str, float]) -> dict[str, Stated]:
    """Return the parameters of a part whose fields a fit told to these spreads, in logarithms."""
    rig, knobs = scenario.rig + part, tuple(Knob(part.name, field, 1.0) for field in fields)
    zeros, spreads = np.zeros(len(knobs)), np.square(list(fields.values()))
    model = Calibrated(rig, knobs, zeros, np.diag(spreads), (), 0.0)
    case = Case(nominal=scenario.rig, runs=(), seen=(), model=model, left=())
    return identifying(Candidate(mechanism=part.kind, parts=(part,), knobs=knobs), model, case)


def test_friction_near_standstill_is_told_no_better_than_its_law(wear_rig: Scenario) -> None:
    part = StribeckFriction(name="rub", coulomb=0.4, static=0.9, stribeck_speed=0.5)
    found = told(wear_rig, part, {"coulomb": 0.04, "static": 0.01, "stribeck_speed": 0.01})
    assert found["coulomb_Nm"].high == pytest.approx(0.4 * exp(1.96 * hypot(0.04, 0.03)))
    assert found["static_Nm"].low == pytest.approx(0.9 * exp(-1.96 * hypot(0.01, 0.5)))
    assert found["stribeck_rad_s"].high == pytest.approx(0.5 * exp(1.96 * hypot(0.01, 0.8)))
    both = told(wear_rig, replace(part, coulomb_backward=0.3, static_backward=0.6), {"static_backward": 0.01})
    assert both["static_Nm_backward"].low == pytest.approx(0.6 * exp(-1.96 * hypot(0.01, 0.5)))


def test_what_no_law_is_about_is_told_as_the_fit_tells_it(wear_rig: Scenario) -> None:
    part = QuadraticDrag(name="fan", coefficient=1e-3)
    drag = told(wear_rig, part, {"coefficient": 0.02})["coefficient_Nms2"]
    assert (drag.low, drag.high) == pytest.approx((1e-3 * exp(-1.96 * 0.02), 1e-3 * exp(1.96 * 0.02)))
