"""Which numbers of a scenario are tried as wrong: what was stated, moved by the fit or held by a narrow prior."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference.additions.far_parameter import propose
from torquerig.inference.fit import Fit
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import Discrepancy


def proposed(knobs, slopes, excess):
    """Return the names of the numbers that are tried where a linear model leaves an excess."""
    hessian = slopes.T @ (9.0 / 8.0 * slopes) + np.eye(len(knobs))
    positions = np.linalg.solve(hessian, slopes.T @ (9.0 / 8.0 * excess))
    nominal = SimpleNamespace(parts=[SimpleNamespace(name="sensor"), SimpleNamespace(name="drum")])
    fit = Fit(
        nominal, nominal, knobs, positions, np.zeros(0), Discrepancy(), (), 0.0, -slopes, np.zeros(excess.size),
        np.ones(excess.size),
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
