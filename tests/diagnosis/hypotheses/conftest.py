"""What the tests of hypotheses share: a case that holds what a proposal looks at, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import blade_pass, cogging, commutation_ripple, gear_mesh
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario


@pytest.fixture
def with_lines_left(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Case]:
    """Return the wear rig with lines left at orders of the motor [1/rev], clearest first, each of any size."""
    for hypothesis in (blade_pass, cogging, commutation_ripple, gear_mesh):
        monkeypatch.setattr(hypothesis, "line_factor", lambda case, rig, place: 1.0)

    def made(*at: float) -> Case:
        peaks = tuple(
            Peak(place=order(each), excess=50.0 / row, runs=("run1",), speeds=1) for row, each in enumerate(at, start=1)
        )
        places = tuple(peak.place for peak in peaks)
        shown = SimpleNamespace(places=places, unknown=places, turning=None)
        missed = (SimpleNamespace(lines=np.zeros(len(places))),)
        model = SimpleNamespace(rig=wear_rig.rig, misfits=missed, knobs=(), positions=np.zeros(0))
        return cast("Case", SimpleNamespace(left=peaks, nominal=wear_rig.rig, seen=(shown,), runs=(), model=model))

    return made
