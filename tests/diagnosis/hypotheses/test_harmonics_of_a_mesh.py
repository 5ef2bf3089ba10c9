"""A mesh has the harmonics that show, up to the sixth: what it lacks would be given another name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import gear_mesh


@pytest.mark.parametrize("multiples", [(1, 2), (1, 2, 3, 4, 5), (1, 6)])
def test_harmonics_that_show_are_the_mesh_s(multiples: tuple[int, ...], with_lines_left: Callable[..., Case]) -> None:
    """The fifth of 84 teeth behind 5:1 stands at order 84 of the motor, where cogging may stand, too."""
    case = with_lines_left(*(16.8 * multiple for multiple in multiples))
    meshes = [each for each in gear_mesh.propose(case) if cast(Any, each.parts[0]).order_output == 84.0]
    told = [knob.key for knob in meshes[0].knobs if knob.field == "transmission_error"]
    assert told == [multiple - 1 for multiple in multiples]


def test_a_mesh_whose_first_two_lines_are_the_motor_s_own_is_proposed(with_lines_left: Callable[..., Case]) -> None:
    """Of 60 teeth behind 5:1 the lines 12 and 24 stand on the rig's own; 36 is left, with side lines of planets."""
    case = with_lines_left(36.0, 23.4, 24.6)
    meshes = [cast(Any, each.parts[0]) for each in gear_mesh.propose(case)]
    (sixty,) = [mesh for mesh in meshes if mesh.order_output == 60.0]
    assert len(sixty.transmission_error) >= 3


@pytest.mark.parametrize(("beside", "planets"), [((38.4, 37.8, 39.0), 3), ((38.4,), None), ((18.6,), 3)])
def test_planets_show_beside_any_harmonic(
    beside: tuple[float, ...], planets: int | None, with_lines_left: Callable[..., Case]
) -> None:
    """96 teeth with a small first line: what planets put beside it drowns, what they put beside the second does not."""
    meshes = list(gear_mesh.propose(with_lines_left(19.2, *beside)))
    mesh = next(each for each in meshes if cast(Any, each.parts[0]).order_output == 96.0)
    assert any(knob.field == "planet_modulation" for knob in mesh.knobs) is (planets is not None)
    assert cast(Any, mesh.parts[0]).planets == (planets or 3)
