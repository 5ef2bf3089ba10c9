"""Laws over every kind of term: each is declared once and known everywhere, and keeps the momentum."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Motor, SpeedController
from torquerig.rig.steady import steady_torque
from torquerig.rig.terms import (
    GROUND,
    AngleLoad,
    AppliedTorque,
    BladeTorque,
    BristleFriction,
    Drive,
    Friction,
    HarmonicTorque,
    ImposedMotion,
    Inertia,
    Load,
    Spring,
    Term,
    Wave,
)
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower, lower_terms
from torquerig.simulation.simulator import simulate
from torquerig.simulation.term_kinds import KINDS, Terms
from torquerig.simulation.twin.linear_twin import twin_of

J_MOTOR, J_WHEEL = 1.5e-3, 0.02
FIELDS_OF_NODES = ("node", "a", "b", "on", "against", "angle")


@dataclass(frozen=True)
class Constant:
    """One torque for all time, or at all angles."""

    mean: float
    points_per_turn: int = 16

    def sample(self, *given: object) -> NDArray[np.float64]:
        count = given[0] if isinstance(given[0], int) else self.points_per_turn
        return np.full(count, self.mean)


WAVE = Wave(order=7.0, amplitude=0.05, phase=0.3)
PAIR = {"on": "motor", "against": "shaft"}
DRY = {"coulomb_forward": 0.2, "coulomb_backward": 0.2, "static_forward": 0.3, "static_backward": 0.3}
BETWEEN_TWO_SHAFTS: tuple[Term, ...] = (
    Spring(name="it", a="motor", b="shaft", stiffness=80.0, damping=0.01),
    HarmonicTorque(name="it", **PAIR, angle="shaft", waves=(WAVE,)),
    Friction(name="it", **PAIR, **DRY, viscous=0.01),
    BristleFriction(name="it", **PAIR, **DRY, stiffness=90.0, damping=0.02, viscous=0.01),
    Drive(name="it", **PAIR, kp=0.02, ki=0.1, torque_limit=1.0, lag=1e-3, ripple=(WAVE,)),
)
AGAINST_THE_FRAME: tuple[Term, ...] = (
    Friction(name="it", on="shaft", **DRY, viscous=0.01, quadratic=1e-3),
    BristleFriction(name="it", on="shaft", **DRY, stiffness=90.0, damping=0.02, viscous=0.01),
    Load(name="it", on="shaft", process=Constant(0.4)),
    AngleLoad(name="it", on="shaft", process=Constant(0.4)),
    AppliedTorque(name="it", on="shaft", process=Constant(-0.4)),
    BladeTorque(name="it", on="shaft", order=5.0, amplitude=0.4),
)
NO_MEAN_TORQUE = (Inertia(node="shaft", inertia=1e-3), ImposedMotion(name="it", on="shaft"))
EXAMPLES = (*BETWEEN_TWO_SHAFTS, *AGAINST_THE_FRAME, *NO_MEAN_TORQUE)


def called(term: Term) -> str:
    return f"{type(term).__name__} {'pair' if term in BETWEEN_TWO_SHAFTS else 'frame'}"


@dataclass(frozen=True, kw_only=True)
class Given(Part):
    """Terms as they are."""

    given: tuple[Term, ...]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return them."""
        return self.given


def shafts(*given: Term, more: tuple[Part, ...] = (), speed: float | None = None) -> Rig:
    """Return a motor and a wheel on the node ``shaft`` with a soft spring between them."""
    motor = Motor(name="motor", inertia=J_MOTOR, torque_limit=10.0)
    spring = Coupling(name="shaft", after="motor", stiffness=50.0, damping=0.01)
    wheel = Body(name="wheel", after="shaft", inertia=J_WHEEL)
    return Rig((motor, spring, wheel, Given(name="given", given=given), *more), Run(speed=speed), measured="shaft")


def library() -> set[type[Term]]:
    return {cls for cls in Term.__subclasses__() if cls.__module__.startswith("torquerig.rig.terms")}


def test_every_term_of_the_vocabulary_has_an_example_and_a_kind() -> None:
    assert {type(term) for term in EXAMPLES} == library()
    made_from = {cls for kind in KINDS for cls in kind.made_from}
    assert made_from == library() - {Inertia}


