"""Half as many blades are another hypothesis, whose first line the rig's own may hide; it may hide all of them."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from torquerig.diagnosis.case import SLOW_TORQUE, Case, missed_lines
from torquerig.diagnosis.choosing.screening import finalists
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.hypotheses import blade_pass
from torquerig.inference.knobs import Knob
from torquerig.inference.places import frequency, order


def test_half_as_many_are_fitted_beside_those_of_the_line_that_shows(with_lines_left: Callable[..., Case]) -> None:
    """Of 4 blades behind 5:1 the first line is the rig's own order 4, and the second, order 8, is left."""
    candidates = list(blade_pass.propose(with_lines_left(1.6)))
    assert [cast(Any, each.parts[0]).order_output for each in candidates] == [8.0, 4.0]
    fitted = finalists([Trial(each, cast(Any, None), 631.0 - row) for row, each in enumerate(candidates)])
    assert [one.candidate for one in fitted] == candidates


def test_as_many_as_the_gear_turns_to_one_are_sought_on_the_rig_s_own_lines(
    with_lines_left: Callable[..., Case],
) -> None:
    """Of 5 blades behind 5:1 every line is a whole order of the motor: they show where the model misses its own."""
    places = (order(1.0), order(2.0), order(7.0), frequency(50.0), order(3.2))
    seen = SimpleNamespace(places=places, unknown=(order(3.2),), turning=None)
    back = SimpleNamespace(places=places, unknown=(order(3.2),), turning=object())
    missed = [SimpleNamespace(lines=np.array([[9.0, 7.0, 2.0, 20.0, 30.0]])), SimpleNamespace(lines=np.zeros(0))]
    case = with_lines_left()
    own = SimpleNamespace(rig=case.model.rig, misfits=missed, knobs=(), positions=np.zeros(0))
    bent = cast("Case", SimpleNamespace(left=(), nominal=case.nominal, seen=(seen, back), runs=(), model=own))
    assert missed_lines(bent) == [order(1.0), order(2.0)]
    candidates = list(blade_pass.propose(bent))
    told = [(cast(Any, each.parts[0]).order_output, cast(Any, each.parts[0]).one_way) for each in candidates]
    assert told == [(5.0, False), (5.0, True), (10.0, False), (10.0, True)], "a run turns back, and tells which way"
    assert all(each.place is None and each.loosens == SLOW_TORQUE for each in candidates)


def test_lines_of_the_rig_that_were_bent_to_stand_in_for_blades_give_way(with_lines_left: Callable[..., Case]) -> None:
    """The pulses of 3 blades are its own third order of the output, and their second, order 6, is left."""
    case = with_lines_left(1.2)
    bent = [Knob("shaft", "amplitudes", 0.25, key=at) for at in (2.0, 3.0)]
    own = SimpleNamespace(**{**vars(case.model), "knobs": tuple(bent), "positions": np.array([1.0, 6.5])})
    candidates = list(blade_pass.propose(cast("Case", SimpleNamespace(**{**vars(case), "model": own}))))
    assert [cast(Any, each.parts[0]).order_output for each in candidates] == [3.0, 6.0]
    assert "amplitudes" in candidates[0].loosens
    assert not candidates[1].loosens
