"""What one parameter of a fit does to the others, on a model that is linear."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference import one_number
from torquerig.inference.fit import Fit
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import BAND, LINE, Discrepancy
from torquerig.inference.one_number import moved_lines, without_priors
from torquerig.inference.places import order

KNOBS = tuple(Knob("part", name, 0.1) for name in ("first", "second"))
SLOPES = np.array([[1.0, 1.0], [1.0, 0.9], [0.2, 0.3], [0.0, 0.4]])
SAME_SD = np.zeros_like(SLOPES)  # derivatives of the logarithms of the standard deviations
MEASURED = np.array([0.3, 0.25, 0.1, -0.05])  # small: Student's weights are then those of its middle


def posterior(weights, *, prior=(1.0, 1.0)):
    """Return the maximum of a linear model with the given prior precisions."""
    hessian = SLOPES.T @ (weights[:, None] * SLOPES) + np.diag(prior)
    return np.linalg.solve(hessian, SLOPES.T @ (weights * MEASURED))


@pytest.fixture
def fit():
    weights = np.full(4, 9.0 / 8.0)
    positions = posterior(weights)
    nothing = SimpleNamespace()
    return Fit(
        nothing, nothing, KNOBS, positions, np.zeros(0), Discrepancy(), (), 0.0, np.concatenate([-SLOPES, SAME_SD]),
        np.zeros(4), np.ones(4),
    )  # fmt: skip


@pytest.mark.parametrize(("column", "prior"), [(0, (0.0, 1.0)), (1, (1.0, 0.0))])
def test_a_parameter_without_its_prior_is_where_a_fit_without_it_leads(fit, column, prior):
    moved, gains = without_priors(fit)
    assert moved[column] == pytest.approx(posterior(np.full(4, 9.0 / 8.0), prior=prior)[column])
    assert gains[column] >= 0.5 * fit.positions[column] ** 2


def test_of_two_that_explain_the_same_the_stiff_one_gains_most_without_its_prior():
    slopes = np.array([[3.0, 0.1], [3.0, 0.1]])  # the second has a spread thirty times smaller
    hessian = slopes.T @ (9.0 / 8.0 * slopes) + np.eye(2)
    positions = np.linalg.solve(hessian, slopes.T @ (9.0 / 8.0 * np.array([6.0, 6.0])))
    nothing = SimpleNamespace()
    fit = Fit(
        nothing, nothing, KNOBS, positions, np.zeros(0), Discrepancy(), (), 0.0, np.concatenate([-slopes, 0 * slopes]),
        np.zeros(2), np.ones(2),
    )  # fmt: skip
    moved, gains = without_priors(fit)
    assert abs(positions[1]) < 0.2 < 10 < abs(moved[1])
    assert gains == pytest.approx([gains[0]] * 2, rel=0.1)


@pytest.mark.parametrize(
    ("positions", "slopes", "moved"),
    [
        ([9.0, 0.0], [[0.1, 0.0], [2.0, 0.0], [0.5, 1.0]], [order(7.0)]),
        ([3.0, 0.0], [[0.1, 0.0], [2.0, 0.0], [0.5, 1.0]], []),  # within the spread of copies of a rig
        (
            [0.0, -9.0],
            [[0.1, 0.0], [2.0, 0.0], [0.5, 1.0]],
            [],
        ),  # a number that changes a band most is no size of a line
        ([9.0, 9.0], [[0.1, 3.0], [2.0, 0.0], [0.5, 1.0]], [order(7.0), order(2.0)]),
    ],
)
def test_a_stated_line_that_has_moved_far_is_the_one_that_its_number_changes_most(
    monkeypatch, positions, slopes, moved
):
    seen = SimpleNamespace(places=(order(2.0), order(7.0)))
    rows = SimpleNamespace(kind=np.array([LINE, LINE, BAND]), at=np.array([0, 1, 0]))
    monkeypatch.setattr(one_number, "all_residuals", lambda *_: [rows])
    fit = SimpleNamespace(
        positions=np.array(positions), jacobian=np.array([*slopes, *np.zeros((3, 2))]), expected=(), gains=(), off=None
    )
    assert moved_lines(fit, SimpleNamespace(seen=[seen])) == moved
