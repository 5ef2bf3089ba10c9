"""Rigs stepped side by side do what each does alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.simulation.random_rigs import random_rig
from tests.simulation.test_step_watch import CHAOTIC
from torquerig.errors import InputError, SimulationError
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Motor, SpeedController
from torquerig.rig.terms import (
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
    Sensing,
    Spring,
    Term,
    Wave,
)
from torquerig.simulation.batch import simulate_batch
from torquerig.simulation.simulator import simulate


@dataclass(frozen=True)
class Drawn:
    """Torques drawn anew at every sample, or at every point of an angle."""

    points_per_turn: int = 16

    @property
    def mean(self) -> float:
        return 0.3

    def sample(self, *given: object) -> NDArray[np.float64]:
        rng, count = given[-1], given[0] if len(given) > 1 else 48
        assert isinstance(rng, np.random.Generator)
        assert isinstance(count, int)
        return rng.uniform(0.1, 0.5, count)


@dataclass(frozen=True, kw_only=True)
class Everything(Part):
    """All terms at once, their numbers drawn from a seed."""

    opens_node = True
    seed: int

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        draw = np.random.default_rng(self.seed).uniform

        def wave(order: float, amplitude: float) -> Wave:
            return Wave(order=order, amplitude=amplitude * draw(0.5, 1.0), phase=draw(0, 6))

        sensing = Sensing(counts=1024, error=(wave(1, 1e-3),), filter_time=2e-3)
        return (
            *(Inertia(node=node, inertia=draw(1e-3, 2e-3)) for node in "abcd"),
            Spring(name="b", a="a", b="b", stiffness=draw(300, 900), damping=draw(0.02, 0.1), gap=draw(1e-3, 1e-2),
                   ratio=3.0, efficiency=draw(0.8, 0.95), error=(wave(3, 1e-3),), damping_follows=True,
                   stiffness_waves=(wave(5, 0.3),)),
            Spring(name="shaft", a="b", b="c", stiffness=draw(300, 900), damping=draw(0.02, 0.1)),
            Spring(name="arm", a="c", b="d", stiffness=draw(300, 900), damping=draw(0.02, 0.1)),
            Friction(name="friction", on="b", coulomb_forward=draw(0.1, 0.3), coulomb_backward=0.2, stribeck=2.0,
                     static_forward=0.5, static_backward=0.4, viscous=draw(0.01, 0.02), quadratic=1e-4),
            BristleFriction(name="bristles", on="c", stiffness=50.0, damping=0.05, coulomb_forward=draw(0.1, 0.3),
                            coulomb_backward=0.2, static_forward=0.4, static_backward=0.3, viscous=0.01),
            HarmonicTorque(name="ripple", on="a", angle="a", against="b",
                           waves=tuple(wave(order, 0.02) for order in (6, 12, 18, 84))),
            BladeTorque(name="blades", on="c", order=4.0, amplitude=0.3, phase=draw(0, 6)),
            BladeTorque(name="pump", on="c", order=7.0, amplitude=0.1, phase=draw(0, 6),
                        one_way=bool(self.seed % 2)),
            Drive(name="drive", on="a", kp=draw(0.03, 0.06), ki=draw(0.2, 0.5), torque_limit=draw(0.7, 2.0), lag=1e-3,
                  ripple=(wave(6, 0.1),), sensing=sensing),
            Load(name="load", on="c", process=Drawn()),
            AngleLoad(name="bed", on="b", process=Drawn()),
            AppliedTorque(name="push", on="b", process=Drawn()),
            ImposedMotion(name="turn", on="d", factor=1 / 3, released=True),
        )  # fmt: skip


def everything(seed: int, speed: float) -> Rig:
    return Rig((Everything(name="b", seed=seed),), Run(speed=speed), measured="b")


def machine(kp: float, *more: Part) -> Rig:
    parts = (Motor(name="motor", inertia=1e-3, torque_limit=2.0, current_loop_bandwidth=500.0),
             Coupling(name="shaft", after="motor", stiffness=900.0, damping=0.1),
             Body(name="load", after="shaft", inertia=1e-3, viscous=0.01),
             SpeedController(name="controller", kp=kp, ki=0.1))  # fmt: skip
    return Rig((*parts, *more), Run(speed=50.0), measured="shaft")


def test_the_rig_has_every_term() -> None:
    kinds = {kind for kind in Term.__subclasses__() if kind.__module__.startswith("torquerig.rig.terms")}
    assert kinds == {type(term) for term in everything(0, 1.0).terms()}


def assert_equal(batch: Sequence[Recording], singles: Sequence[Recording]) -> None:
    """To rounding: 1e-9 of the largest value, the roundings' growth through contacts and bristles included."""
    for one, other in zip(batch, singles, strict=True):
        assert one.channels.keys() == other.channels.keys()
        assert one.origin == other.origin
        for name, channel in one.channels.items():
            expected = other.channels[name].values
            assert np.abs(channel.values - expected).max() <= 1e-9 * np.abs(expected).max(), name