def test_every_kind_has_its_arrays_in_the_kernel() -> None:
    assert Terms._fields == ("inverse_inertia", "waves", *(kind.field for kind in KINDS))
    for kind in KINDS:
        rows = getattr(lower_terms([Inertia(node="shaft", inertia=1.0)], 0).arrays, kind.field)
        assert set(kind.deciding) <= set(rows._fields)


@pytest.mark.parametrize("term", EXAMPLES, ids=called)
def test_a_term_names_all_its_nodes_and_is_refused_where_one_carries_nothing(term: Term) -> None:
    fields = [name for name in FIELDS_OF_NODES if hasattr(term, name)]
    assert set(term.nodes) == {getattr(term, name) for name in fields}
    for name in fields if not isinstance(term, Inertia) else ():
        with pytest.raises(InputError, match="nowhere: no inertia sits on this shaft"):
            lower_terms((*shafts().terms(), replace(term, **{name: "nowhere"})), 0)


@pytest.mark.parametrize("term", BETWEEN_TWO_SHAFTS, ids=called)
def test_a_term_between_two_shafts_keeps_their_momentum(term: Term) -> None:
    """2 N m from the frame on the motor for 0.2 s: ``J1 w1 + J2 w2`` grows by the impulse, whatever acts between."""
    push = AppliedTorque(name="push", on="motor", process=Constant(2.0))
    made, without = (
        simulate(shafts(push, *more), duration=0.2, seed=1, settling=0.0) for more in ((term,), ())
    )  # fmt: skip
    motor, wheel = (made.channels[f"true_{name}_speed_rad_s"].values for name in ("motor", "output"))
    # RK4 keeps a linear invariant to rounding; the drive's set-point adds a start below 1e-12
    assert J_MOTOR * motor + J_WHEEL * wheel == pytest.approx(2.0 * made.time(), abs=1e-9)
    assert np.abs(motor - without.channels["true_motor_speed_rad_s"].values).max() > 0.1


@pytest.mark.parametrize("term", AGAINST_THE_FRAME, ids=called)
def test_drive_train_and_twin_ask_the_same_mean_torque_of_the_motor(term: Term) -> None:
    """By the terms themselves and by the arrays: the motor holds 20 rad/s against the term alone."""
    loop = SpeedController(name="loop", kp=0.05, ki=0.5)
    rig = shafts(term, more=(loop,), speed=20.0)
    asked = steady_torque(rig, "motor")
    assert asked > 0.05
    assert twin_of(rig).point.drive_torque == pytest.approx(asked, rel=1e-9)  # the sign is tanh(1000), Stribeck e^-400


@pytest.mark.parametrize("term", [*BETWEEN_TWO_SHAFTS, *AGAINST_THE_FRAME], ids=called)
def test_the_linear_share_of_a_term_is_symmetric_and_acts_between_its_nodes(term: Term) -> None:
    bare = (Inertia(node="motor", inertia=J_MOTOR), Inertia(node="shaft", inertia=J_WHEEL))
    for stiffest in (False, True):
        found = matrices(lower_terms((*bare, term), 0), stiffest=stiffest)
        for matrix in (found.damping, found.stiffness):
            assert (matrix == matrix.T).all()
            if getattr(term, "against", "") != GROUND:
                assert matrix.sum(axis=0) == pytest.approx(0.0, abs=1e-12)  # equal and opposite
    shares = [link for kind in KINDS for link in kind.links(getattr(lower((shafts(term)), 0).arrays, kind.field),
                                                            stiffest=True)]  # fmt: skip
    expected = isinstance(term, Spring | Friction | BristleFriction)
    assert len(shares) == 1 + expected  # the soft spring of the rig has one


def test_the_stiffest_matrices_take_a_varying_spring_at_its_highest() -> None:
    varying = Spring(name="it", a="motor", b="shaft", stiffness=80.0, damping=0.0,
                     stiffness_waves=(Wave(order=3.0, amplitude=0.25, phase=pi / 3),))  # fmt: skip
    bare = (Inertia(node="motor", inertia=J_MOTOR), Inertia(node="shaft", inertia=J_WHEEL))
    mean, highest = (matrices(lower_terms((*bare, varying), 0), stiffest=way).stiffness[0, 0] for way in (False, True))
    assert (mean, highest) == (80.0, pytest.approx(100.0))
