"""What the linear twin expects of a run against runs of the simulator: lines, spectrum, level, all within chance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.choosing.trial import LEAST_GAIN
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.misfit import misfit
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import observed
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle, shaft_angles
from torquerig.inference.places import frequency, order
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import (
    BladePass,
    CommutationRipple,
    GearMesh,
    MainsInterference,
    QuadraticDrag,
    Quantization,
    SensorBandwidth,
    StribeckFriction,
    TorsionalMode,
)  # fmt: skip
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.model import Scenario
from torquerig.simulation.simulator import simulate

SPEED = 1000 * pi / 30
Record = Callable[..., Recording]

EFFECTS: dict[str, Part | None] = {
    "none": None,
    "mesh": GearMesh(name="effect", order_output=84.0, transmission_error=(6e-5, 2e-5)),
    "ripple": CommutationRipple(name="effect", order_motor=10.0, depth=0.08),
    "blades": BladePass(name="effect", order_output=5.0, amplitude=0.4),
    "branch": TorsionalMode(name="effect", after="wear_part", frequency=85.0, inertia=8e-4, damping_ratio=0.03),
    "amplifier": SensorBandwidth(name="effect", cutoff=120.0),
    "hum": MainsInterference(name="effect", frequency=50.02, amplitudes=(0.05, 0.0, 0.02)),
    "codes": Quantization(name="effect", step=0.02),
    "drag": QuadraticDrag(name="effect", coefficient=4e-4),
    "friction": StribeckFriction(name="effect", coulomb=0.2, static=0.4, stribeck_speed=1.0),
}


def seen(rig: Rig, recording: Recording) -> Features:
    angles = shaft_angles([recording], rig)
    run = observed(recording, angles[0], ratio=5.0)
    lines = sorted({order(line.order) for line in Twin(rig.at(run.run)).lines()})
    tones = [frequency(50.02), frequency(150.06)]
    return features(run, [*lines, *tones], held=None)


@pytest.mark.long
@pytest.mark.parametrize("name", EFFECTS)
def test_the_twin_of_a_rig_expects_what_that_rig_records(name: str, wear_rig: Scenario, record: Record) -> None:
    """Mean squares of residuals are about 1 for the true model: 80 bands scatter by 16 %, so 2 is beyond chance."""
    effect = EFFECTS[name]
    rig = wear_rig.rig if effect is None else wear_rig.rig + effect
    for rpm, seed in ((1000.0, 1), (700.0, 2)):
        run = seen(rig, record(rig, seed, rpm=rpm))
        residuals = misfit(run, expected(rig, run))
        assert np.mean(residuals.bands**2) < 2.0, rpm
        assert np.mean(residuals.lines[residuals.lines != 0] ** 2) < 2.0, rpm
        assert np.mean(residuals.level**2) < 3.0, rpm
        assert np.abs(residuals.all()).max() < 6.0, rpm


@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in EFFECTS if name != "none"])
def test_the_twin_without_the_effect_does_not(name: str, wear_rig: Scenario, record: Record) -> None:
    effect = EFFECTS[name]
    assert effect is not None
    rig = wear_rig.rig + effect
    run = seen(rig, record(rig, 1))
    without, own = (misfit(run, expected(each, run)) for each in (wear_rig.rig, rig))
    assert np.sum(without.all() ** 2) > LEAST_GAIN + np.sum(own.all() ** 2)


@pytest.mark.long
def test_strong_lines_agree_within_chance_and_a_hundredth(wear_rig: Scenario, record: Record) -> None:
    rig = wear_rig.rig
    run = seen(rig, record(rig, 4, duration=10.0))
    model = expected(rig, run)
    size, line = np.abs(run.amplitude).mean(axis=0), model.amplitude.mean(axis=0)
    chance = np.sqrt(model.variance.mean(axis=0) / len(run.level))
    strong = np.isfinite(size) & (line > 14 * chance)
    assert {place.at for place, clear in zip(run.places, strong, strict=True) if clear} >= {6.0, 7.0, 12.0}
    assert np.all(np.abs(size - line)[strong] < 4 * chance[strong] + 0.01 * line[strong])


def test_a_ramp_shows_each_line_at_the_speed_of_each_stretch(wear_rig: Scenario, record: Record) -> None:
    rig = wear_rig.rig
    run = seen(rig, record(rig, 6, profile="ramp"))
    assert run.power.size == 0
    residuals = misfit(run, expected(rig, run))
    assert np.mean(residuals.lines[residuals.lines != 0] ** 2) < 1.5
    assert np.mean(residuals.level**2) < 1.5


@pytest.mark.parametrize("rpm", [300.0, 1000.0])
@pytest.mark.parametrize("occupancy", [0.0, 15.0])
def test_power_balance_of_a_steady_run(rpm: float, occupancy: float, wear_rig: Scenario) -> None:
    """Means over a run: what the motor gives is what friction, load and gear take; the sensor carries its part."""
    drag = wear_rig.rig + QuadraticDrag(name="drag", coefficient=2e-4)
    rig = drag.at(Run(**{**vars(drag.run), "speed": rpm * pi / 30, "occupancy_percent": occupancy}))
    made = simulate(rig, duration=4.0, seed=3, sample_rate=5000.0)
    channels = {name: float(channel.values.mean()) for name, channel in made.channels.items()}
    balance = quasi_static(Twin(rig), speed=np.array([rpm * pi / 30]), acceleration=np.zeros(1))
    viscous = 0.010 * rpm * pi / 30 / 5 + 2e-4 * (rpm * pi / 30 / 5) ** 2
    # the load's own slow variation, 6 % through 1.5 Hz, has not averaged out after 4 s: about 2 %
    mean = float(made.channels["true_load_Nm"].values.mean())
    assert channels["true_sensor_torque_Nm"] == pytest.approx(mean, abs=2e-3)
    assert balance.sensor[0] == pytest.approx(channels["true_sensor_torque_Nm"], rel=0.05)
    assert balance.sensor[0] > viscous
    assert balance.motor[0] == pytest.approx(channels["true_motor_torque_Nm"], rel=0.05)
    own = 1.5e-4 * rpm * pi / 30 + 0.015
    assert balance.motor[0] == pytest.approx(balance.sensor[0] / 5 / 0.97 + own, rel=1e-6)


def test_acceleration_asks_for_torque_by_inertia(wear_rig: Scenario) -> None:
    twin = Twin(wear_rig.rig)
    held, speeding = (
        quasi_static(twin, speed=np.array([SPEED]), acceleration=np.array([each])) for each in (0.0, 50.0)
    )
    behind = 2.0e-3 + 4.0e-5  # wear part and the sensor's output side
    assert speeding.sensor[0] - held.sensor[0] == pytest.approx(behind * 50.0 / 5, rel=1e-9)


def test_dry_friction_turns_with_the_motion(wear_rig: Scenario) -> None:
    rubbing = wear_rig.rig + StribeckFriction(
        name="friction", coulomb=0.3, static=0.7, stribeck_speed=1.0, coulomb_backward=0.2, static_backward=0.5
    )
    speeds = np.array([-200.0, -5.0, 5.0, 200.0])
    added = (
        quasi_static(Twin(rubbing), speed=speeds, acceleration=np.zeros(4)).sensor
        - quasi_static(Twin(wear_rig.rig), speed=speeds, acceleration=np.zeros(4)).sensor
    )
    near = np.exp(-1.0)  # 5 rad/s at the motor are the Stribeck speed at the output
    assert added == pytest.approx([-0.2, -(0.2 + 0.3 * near), 0.3 + 0.4 * near, 0.3], rel=1e-6)


@pytest.mark.long
def test_without_an_encoder_the_shaft_is_followed_in_the_torque(wear_rig: Scenario, record: Record) -> None:
    rig = wear_rig.rig
    bare = [record(rig, 7, encoder=False), record(rig, 8, rpm=700.0, encoder=False)]
    angles = shaft_angles(bare, rig)
    assert [angle.factor for angle in angles] == pytest.approx([1.004, 1.004], abs=2e-4)
    assert not any(angle.measured for angle in angles)
    full = shaft_angles([record(rig, 7), record(rig, 8, rpm=700.0)], rig)
    assert all(isinstance(angle, ShaftAngle) and angle.measured for angle in full)
    for followed, measured in zip(angles, full, strict=True):
        drift = (followed.values - followed.values[0]) - (measured.values - measured.values[0])
        # a tenth of a turn over some hundred turns: order 7 keeps its phase through each stretch
        assert np.abs(drift - drift.mean()).max() < 2 * pi * 0.1


def test_a_ramp_without_an_encoder_turns_as_the_rig_would(wear_rig: Scenario, record: Record) -> None:
    rig = wear_rig.rig
    ramp = record(rig, 9, profile="ramp", encoder=False)
    angles = shaft_angles([record(rig, 7), ramp], rig)
    assert [angle.factor for angle in angles] == pytest.approx([1.004, 1.004], abs=3e-4)
    measured = shaft_angles([record(rig, 9, profile="ramp")], rig)[0]
    turned = angles[1].values[-1] - angles[1].values[0]
    assert turned == pytest.approx(measured.values[-1] - measured.values[0], rel=1e-3)
    assert "simulated" in angles[1].origin


def test_features_see_no_sample_that_is_held_out(wear_rig: Scenario, record: Record) -> None:
    recording = record(wear_rig.rig, 1)
    angles = shaft_angles([recording], wear_rig.rig)
    run = observed(recording, angles[0], ratio=5.0)
    spoilt = run.torque.copy()
    for stretch in run.stretches:
        if stretch.held:
            spoilt[stretch.start : stretch.stop] = 99.0
    one, other = (features(each, [order(1.0)]) for each in (run, replace(run, torque=spoilt)))
    assert np.array_equal(one.power, other.power, equal_nan=True)
    assert np.array_equal(one.amplitude, other.amplitude)
    assert 0.25 < sum(s.stop - s.start for s in run.stretches if s.held) / run.torque.size < 0.4