@pytest.mark.long
def test_all_terms_side_by_side_are_those_of_single_runs() -> None:
    """Forward, backward and creeping, in and out of contact, limited and free, each lane at its own time."""
    speeds = [40.0, -25.0, 3.0, 0.5, 12.0, 80.0, -4.0, 30.0, 6.0, 18.0]
    rigs = [everything(seed, speed) for seed, speed in enumerate(speeds)]
    given = {"duration": 0.2, "settling": 0.02, "wander": 1e-3, "substeps": 4}
    batch = simulate_batch(rigs, seeds=range(10), **given)  # type: ignore[arg-type]
    singles = [simulate(rig, seed=seed, **given) for seed, rig in enumerate(rigs)]  # type: ignore[arg-type]
    assert_equal(batch, singles)
    torques = [one.channels["true_sensor_torque_Nm"].values for one in singles]
    assert sum(bool((torque == 0.0).any() and torque.any()) for torque in torques) > 3  # they rattle


@pytest.mark.long
def test_unlike_rigs_come_back_in_their_order() -> None:
    """Two shapes, one of them with two steps, in turns; the last is alone."""
    light = Body(name="pulley", after="load", inertia=1e-5)
    rigs = [machine(0.02 + 0.01 * n, *((light,) if n % 2 else ())) for n in range(7)]
    rigs.append(machine(0.05, Coupling(name="more", after="load", stiffness=9e4, damping=0.1),
                        Body(name="end", after="more", inertia=1e-5)))  # fmt: skip
    batch = simulate_batch(rigs, seeds=[3] * 8, duration=0.05, settling=0.0, scenario="turns", workers=2)
    assert_equal(batch, [simulate(rig, seed=3, duration=0.05, settling=0.0, scenario="turns") for rig in rigs])
    assert len({one.origin["substeps"] for one in batch}) > 1


@pytest.mark.long
def test_the_one_that_fails_says_so_and_a_seed_is_wanted_for_each() -> None:
    stiff = [machine(0.05, Coupling(name="more", after="load", stiffness=stiffness, damping=0.0),
                     Body(name="end", after="more", inertia=1e-5)) for stiffness in (9e2, 9e2, 9e5, 9e2)]  # fmt: skip
    with pytest.raises(SimulationError, match="ceased to be finite"):
        simulate_batch(stiff, seeds=[1] * 4, duration=0.1, settling=0.0, substeps=1)
    with pytest.raises(InputError, match="one seed for each"):
        simulate_batch(stiff, seeds=[1], duration=0.1)


@pytest.mark.long
def test_a_batch_warns_as_single_runs_do() -> None:
    """A gap that rattles, a motor at its limit, and rigs of both kinds of which nothing is to be said."""
    rattling, rate = random_rig(CHAOTIC)
    calm = replace(rattling, run=replace(rattling.run, speed=1e-3 * (rattling.run.speed or 0.0)))
    slow = machine(0.05)
    heavy = replace(slow, parts=tuple(
        replace(part, viscous=0.05) if isinstance(part, Body) else part for part in slow.parts
    ))  # fmt: skip
    rigs = [rattling, slow, calm, heavy, rattling, slow, heavy]
    given = {"duration": 0.5, "settling": 0.5, "sample_rate": rate}
    batch = simulate_batch(rigs, seeds=[CHAOTIC] * 7, **given)
    singles = [simulate(rig, seed=CHAOTIC, **given) for rig in rigs]
    assert [one.origin.get("warnings") for one in batch] == [one.origin.get("warnings") for one in singles]
    assert "chaotic" in batch[0].origin["warnings"][0]
    assert "torque limit" in batch[3].origin["warnings"][0]
    assert "warnings" not in batch[1].origin
