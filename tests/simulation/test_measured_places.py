"""Several sensors on one rig: one channel per measured place, through its own chain, with scale, zero and sense."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import (
    AccelerationSensor,
    Body,
    CurrentSensor,
    Gear,
    Motor,
    MotorEncoder,
    Probe,
    SpeedController,
    SpeedSensor,
    TorqueSensor,
)
from torquerig.simulation.simulator import simulate

RATE = 5000.0


def sensor(name: str, after: str, **more: object) -> TorqueSensor:
    stated = {"stiffness": 1100.0, "damping": 0.3, "inertia": 1e-4, "bandwidth": 500.0, "noise_rms": 0.01}
    return TorqueSensor(name=name, after=after, **{**stated, **more})  # type: ignore[arg-type]


def rig(*more: Part, also: tuple[str, ...] = (), first: Part | None = None, second: Part | None = None) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=5.0),
            first or sensor("input_sensor", "motor"),
            Gear(name="gear", after="input_sensor", ratio=4.0, stiffness=9e3, damping=2.0, output_inertia=6e-4),
            second or sensor("output_sensor", "gear", sensitivity=0.5),
            Body(name="wheel", after="output_sensor", inertia=2e-3, viscous=0.02),
            SpeedController(name="controller", kp=0.05, ki=0.5),
            MotorEncoder(name="encoder"),
            *more,
        ),
        Run(speed=80.0),
        measured="output_sensor",
        also_measured=also,
    )


def run(made: Rig) -> dict[str, np.ndarray]:
    recording = simulate(made, duration=0.5, seed=3, sample_rate=RATE)
    return {name: one.values for name, one in recording.channels.items()}


def test_a_second_sensor_changes_nothing_of_the_first() -> None:
    """Neither its amplifier nor its noise may enter the other's chain."""
    one, two = run(rig()), run(rig(also=("input_sensor",)))
    assert np.array_equal(one["torque_V"], two["output_sensor_V"])
    for name in one.keys() - {"torque_V"}:
        assert np.array_equal(one[name], two[name])
    noisier = run(rig(also=("input_sensor",), first=sensor("input_sensor", "motor", noise_rms=0.5)))
    assert np.array_equal(one["torque_V"], noisier["output_sensor_V"])
    assert np.std(noisier["input_sensor_V"] - noisier["true_torque_at_input_sensor_Nm"]) == pytest.approx(0.5, rel=0.1)


def test_every_place_says_of_which_part_it_is() -> None:
    made = simulate(rig(also=("input_sensor",)), duration=0.2, seed=3, sample_rate=RATE)
    measured = made.without_truth().channels
    assert {name: one.of for name, one in measured.items() if one.quantity == "torque"} == {
        "output_sensor_V": "output_sensor", "input_sensor_V": "input_sensor",
    }  # fmt: skip
    assert made.torque_name() == "output_sensor_V"
    assert measured["output_sensor_V"].in_si().mean() == pytest.approx(
        4 * measured["input_sensor_V"].in_si().mean(), rel=0.05
    )
    true = {one.of: name for name, one in made.channels.items() if one.truth and one.of}
    assert true == {"output_sensor": "true_sensor_torque_Nm", "input_sensor": "true_torque_at_input_sensor_Nm"}


def test_their_noises_are_independent() -> None:
    made = run(rig(also=("input_sensor",), first=sensor("input_sensor", "motor", bandwidth=1e4),
                   second=sensor("output_sensor", "gear", bandwidth=1e4)))  # fmt: skip
    noises = [
        made["output_sensor_V"] - made["true_sensor_torque_Nm"],
        made["input_sensor_V"] - made["true_torque_at_input_sensor_Nm"],
    ]
    assert abs(np.corrcoef(noises)[0, 1]) < 0.1


