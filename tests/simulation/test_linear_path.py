"""The exact linear path against closed forms and against the integrator; and what it refuses."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.errors import InputError, SimulationError
from torquerig.mechanisms import BladePass, CommutationRipple, GearMesh, StribeckFriction, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, Probe, SpeedController
from torquerig.rig.terms import AppliedTorque, Load, Term
from torquerig.simulation.linear_path import simulate_linear
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.line_inputs import half_wave_squared


@dataclass(frozen=True)
class Noise:
    """White noise held at the samples."""

    mean: float
    spread: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return self.mean + self.spread * rng.standard_normal(count)


@dataclass(frozen=True, kw_only=True)
class Torque(Part):
    """A torque from outside, or a load."""

    at: str
    process: Noise
    opposing: bool = False

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        kind = Load if self.opposing else AppliedTorque
        return (kind(name=self.name, on=rig.node(self.at), process=self.process),)


def two_masses(*effects: Part, gap: float = 0.0, ratio: float = 1.0) -> Rig:
    """1 N m on J1, J1 = J2 = 0.005, k 700, d 0.01, from rest: simulator survey 6.3."""
    return Rig(
        (
            Body(name="first", inertia=0.005 / ratio**2),
            Gear(name="shaft", after="first", ratio=ratio, stiffness=700, damping=0.01, backlash=gap),
            Body(name="second", after="shaft", inertia=0.005),
            Torque(name="push", at="first", process=Noise(1.0 / ratio)),
            *effects,
        ),
        measured="shaft",
    )


def driven(*effects: Part, ki: float = 0.5, limit: float = 5.0, gap: float = 0.0, efficiency: float = 0.95) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, viscous=2e-4, coulomb=0.02, torque_limit=limit),
            Gear(name="gear", after="motor", ratio=5.0, stiffness=9e3, damping=2.0, output_inertia=6e-4,
                 efficiency=efficiency, backlash=gap),
            Coupling(name="sensor", after="gear", stiffness=1100, damping=0.3, inertia=1e-4),
            Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02),
            SpeedController(name="controller", kp=0.05, ki=ki),
            *effects,
        ),
        Run(speed=700 * pi / 30),
        measured="sensor",
    )  # fmt: skip


def test_two_masses_reach_the_matrix_exponential_of_the_simulator_survey_6_3() -> None:
    """w1 100.025004197, w2 99.974995803, shaft torque 0.486019685 after 1 s, to the digits printed."""
    made = simulate_linear(two_masses(), duration=1.00004, seed=0, settling=0.0)
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(0.486019685, abs=1e-9)
    assert made.channels["true_motor_speed_rad_s"].values[-1] == pytest.approx(100.025004197, abs=1e-9)
    assert made.channels["true_output_speed_rad_s"].values[-1] == pytest.approx(99.974995803, abs=1e-9)


@pytest.mark.parametrize("ratio", [3.0, -2.0])
def test_two_masses_behind_a_gear_are_the_same_two_masses(ratio: float) -> None:
    made = simulate_linear(two_masses(ratio=ratio), duration=1.00004, seed=0, settling=0.0)
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(0.486019685, abs=1e-9)
    assert made.channels["true_motor_speed_rad_s"].values[-1] == pytest.approx(ratio * 100.025004197, rel=1e-10)


def test_momentum_is_conserved() -> None:
    made = simulate_linear(two_masses(Probe(name="w1", quantity="speed", at="first")), duration=0.3, seed=0, settling=0)
    momentum = 0.005 * (made.channels["w1_rad_s"].values + made.channels["true_output_speed_rad_s"].values)
    assert momentum == pytest.approx(made.time(), abs=1e-11)


def test_random_load_and_set_point_agree_with_the_integrator_in_every_channel() -> None:
    """What is left between them is the integrator's error (its fourth power in the step) and the Coulomb tanh."""
    noisy = driven(
        Torque(name="load", at="wheel", process=Noise(1.0, 0.2), opposing=True),
        Torque(name="push", at="motor", process=Noise(0.0, 0.01)),
        Probe(name="gear_torque", quantity="torque", at="gear"),
        Probe(name="wheel_angle", quantity="angle", at="wheel"),
    )
    exact = simulate_linear(noisy, duration=0.5, seed=3, wander=2e-4)
    stepped = simulate(noisy, duration=0.5, seed=3, wander=2e-4, substeps=8)
    assert exact.channels.keys() == stepped.channels.keys()
    for name, channel in stepped.channels.items():
        scale = np.ptp(channel.values) if np.ptp(channel.values) else 1.0
        assert np.abs(exact.channels[name].values - channel.values).max() < 1e-6 * scale, name


