"""A drag that the fitted viscous friction stands in for is sought from a size that could be, too."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import quadratic_drag
from torquerig.mechanisms import QuadraticDrag
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body
from torquerig.scenario.model import Scenario

DRAG = 1e-3  # [N m s^2/rad^2]
SPEED = 25.0  # [rad/s] of the wear part


def torque(rig: Rig) -> float:
    part = rig.part("wear_part")
    assert isinstance(part, Body)
    return part.viscous * SPEED + sum(drag.coefficient for drag in rig.parts_of(QuadraticDrag)) * SPEED**2


def test_it_is_sought_beside_both(wear_rig: Scenario) -> None:
    nominal = wear_rig.rig
    part = nominal.part("wear_part")
    assert isinstance(part, Body)
    recorded = torque(nominal) + DRAG * SPEED**2
    fitted = nominal.changed(replace(part, viscous=recorded / SPEED))
    case = SimpleNamespace(
        nominal=nominal, seen=[SimpleNamespace(speed=np.array([[20.0], [125.0]]), turning=None)],
        model=SimpleNamespace(rig=fitted), misfit_of=lambda rig: (torque(rig) - recorded) ** 2,
        nominal_with_accepted=lambda: nominal,
    )  # fmt: skip
    sought = [one.parts[0] for one in quadratic_drag.propose(cast("Case", case))]
    assert [one.coefficient for one in sought if isinstance(one, QuadraticDrag)] == [1e-5, DRAG]