def test_scale_zero_and_sense_of_a_sensor_are_in_its_volts() -> None:
    """V = sensitivity (sign scale T + zero), and the channel in SI has the sense of the rig."""
    quiet = {"noise_rms": 0.0, "converter_bits": 32, "sensitivity": 0.5}
    plain = run(rig(second=sensor("output_sensor", "gear", **quiet)))["torque_V"]
    for sign, mounting in ((1.0, "forward"), (-1.0, "reversed")):
        off = sensor("output_sensor", "gear", scale=1.02, zero=0.3, mounting=mounting, **quiet)
        made = simulate(rig(second=off), duration=0.5, seed=3, sample_rate=RATE).channels["torque_V"]
        assert made.values == pytest.approx(1.02 * sign * plain + 0.5 * 0.3, abs=1e-7)
        assert made.in_si() == pytest.approx(1.02 * plain / 0.5 + sign * 0.3, abs=1e-7)


def test_speed_acceleration_and_current_are_measured() -> None:
    """Against the truth of the same run: the derivative of the speed, the motor's torque over its constant."""
    more = (
        SpeedSensor(name="tacho", at="wheel", scale=1.01, zero=0.2),
        AccelerationSensor(name="shaker", at="wheel"),
        CurrentSensor(name="amps", at="motor", torque_constant=0.1, mounting="reversed"),
        Probe(name="here", quantity="acceleration", at="wheel"),
        Probe(name="aside", quantity="torque", at="gear"),
    )
    made = simulate(rig(*more, also=("tacho", "shaker", "amps", "here")), duration=0.5, seed=3, sample_rate=RATE)
    read = made.channels
    assert (read["tacho_rad_s"].quantity, read["shaker_rad_s2"].unit, read["amps_A"].unit) == ("speed", "rad/s^2", "A")
    assert read["tacho_rad_s"].values == pytest.approx(1.01 * read["true_output_speed_rad_s"].values + 0.2, abs=1e-9)
    gradient = np.gradient(read["true_output_speed_rad_s"].values) * RATE
    assert read["shaker_rad_s2"].values[5:-5] == pytest.approx(gradient[5:-5], abs=0.05 * np.ptp(gradient))
    assert np.array_equal(read["here_rad_s2"].values, read["shaker_rad_s2"].values)
    assert read["amps_A"].in_si() == pytest.approx(read["true_motor_torque_Nm"].values / 0.1)
    assert np.array_equal(read["amps_A"].values, -read["amps_A"].in_si())
    assert read["aside_Nm"].role == "context"
    assert made.torque_name() == "output_sensor_V"


def test_a_speed_of_a_shaft_between_is_never_taken_for_the_output() -> None:
    """Of the motor's shaft, of the compared torque's, and of another: 4 to 1 between them."""
    more = (
        SpeedSensor(name="slow", at="wheel"),
        SpeedSensor(name="fast", at="motor"),
        Probe(name="turned", quantity="angle", at="motor"),
    )
    made = simulate(rig(*more, also=("slow", "fast")), duration=0.2, seed=3, sample_rate=RATE)
    read = {name: (made.channels[name].quantity, made.channels[name].role) for name in
            ("slow_rad_s", "fast_rad_s", "turned_rad")}  # fmt: skip
    assert read == {"slow_rad_s": ("speed", None), "fast_rad_s": ("motor_speed", None),
                    "turned_rad": ("motor_angle", None)}  # fmt: skip
    inner = replace(rig(*more, also=("slow", "fast")), measured="input_sensor")
    made = simulate(inner, duration=0.2, seed=3, sample_rate=RATE)
    assert made.channels["slow_rad_s"].role == "context"
    assert made.find("speed") is None


def test_a_rig_whose_only_sensor_is_one_of_speed_simulates() -> None:
    made = simulate(replace(rig(SpeedSensor(name="tacho", at="wheel", noise_rms=0.1)), measured="tacho"),
                    duration=0.3, seed=3, sample_rate=RATE)  # fmt: skip
    assert set(made.without_truth().channels) == {"speed_rad_s", "encoder_count"}
    rms = np.std(made.channels["speed_rad_s"].values - made.channels["true_sensor_speed_rad_s"].values)
    assert rms == pytest.approx(0.1, rel=0.1)
    assert made.channels["true_motor_speed_rad_s"].values.mean() == pytest.approx(80.0, rel=2 / pi * 0.05)
