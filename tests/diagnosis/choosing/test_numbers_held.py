"""What was found beside the numbers as they stood before: only its own are fitted, all others stay where they were."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import numbers_held
from torquerig.diagnosis.choosing.numbers_held import with_numbers_held
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.inference.knobs import Knob, turned
from torquerig.mechanisms import QuadraticDrag
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

INERTIA, VISCOUS = Knob("wear_part", "inertia", 0.1), Knob("wear_part", "viscous", 0.2)
DRAG = QuadraticDrag(name="quadratic_drag", coefficient=1e-3)
OWN = Knob(DRAG.name, "coefficient", 0.5)


def model(rig: Rig, knobs: Sequence[Knob], positions: Sequence[float], *, missed: float) -> Calibrated:
    at = np.array(positions)
    return Calibrated(turned(rig, knobs, at), tuple(knobs), at, 0.1 * np.eye(at.size), (), missed + float(at @ at))


@pytest.mark.parametrize(("missed", "gains"), [(900.0, True), (980.0, False)])
def test_only_the_effects_own_numbers_are_fitted(
    missed: float, gains: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    nominal = wear_rig.rig
    before = Case(
        nominal=nominal, runs=(), seen=(), left=(),
        model=model(nominal, (INERTIA, VISCOUS), (0.5, -1.0), missed=1000.0),
    )  # fmt: skip
    added = Candidate(mechanism="quadratic_drag", parts=(DRAG,), knobs=(OWN,))
    free = model(nominal + DRAG, (OWN, INERTIA, VISCOUS), (2.0, 3.0, 4.0), missed=800.0)
    found = replace(before, model=free, accepted=(added,))

    def fitted(rig: Rig, seen: Any, knobs: Sequence[Knob], *, start: NDArray[np.float64], **_: Any) -> Calibrated:
        assert list(knobs) == [OWN]
        assert start.tolist() == [2.0]
        return model(rig, knobs, (1.5,), missed=missed)

    monkeypatch.setattr(numbers_held, "calibrated", fitted)
    held = with_numbers_held(before, found)
    if not gains:
        assert held is None
        return
    assert held is not None
    assert held.accepted == (added,)
    assert held.model.positions.tolist() == [1.5, 0.5, -1.0]
    assert held.model.cost == pytest.approx(missed + 1.5**2 + 0.5**2 + 1.0**2)
    assert held.model.rig.part("wear_part") == before.model.rig.part("wear_part")
    assert held.model.rig.part(DRAG.name) == replace(DRAG, coefficient=OWN.turned(1e-3, 1.5))
    assert held.model.covariance is free.covariance
