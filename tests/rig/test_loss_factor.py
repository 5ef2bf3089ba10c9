"""The damping of a coupling by its loss factor, at the first elastic mode of the rig."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor
from torquerig.rig.terms import Spring
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower

MOTOR = Motor(name="motor", inertia=1e-3, torque_limit=1.0)
LOSS = 0.04


def damping_of(rig: Rig, name: str) -> float:
    return next(term.damping for term in rig.terms() if isinstance(term, Spring) and term.name == name)


def test_two_inertias_on_a_coupling_lose_the_stated_share() -> None:
    """Textbook: c = eta k / omega with omega^2 = k (1/J1 + 1/J2); the decay of that mode is then zeta = eta / 2."""
    coupling = Coupling(name="coupling", after="motor", stiffness=800.0, loss_factor=LOSS)
    rig = Rig((MOTOR, coupling, Body(name="drum", after="coupling", inertia=4e-3)), measured="coupling")
    omega = sqrt(800.0 * (1 / 1e-3 + 1 / 4e-3))
    assert damping_of(rig, "coupling") == pytest.approx(LOSS * 800.0 / omega, rel=1e-12)
    values = np.linalg.eigvals(matrices(lower(rig, 0)).state_matrix())
    mode = max(values, key=lambda one: one.imag)
    assert -mode.real / abs(mode) == pytest.approx(LOSS / 2, rel=1e-6)


def test_the_mode_is_that_of_the_whole_chain_with_its_gears() -> None:
    gear = Gear(name="gear", after="motor", ratio=4.0, stiffness=3000.0, damping=1.0, input_inertia=1e-4,
                output_inertia=2e-4)  # fmt: skip
    first = Coupling(name="first", after="gear", stiffness=500.0, loss_factor=LOSS, inertia=1e-4)
    second = Coupling(name="second", after="first", stiffness=900.0, loss_factor=2 * LOSS)
    rig = Rig((MOTOR, gear, first, second, Body(name="drum", after="second", inertia=4e-3)), measured="first")
    mode = next(one for one in matrices(lower(rig, 0)).undamped_frequencies() if one > 0)
    assert damping_of(rig, "first") == pytest.approx(LOSS * 500.0 / (2 * pi * mode), rel=1e-9)
    assert damping_of(rig, "second") == pytest.approx(2 * LOSS * 900.0 / (2 * pi * mode), rel=1e-9)


@pytest.mark.parametrize("both", [{}, {"damping": 0.1, "loss_factor": 0.1}])
def test_one_of_the_two_must_be_stated(both: dict[str, float]) -> None:
    with pytest.raises(InputError, match="damping"):
        Coupling(name="c", after="motor", stiffness=1.0, **both)
