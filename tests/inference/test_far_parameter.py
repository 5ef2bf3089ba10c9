"""Which numbers of a scenario are tried as wrong: what was stated, moved by the fit or held by a narrow prior."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference.addition import Addition
from torquerig.inference.additions.far_parameter import propose
from torquerig.inference.answer.setup_facts import number_answer
from torquerig.inference.fit import Fit
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import Discrepancy
from torquerig.inference.search import _explained


def proposed(knobs, slopes, excess):
    """Return the names of the numbers that are tried where a linear model leaves an excess."""
    hessian = slopes.T @ (9.0 / 8.0 * slopes) + np.eye(len(knobs))
    positions = np.linalg.solve(hessian, slopes.T @ (9.0 / 8.0 * excess))
    nominal = SimpleNamespace(parts=[SimpleNamespace(name="sensor"), SimpleNamespace(name="drum")])
    fit = Fit(
        nominal, nominal, knobs, positions, np.zeros(0), Discrepancy(), (), 0.0,
        np.concatenate([-slopes, np.zeros_like(slopes)]), np.zeros(excess.size), np.ones(excess.size),
    )  # fmt: skip
    return [each.label.split()[0] for each in propose(SimpleNamespace(fit=fit, largest_level=50.0, signal=5.0))]


ZERO, FRICTION = Knob("sensor", "zero", 0.3, factor=False), Knob("drum", "coulomb", 0.3)


@pytest.mark.parametrize("stiffness", [0.05, 0.3, 1.0])
def test_a_zero_is_tried_where_a_friction_with_a_wider_prior_has_moved(stiffness):
    slopes = np.array([[stiffness, 2.0], [stiffness, 2.0], [stiffness, 2.0]])
    assert set(proposed((ZERO, FRICTION), slopes, np.full(3, 9.0))) == {"sensor.zero", "drum.coulomb"}


def test_nothing_is_tried_where_nothing_is_left():
    assert not proposed((ZERO, FRICTION), np.array([[0.1, 2.0], [0.1, 1.0]]), np.array([0.3, -0.1]))


def test_a_number_that_was_never_stated_is_not_wrong():
    shape = Knob("drum", "hit_rise", 1.2)
    assert not proposed((shape,), np.array([[3.0], [3.0]]), np.full(2, 9.0))
    assert proposed((Knob("drum", "hit_rise", 0.2),), np.array([[3.0], [3.0]]), np.full(2, 9.0))


def model_of(knob, positions):
    """Return a model to which a number was added as a wrong one, with the positions of zero and friction."""
    fit = SimpleNamespace(knobs=(ZERO, FRICTION), positions=np.array(positions))
    return SimpleNamespace(fit=fit, additions=(Addition(kind="parameter", knobs=(knob,)),))


def test_a_number_that_would_move_instead_is_held_at_its_stated_value():
    friction, zero = model_of(FRICTION, [0.1, 1.3]), model_of(ZERO, [1.3, 0.2])
    assert _explained(friction, [friction, zero]) == {"sensor.zero"}
    assert _explained(zero, [friction, zero]) == {"drum.coulomb"}


def test_a_number_that_is_off_as_well_is_not_held():
    friction, zero = model_of(FRICTION, [4.0, 1.3]), model_of(ZERO, [1.3, 6.0])
    assert not _explained(friction, [friction, zero])


@pytest.mark.parametrize(("position", "like"), [(5.0, ["stribeck_friction"]), (-5.0, [])])
def test_more_dry_friction_than_stated_may_be_missing_friction(position, like):
    part = SimpleNamespace(coulomb=1.0)
    rig = SimpleNamespace(part=lambda _: part, parts=[part])
    fit = Fit(
        rig, rig, (FRICTION,), np.array([position]), np.zeros(0), Discrepancy(), (), 0.0, np.ones((4, 1)), np.zeros(2),
        np.ones(2),
    )  # fmt: skip
    outcome = SimpleNamespace(model=SimpleNamespace(fit=fit, alternatives=()))
    assert number_answer(outcome, Addition(kind="parameter", knobs=(FRICTION,)))["equivalent_to"] == like