def test_start_from_springs_without_torque_agrees_with_the_integrator() -> None:
    """The gear without losses: its torque changes sign while it swings in, and the direction of a loss with it."""
    loaded = driven(Torque(name="load", at="wheel", process=Noise(1.0), opposing=True), efficiency=1.0)
    exact = simulate_linear(loaded, duration=0.4, seed=3, settling=0.0)
    stepped = simulate(loaded, duration=0.4, seed=3, settling=0.0, substeps=8)
    for name, channel in stepped.channels.items():
        assert np.abs(exact.channels[name].values - channel.values).max() < 2e-6 * np.ptp(channel.values), name


@pytest.mark.parametrize("ki", [0.5, 0.0])
@pytest.mark.parametrize(
    "effect",
    [
        TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={6: 1e-4, 84: 1e-4}),
        GearMesh(name="mesh", gear="gear", order_output=84, transmission_error=(1e-7, 3e-8)),
        CommutationRipple(name="six", order_motor=42, depth=1e-4),
        BladePass(name="blades", at="wheel", order_output=4, amplitude=1e-3),
    ],
    ids=lambda effect: effect.name,
)
def test_weak_lines_agree_with_the_integrator_in_amplitude_and_phase(effect: Part, ki: float) -> None:
    """Weak, so that the lines' own wobble of the angle is weaker still; the integrator's step is 10 us.

    Without an integrator in the loop nothing brings the phase back that a lossy gear lost while it swung in.
    """
    loaded = driven(
        Torque(name="load", at="wheel", process=Noise(1.0), opposing=True), ki=ki, efficiency=0.95 if ki else 1.0
    )
    runs = {}
    for how, with_line in (("exact", simulate_linear), ("stepped", simulate)):
        more = {"substeps": 4} if how == "stepped" else {}
        sensor = [
            with_line(rig, duration=0.3, seed=5, settling=2.0, **more).channels["true_sensor_torque_Nm"].values
            for rig in (loaded + effect, loaded)
        ]
        runs[how] = sensor[0] - sensor[1]
    size = np.ptp(runs["stepped"])
    assert size > 1e-6
    assert np.abs(runs["exact"] - runs["stepped"]).max() < 2e-3 * size


def test_half_wave_squared_is_the_sum_of_its_harmonics() -> None:
    x = np.linspace(0, 2 * pi, 101)
    total = 0.25 + sum(half_wave_squared(k) * np.cos(k * x) for k in range(1, 42))
    assert total == pytest.approx(np.maximum(0, np.cos(x)) ** 2, abs=4e-4)


def test_closed_gap_is_linear_and_an_open_one_is_named_with_its_time() -> None:
    held = driven(Torque(name="load", at="wheel", process=Noise(1.0), opposing=True), gap=1e-3)
    exact = simulate_linear(held, duration=0.2, seed=1)
    stepped = simulate(held, duration=0.2, seed=1, substeps=4)
    torque = "true_sensor_torque_Nm"
    assert exact.channels[torque].values == pytest.approx(stepped.channels[torque].values, abs=1e-6)
    assert "gap of 'gear', taken as closed" in " ".join(exact.origin["left_out"])
    shaken = held + TorqueRipple(name="ripple", at="motor", group="cogging", amplitudes={12: 1.0})
    with pytest.raises(SimulationError, match=r"gap of 'gear' opens 0\.\d+ s after"):
        simulate_linear(shaken, duration=0.2, seed=1)


def test_what_is_not_linear_is_refused_by_name() -> None:
    dry = StribeckFriction(name="dry", at="second", coulomb=0.3, static=0.5, stribeck_speed=1.0)
    with pytest.raises(InputError, match="dry friction on a shaft that stands"):
        simulate_linear(two_masses(dry), duration=0.1, seed=0, settling=0)
    with pytest.raises(InputError, match=r"shaft: a gap of 0\.004 rad that no steady torque holds closed"):
        simulate_linear(two_masses(gap=0.004), duration=0.1, seed=0, settling=0)
    with pytest.raises(InputError, match="settling of 0"):
        simulate_linear(two_masses(), duration=0.1, seed=0)
    ramp = replace(driven(), run=Run(speed=70.0, profile="ramp"))
    with pytest.raises(InputError, match="profile ramp"):
        simulate_linear(ramp, duration=0.1, seed=0)
    limited = driven(Torque(name="load", at="wheel", process=Noise(1.0, 0.5), opposing=True), limit=0.3)
    with pytest.raises(SimulationError, match=r"'controller' asks for more than the limit of 0\.3 N m"):
        simulate_linear(limited, duration=0.5, seed=0)
