"""What hypotheses promise: also with numbers at their stated values that the fit has moved far."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference import screening
from torquerig.inference.addition import Addition

FRICTION = Addition(
    mechanism="stribeck_friction", label="", parts=(SimpleNamespace(name="x"),), starts=((0.0,), (1.0,))
)


def context(*positions):
    knobs = [SimpleNamespace(name=f"number_{at}") for at in range(len(positions))]
    fit = SimpleNamespace(positions=np.array(positions), rig=None, knobs=knobs)
    return SimpleNamespace(fit=fit, rig="fitted")


@pytest.fixture(autouse=True)
def promises(monkeypatch):
    """Let the second start promise most, a step from the stated numbers more, and one with the own parameters most."""
    monkeypatch.setattr(screening, "turned", lambda *_: "stated")

    def promised(_, __, start, origin, *, own=False):
        return start[0] + 10 * (origin.rig == "stated") + 100 * own

    monkeypatch.setattr(screening, "_promised", promised)


def test_only_numbers_that_have_moved_far_are_stated_again():
    here, stated = screening._origins(context(9.0, 3.0, -5.0), FRICTION)
    assert here.positions.tolist() == [9.0, 3.0, -5.0]
    assert stated.positions.tolist() == [0.0, 3.0, 0.0]
    assert len(screening._origins(context(3.0, -3.9), FRICTION)) == 1


@pytest.mark.parametrize(("position", "promised"), [(3.0, 1.0), (9.0, 111.0)])
def test_a_number_that_has_moved_far_lets_the_parameters_of_a_hypothesis_move(position, promised):
    assert screening.screened(context(position), FRICTION) == (promised, (1.0,))


def test_a_hypothesis_whose_size_a_line_has_set_keeps_it():
    mesh = Addition(mechanism="gear_mesh", label="", parts=FRICTION.parts, starts=((1.0,),), places=("order 3",))
    assert screening.screened(context(9.0), mesh) == (11.0, (1.0,))
