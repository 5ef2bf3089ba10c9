"""Numbers to quote: intervals stay intervals, unknown stays unknown, shares and errors are what they say."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.errors import RecordingError
from torquerig.mechanisms import QuadraticDrag, TorqueRipple
from torquerig.metrics.drive_margins import Duty, drive_margins
from torquerig.metrics.figure import Figure, scaled, total
from torquerig.metrics.residual_disturbance import simulated_reading_pair
from torquerig.metrics.shares import Shares, reading_shares
from torquerig.metrics.truth_error import truth_error
from torquerig.parameter import Estimate
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Motor, SpeedController
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower
from torquerig.simulation.simulator import simulate

DUTY = Duty(output_speed=200 * pi / 30, mean_torque=1.0, ratio=5.0, efficiency=0.97, torque_limit=2.0)


def test_a_documented_value_is_scaled_and_keeps_its_source() -> None:
    made = scaled(Estimate(1.27, evidence="DOC", source="maker"), 4.0, unit="N*m", missing="rated torque")
    assert (made.value, made.low, made.source, made.shown()) == (5.08, None, "maker (DOC)", "5.08")


def test_a_guess_stays_an_interval_without_a_value() -> None:
    made = scaled(Estimate(None, 0.1, 0.4, source="class"), 2.0, unit="N*m", missing="rated torque")
    assert (made.value, made.low, made.high) == (None, 0.2, 0.8)
    assert made.missing == "rated torque"
    assert made.shown() == "0.2..0.8"
    turned = scaled(Estimate(None, 0.1, 0.4), 2.0, unit="1", missing="x", inverse=True)
    assert (turned.low, turned.high) == (5.0, 20.0)


def test_an_unknown_stays_unknown_also_in_a_sum() -> None:
    unknown = scaled(Estimate(), 2.0, unit="EUR", missing="price of x")
    assert unknown.unknown
    assert unknown.shown() == "?"
    summed = total([Figure(value=10.0, unit="EUR"), unknown], unit="EUR")
    assert summed.unknown
    assert summed.missing == "price of x"


def test_a_sum_adds_values_and_intervals() -> None:
    assert total([Figure(value=10.0), Figure(value=5.0)], unit="EUR").value == 15.0
    mixed = total([Figure(value=10.0), Figure(low=5.0, high=7.0, missing="m")], unit="EUR")
    assert (mixed.value, mixed.low, mixed.high, mixed.missing) == (None, 15.0, 17.0, "m")


def test_margins_of_the_present_drive_cost_nothing() -> None:
    catalog = load_catalog(shipped_folder())
    made = drive_margins(
        catalog.motor("bldc-12n14p"), catalog.gearbox("reference-5-1"), DUTY, new_motor=False, new_stage=False
    )
    assert made["price"].value == 0.0
    assert made["new_parts"].value == 0.0
    assert made["sensor_peak"].value == pytest.approx(2.0 * 5 * 0.97)


def test_margins_of_a_documented_motor_are_its_ratings_over_the_duty() -> None:
    catalog = load_catalog(shipped_folder())
    motor = catalog.motor("HDS6A-0104A")
    made = drive_margins(motor, catalog.gearbox("reference-5-1"), DUTY, new_motor=True, new_stage=True)
    assert motor.rated_torque.value is not None
    assert made["continuous_output_torque"].value == pytest.approx(motor.rated_torque.value * 5 * 0.97)
    assert made["torque_reserve"].value == pytest.approx(motor.rated_torque.value * 5 * 0.97 / 1.0)
    assert motor.rated_speed.value is not None
    assert made["speed_use"].value == pytest.approx(1000 * pi / 30 / motor.rated_speed.value)
    assert made["new_parts"].value == 4.0
    idle = drive_margins(
        motor, catalog.gearbox("reference-5-1"), replace(DUTY, mean_torque=0.0), new_motor=True, new_stage=True
    )
    assert idle["torque_reserve"].unknown, "a reserve over no load is no number"


def rig(*effects: Part) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1e-3, torque_limit=10.0),
            Coupling(name="sensor", after="motor", stiffness=1100, damping=0.5),
            Body(name="wear_part", after="sensor", inertia=1e-3),
            SpeedController(name="loop", kp=0.02, ki=0.0),
            *effects,
        ),
        Run(speed=60.0),
        measured="sensor",
    )


def test_a_share_is_the_rms_of_the_line_that_the_group_brings() -> None:
    """Against the linear twin with its loop closed; the groups' lines do not lie on each other."""
    ripples = [
        TorqueRipple(name=group, at="motor", group=group, amplitudes={order: amplitude})
        for group, order, amplitude in (("cogging", 3, 0.04), ("electrical", 5, 0.02), ("mechanical", 7, 0.01))
    ]
    shares = reading_shares(rig(*ripples), duration=2.0, seed=1, settling=0.2)
    lines = np.array([3.0, 5.0, 7.0]) * 60 / (2 * pi)
    passed = np.abs(spring_response(lower(rig(*ripples), 1), "sensor", lines, speed_loop=True)["motor"])
    expected = passed * [0.04, 0.02, 0.01] / sqrt(2)
    assert [shares.cogging, shares.electrical, shares.mechanical] == pytest.approx(expected, rel=0.02)
    pair = simulated_reading_pair(rig(*ripples), duration=2.0, seed=1, settling=0.2)
    assert pair.disturbance == pytest.approx(shares.disturbance, rel=0.01)


def test_without_disturbance_all_is_load() -> None:
    drag = QuadraticDrag(name="drag", coefficient=1e-4)
    shares = reading_shares(rig(drag), duration=0.2, seed=1, settling=0.1)
    assert shares.disturbance == 0.0
    assert shares.percent()["load"] == pytest.approx(100)


def test_shares_in_percent_are_shares_of_the_power() -> None:
    made = Shares(mean=1.0, load=3.0, cogging=4.0, electrical=0.0, mechanical=0.0)
    assert made.percent() == pytest.approx({"load": 36.0, "cogging": 64.0, "electrical": 0.0, "mechanical": 0.0})
    still = Shares(mean=0.0, load=0.0, cogging=0.0, electrical=0.0, mechanical=0.0)
    assert sum(still.percent().values()) == 0.0


def test_the_truth_error_is_the_rms_of_the_difference_mean_included() -> None:
    made = simulate(rig(QuadraticDrag(name="drag", coefficient=1e-4)), duration=0.1, seed=1, settling=0.1)
    truth = made.channels["true_load_Nm"].values
    wave = 0.3 + 0.4 * np.sin(2 * pi * np.arange(truth.size) / 50)  # whole periods
    reading = made.with_values("torque_V", truth + wave)
    assert truth_error(reading, made) == pytest.approx(sqrt(0.3**2 + 0.4**2 / 2), rel=1e-9)
    with pytest.raises(RecordingError, match="the true load is not known; only a simulated recording has"):
        truth_error(reading, made.without_truth())
