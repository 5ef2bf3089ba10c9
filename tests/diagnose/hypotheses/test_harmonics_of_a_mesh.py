"""A mesh has the harmonics that show, up to the sixth: what it lacks would be given another name."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnose.case import Case
from torquerig.diagnose.hypotheses import gear_mesh
from torquerig.diagnose.looking.peaks import Peak
from torquerig.diagnose.looking.places import order
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize("multiples", [(1, 2), (1, 2, 3, 4, 5), (1, 6)])
def test_harmonics_that_show_are_the_mesh_s(
    multiples: tuple[int, ...], wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The fifth of 84 teeth behind 5:1 stands at order 84 of the motor, where cogging may stand, too."""
    monkeypatch.setattr(gear_mesh, "line_factor", lambda case, rig, place: 1.0)
    peaks = tuple(
        Peak(place=order(16.8 * multiple), excess=90.0 / multiple, runs=("run1",), speeds=2) for multiple in multiples
    )
    case = SimpleNamespace(left=peaks, nominal=wear_rig.rig, runs=(), model=SimpleNamespace(rig=wear_rig.rig))
    meshes = [each for each in gear_mesh.propose(cast("Case", case)) if cast(Any, each.parts[0]).order_output == 84.0]
    told = [knob.key for knob in meshes[0].knobs if knob.field == "transmission_error"]
    assert told == [multiple - 1 for multiple in multiples]
