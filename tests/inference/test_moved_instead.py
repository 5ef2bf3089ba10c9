"""A stated friction that has grown in place of a mechanism is back at its stated value where that is proposed."""

from __future__ import annotations

from dataclasses import replace
from math import exp
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario
from torquerig.inference.addition import Addition
from torquerig.inference.additions.stribeck_friction import _moved_instead
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.screening import begins_at
from torquerig.inference.shafts import shafts_of


@pytest.mark.parametrize(
    ("position", "more", "names"), [(4.0, exp(1.2) - 1, {"pump.coulomb"}), (1.0, 0.0, set()), (-4.0, 0.0, set())]
)
def test_the_growth_of_a_dry_torque_is_that_of_the_mechanism(tmp_path, position, more, names):
    rig = pump_scenario(tmp_path).rig
    rig = rig.changed(replace(rig.part("pump"), coulomb=1.0))
    knobs, positions = (Knob("pump", "coulomb", 0.3), Knob("pump", "viscous", 0.3)), np.array([position, 5.0])
    fit = SimpleNamespace(rig=rig, nominal=rig, knobs=knobs, positions=positions)
    context = SimpleNamespace(fit=fit, rig=turned(rig, knobs, positions))
    found, moved = _moved_instead(context, shafts_of(rig)[-1])
    assert (found, moved) == (pytest.approx(more), names)
    begins = begins_at(fit, Addition(stated=moved))
    assert begins.tolist() == [0.0 if moved else position, 5.0]
