"""A mesh has the harmonics that show, up to the sixth: what it lacks would be given another name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import pytest

from torquerig.diagnose.case import Case
from torquerig.diagnose.hypotheses import gear_mesh


@pytest.mark.parametrize("multiples", [(1, 2), (1, 2, 3, 4, 5), (1, 6)])
def test_harmonics_that_show_are_the_mesh_s(multiples: tuple[int, ...], with_lines_left: Callable[..., Case]) -> None:
    """The fifth of 84 teeth behind 5:1 stands at order 84 of the motor, where cogging may stand, too."""
    case = with_lines_left(*(16.8 * multiple for multiple in multiples))
    meshes = [each for each in gear_mesh.propose(case) if cast(Any, each.parts[0]).order_output == 84.0]
    told = [knob.key for knob in meshes[0].knobs if knob.field == "transmission_error"]
    assert told == [multiple - 1 for multiple in multiples]
