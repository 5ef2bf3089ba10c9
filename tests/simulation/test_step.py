"""The step: what fixes it, that it is proven, the order of convergence, and why a run cannot be integrated."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import SimulationError
from torquerig.mechanisms import QuadraticDrag, StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Gear, Motor, SpeedController, TorqueSensor
from torquerig.rig.terms import AppliedTorque, Term
from torquerig.simulation.batch import simulate_batch
from torquerig.simulation.simulator import choice_for, simulate
from torquerig.simulation.step_choice import STABLE_ANGLE
from torquerig.simulation.step_proof import prove_step


@dataclass(frozen=True)
class Given:
    """A torque that is 1 N m but for one sample."""

    odd: float
    mean: float = 1.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        values = np.ones(count)
        values[count // 2] = self.odd
        return values


@dataclass(frozen=True, kw_only=True)
class Push(Part):
    """A torque from outside."""

    odd: float = 1.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node("first"), process=Given(self.odd)),)


def two_masses(*, gap: float = 0.0, damping: float = 0.01, odd: float = 1.0) -> Rig:
    shaft = Gear(name="shaft", after="first", ratio=1, stiffness=700, damping=damping, backlash=gap)
    parts = (Body(name="first", inertia=0.005), shaft, Body(name="second", after="shaft", inertia=0.005))
    return Rig((*parts, Push(name="push", odd=odd)), measured="shaft")


def driven(*effects: Part, kp: float = 0.05, limit: float = 5.0, bandwidth: float = 500.0) -> Rig:
    motor = Motor(name="motor", inertia=1.5e-4, torque_limit=limit, current_loop_bandwidth=bandwidth)
    sensor = TorqueSensor(name="sensor", after="motor", stiffness=1100, damping=0.05, inertia=1e-4, bandwidth=5000)
    wheel = Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02)
    loop = SpeedController(name="loop", kp=kp, ki=0.5)
    return Rig((motor, sensor, wheel, loop, *effects), Run(speed=70.0), measured="sensor")


DRY = StribeckFriction(name="dry", at="wheel", coulomb=2.0, static=3.0, stribeck_speed=2.0)


def test_the_fastest_mode_fixes_the_step_and_is_named() -> None:
    """sqrt(k (1/J1 + 1/J2)) = 529.15 1/s; at 200 samples a second it turns 2.6 rad, so 5 steps of 0.53 rad."""
    choice = choice_for(two_masses(), duration=0.1, seed=0, settling=0.0, sample_rate=200.0)
    assert choice.fixed_by.rate == pytest.approx(529.15, rel=1e-4)
    assert "84.22 Hz (twist in 'shaft')" in choice.fixed_by.what
    assert (choice.steps, choice.angle) == (5, pytest.approx(529.15 / 1000, rel=1e-4))


def test_dry_friction_counts_where_its_shaft_stands_and_not_where_it_runs() -> None:
    """3 N m over 0.02 rad/s on 2.1e-3 kg m^2: 71 400 1/s, in a reversal; not at a steady 70 rad/s."""
    reversing = replace(driven(DRY), run=Run(speed=70.0, profile="reversal"))
    choice = choice_for(reversing, duration=1.0, seed=0)
    assert choice.fixed_by.what == "the dry friction on 'sensor' as it changes direction"
    assert choice.fixed_by.rate == pytest.approx(3.0 / 0.02 / 2.1e-3, rel=1e-9)
    assert "friction" not in choice_for(driven(DRY), duration=1.0, seed=0).fixed_by.what


def test_a_current_loop_faster_than_the_shafts_fixes_the_step() -> None:
    choice = choice_for(driven(bandwidth=20_000.0), duration=1.0, seed=0)
    assert choice.fixed_by.what == "the current lag of 'loop'"
    assert choice.steps == 9  # 2 pi 20 kHz x 40 us = 5.03 rad, at 0.6 a step


@pytest.mark.parametrize(
    "rig",
    [
        driven(TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 0.1, 42: 0.05})),
        replace(driven(DRY), run=Run(speed=70.0, profile="reversal")),
        driven(bandwidth=20_000.0),
    ],
    ids=["ripple", "reversal with dry friction", "fast current loop"],
)
def test_the_step_that_is_chosen_is_proven(rig: Rig) -> None:
    proof = prove_step(rig, duration=0.5, seed=2, settling=0.5)
    assert proof.proven, proof.sentence()
    assert proof.tolerance == pytest.approx(20 / 65536)
    assert "one step of its converter" in proof.sentence()


def test_a_step_that_is_too_long_is_not_proven_and_a_shorter_one_is_named() -> None:
    proof = prove_step(two_masses(), duration=1.0, seed=0, settling=0.0, sample_rate=1000.0, substeps=1, tolerance=1e-3)
    assert not proof.proven
    assert proof.steps_needed in (2, 4, 8)
    assert f"NOT proven; {proof.steps_needed} steps a sample are" in proof.sentence()
    better = prove_step(
        two_masses(),
        duration=1.0,
        seed=0,
        settling=0.0,
        sample_rate=1000.0,
        substeps=proof.steps_needed,
        tolerance=1e-3,
    )
    assert better.proven


def test_convergence_is_of_fourth_order_where_the_rig_is_smooth() -> None:
    """Order log2(e(h) / e(h/2)) over two halvings against the matrix exponential of the survey's case 6.3."""
    errors = np.array([abs(end_of(0.0, rate) - 0.486019685) for rate in (2000.0, 4000.0, 8000.0)])
    assert np.log2(errors[:-1] / errors[1:]) == pytest.approx([4, 4], abs=0.15), errors


def test_convergence_keeps_its_order_through_47_located_contacts() -> None:
    """From 500 to 15.6 us five halvings gain 2^20; single halvings waver, for the contacts fall differently each time.

    A method that steps over the kinks has order one or two here: the survey's plain Runge-Kutta is off by 1.0e-3 at
    40 us and 7e-5 at 10 us.
    """
    exact = end_of(0.004, 400_000.0)
    assert exact == pytest.approx(0.6791051, abs=1e-7)
    coarse, fine = (abs(end_of(0.004, rate) - exact) for rate in (2000.0, 64_000.0))
    assert np.log2(coarse / fine) / 5 == pytest.approx(4.0, abs=0.4)


def end_of(gap: float, rate: float) -> float:
    made = simulate(two_masses(gap=gap), duration=1 + 1 / rate, seed=0, settling=0.0, sample_rate=rate, substeps=1)
    return float(made.channels["true_sensor_torque_Nm"].values[-1])


def failed(rig: Rig, **more: float) -> str:
    with pytest.raises(SimulationError) as caught:
        simulate(rig, **{"duration": 20.0, "seed": 0, "settling": 0.0, **more})
    return str(caught.value)


def test_a_step_beyond_stability_is_named_with_node_time_mode_and_remedy() -> None:
    told = failed(two_masses(damping=0.0), sample_rate=150.0, substeps=1)
    assert "the speed of 'first' ceased to be finite" in told or "the speed of 'second' ceased to be finite" in told
    assert "too long for the mode at 84.22 Hz" in told
    assert "2 or more substeps are stable" in told
    assert 529.15 / 150 > STABLE_ANGLE > 529.15 / 300
    simulate(two_masses(damping=0.0), duration=20.0, seed=0, settling=0.0, sample_rate=150.0, substeps=2)


def test_a_torque_that_is_no_number_is_named_and_not_the_loop() -> None:
    told = failed(two_masses(odd=np.nan), duration=0.1)
    assert "push is not finite there" in told
    assert "0.0500 s after the start" in told


def test_an_unstable_loop_is_told_from_a_step_too_long() -> None:
    """Without a torque limit to speak of the loop runs away; the linear twin tells its frequency and growth."""
    told = failed(driven(kp=50.0, limit=1e308))
    assert "the speed loop is unstable: it swings at" in told
    assert "lower kp and ki" in told
    assert "too long" not in told


def test_what_cannot_be_told_is_not_made_up() -> None:
    """Quadratic drag so large that one step overshoots by more than it brakes: neither a mode nor the loop."""
    told = failed(driven(QuadraticDrag(name="drag", at="wheel", coefficient=10.0)))
    assert "quadratic drag" in told


def test_limited_torque_keeps_an_unstable_loop_finite() -> None:
    made = simulate(driven(kp=50.0), duration=0.5, seed=0)
    assert np.isfinite(made.channels["true_motor_speed_rad_s"].values).all()


def test_what_asks_for_more_steps_than_it_is_worth_is_refused() -> None:
    """Numbers that a fit drove to where they cannot be once asked for 7590 steps a sample, and for an hour."""
    reversing = replace(driven(DRY), run=Run(speed=70.0, profile="reversal"))
    steps = choice_for(reversing, duration=0.1, seed=0).steps
    assert simulate(reversing, seed=0, duration=0.1, most_steps=steps).samples == 2500
    said = f"{steps} integration steps a sample, more than the {steps - 1} allowed"
    with pytest.raises(SimulationError, match=said):
        simulate(reversing, seed=0, duration=0.1, most_steps=steps - 1)
    with pytest.raises(SimulationError, match=said):
        simulate_batch([reversing] * 2, seeds=[0, 1], duration=0.1, most_steps=steps - 1)
