"""Effects whose size or order comes from what can be measured with a rule: bearings, offsets, belts, weights, gaps."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.mechanisms import BearingDefect, BeltLines, BendingCrosstalk, Eccentricity, ParallelOffset
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import KinematicError, waves_of
from torquerig.rig.parts import BeltStage, Body, Coupling, Gear, Motor, SpeedController, TorqueSensor
from torquerig.sensor_stages.crosstalk import Crosstalk
from torquerig.simulation.simulator import simulate

SKF_6205 = {"balls": 9, "ball_diameter": 0.3126 * 0.0254, "pitch_diameter": 1.537 * 0.0254}


@pytest.mark.parametrize(
    ("fault", "order"), [("outer", 3.5848), ("inner", 5.4152), ("cage", 0.39828), ("ball", 4.7135 / 2)]
)
def test_an_skf_6205_has_the_orders_of_the_case_western_bearing_data_center(fault: str, order: float) -> None:
    """Drive end: 9 balls of 0.3126 in on 1.537 in, orders rounded there; its ball order counts both races."""
    bearing = BearingDefect(name="b", fault=fault, **SKF_6205, ring_frequency=2000.0, amplitude=0.1)  # type: ignore[arg-type]
    assert bearing.order == pytest.approx(order, rel=1e-4)


def test_a_contact_angle_moves_both_races_together_towards_half_the_balls() -> None:
    steep = {**SKF_6205, "contact_angle": pi / 4, "ring_frequency": 2000.0, "amplitude": 0.1}
    inner, outer = (BearingDefect(name="b", fault=f, **steep).order for f in ("inner", "outer"))  # type: ignore[arg-type]
    assert inner + outer == pytest.approx(9.0)
    assert inner - outer == pytest.approx(9 * 0.3126 / 1.537 * np.sqrt(0.5))


@pytest.mark.parametrize(
    ("stated", "told"),
    [
        ({}, "state either order_output, or fault, balls"),
        ({"order_output": 3.5, "fault": "outer"}, "state either order_output, or fault, balls"),
        ({"fault": "outer", "balls": 9}, "state either order_output, or fault, balls"),
        ({**SKF_6205, "fault": "outer", "balls": 40}, "40 balls .* do not fit on a circle"),
    ],
)
def test_a_bearing_that_is_half_stated_or_cannot_be_is_refused(stated: dict[str, object], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        BearingDefect(name="b", ring_frequency=2000.0, amplitude=0.1, **stated)  # type: ignore[arg-type]


@pytest.mark.parametrize(("jaws", "unequal"), [(2, 0.0), (2, 0.2), (3, 0.3), (4, 0.1)])
def test_a_parallel_offset_turns_as_jaws_that_share_a_pin_in_a_slot(jaws: int, unequal: float) -> None:
    """Summed jaw by jaw: a pin at radius 1 seen from an axis that is d beside, each with its share of the torque."""
    theta = 2 * pi * np.arange(512) / 512
    shares = [(1 + unequal) / jaws] + [(1 - unequal / (jaws - 1)) / jaws] * (jaws - 1)
    error = sum(
        share * np.angle(1 + 0.05 * np.exp(-1j * (theta + 2 * pi * k / jaws))) for k, share in enumerate(shares)
    )
    lines = 2 * np.abs(np.fft.rfft(error)) / 512
    offset = ParallelOffset(name="o", offset=0.5e-3, radius=10e-3, jaws=jaws, unequal_share=unequal)
    expected = {order: float(lines[order]) for order in range(1, 5) if lines[order] > 1e-12}
    assert offset.amplitudes() == pytest.approx(expected, rel=1e-9)


def test_an_offset_that_no_coupling_turns_with_is_refused() -> None:
    with pytest.raises(ValueError, match="more than half the radius"):
        ParallelOffset(name="o", offset=6e-3, radius=10e-3)
    with pytest.raises(ValueError, match="write at least 2"):
        ParallelOffset(name="o", offset=1e-4, radius=10e-3, jaws=1)


def belt_rig(*effects: Part, gear: Part | None = None, speed_rpm: float = 600.0) -> Rig:
    stage = gear or BeltStage(
        name="gearbox", after="motor", pinion_teeth=20, wheel_teeth=50, belt_teeth=100, pitch=5e-3, belt_stiffness=2e5,
        strand_damping=300.0, wheel_inertia=7e-4,
    )  # fmt: skip
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            stage,
            Coupling(name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5),
            Body(name="wear_part", after="sensor", inertia=2e-3),
            SpeedController(name="loop", kp=0.01, ki=0.0),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


@pytest.mark.parametrize("speed_rpm", [600.0, 930.0])
def test_belt_lines_take_their_orders_from_the_belt_they_live_in(speed_rpm: float) -> None:
    """Handbook 3.7: belt pass z_wheel/z_belt below both shafts, mesh z_wheel, pulleys 1 and z_wheel/z_pinion."""
    lines = BeltLines(
        name="it", belt_error=(5e-4,), tooth_error=2e-5, pinion_eccentricity=2e-5, wheel_eccentricity=3e-5
    )
    rig = belt_rig(lines, speed_rpm=speed_rpm)
    radius = 50 * 5e-3 / (2 * pi)
    found = {wave.order: wave.amplitude for wave in waves_of(lines.changes_in_host(rig), KinematicError)}
    assert found == pytest.approx({0.5: 5e-4, 50.0: 2e-5, 1.0: 3e-5 / radius, 2.5: 2e-5 / radius})
    made = simulate(rig, duration=2.0, seed=1)
    angle = made.channels["true_motor_angle_rad"].values / 2.5
    orders = (0.5, 1.0, 2.5, 50.0, 0.75, 1.75, 47.0)
    waves = np.column_stack([np.ones(angle.size), *[f(o * angle) for o in orders for f in (np.cos, np.sin)]])
    window = np.hanning(angle.size)
    fitted = np.linalg.lstsq(waves * window[:, None], made.torque() * window, rcond=None)[0][1:]
    sizes = np.hypot(fitted[::2], fitted[1::2])
    assert sizes[:4].min() > 10 * sizes[4:].max()


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (
            BeltLines(name="it", pinion=20, wheel=100, belt_teeth=120),
            "is not the belt of 100 round pulleys of 20 and 50",
        ),
        (BeltLines(name="it", gear="sensor"), "'sensor' is no gear"),
    ],
    ids=["other belt", "no gear"],
)
def test_belt_lines_of_another_belt_are_refused(lines: BeltLines, told: str) -> None:
    with pytest.raises(InputError, match=told):
        belt_rig(lines).terms()


def test_belt_lines_in_a_gear_or_on_a_smooth_belt_say_what_lacks() -> None:
    plain = Gear(name="gearbox", after="motor", ratio=2.5, stiffness=5000, damping=1.0, output_inertia=1e-3)
    with pytest.raises(InputError, match="gearbox is no belt; write pinion, wheel and belt_teeth"):
        belt_rig(BeltLines(name="it"), gear=plain).terms()
    with pytest.raises(InputError, match="states no radius; write a runout"):
        belt_rig(BeltLines(name="it", pinion=20, wheel=50, belt_teeth=100, wheel_eccentricity=1e-5), gear=plain).terms()
    smooth = BeltStage(
        name="gearbox", after="motor", pinion_diameter=0.04, wheel_diameter=0.1, belt_length=0.6, belt_stiffness=2e5,
        strand_damping=300.0, wheel_inertia=7e-4,
    )  # fmt: skip
    with pytest.raises(InputError, match="is a smooth belt; leave tooth_error out"):
        belt_rig(BeltLines(name="it", tooth_error=1e-5), gear=smooth).terms()
    rig = belt_rig(BeltLines(name="it", belt_error=(1e-4,)), gear=smooth)
    (wave,) = waves_of(rig.part("it").changes_in_host(rig), KinematicError)
    assert wave.order == pytest.approx(pi * 0.1 / 0.6)  # pi D f / L, handbook 3.7
    with pytest.raises(ValueError, match="belong together"):
        BeltLines(name="it", pinion=20)


def test_a_rotor_off_by_a_length_is_off_by_that_share_of_the_magnetic_gap() -> None:
    """0.15 mm of a magnetic gap of 0.5 + 2.6/1.05 mm is 5.04 %."""
    gap = 0.5e-3 + 2.6e-3 / 1.05
    shared = {"name": "e", "slots": 9, "pole_pairs": 4, "tooth_torque": 0.1}
    by_length = Eccentricity(**shared, magnetic_gap=gap, static_offset=0.15e-3)  # type: ignore[arg-type]
    by_share = Eccentricity(**shared, static=0.15e-3 / gap)  # type: ignore[arg-type]
    assert by_length.amplitudes() == by_share.amplitudes()
    with pytest.raises(ValueError, match="needs the gap that it narrows"):
        Eccentricity(**shared, static_offset=1e-4)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"dynamic eccentricity of 0\.5 .* at most 0\.4"):
        Eccentricity(**shared, magnetic_gap=1e-3, dynamic_offset=0.5e-3)  # type: ignore[arg-type]


def test_a_weight_on_the_sensor_reads_as_its_bending_moment_times_the_cross_talk() -> None:
    """c m g l and c m x l (signatures.md 6.4, 3.1): 1 % of 2 kg at 60 mm is 11.8 mN m."""
    weighed = BendingCrosstalk(name="it", coefficient=0.01, mass=2.0, lever=0.06, mass_eccentricity=1e-4)
    sensor = TorqueSensor(
        name="torque_sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5, bandwidth=3000
    )
    rig = belt_rig(Body(name="load", after="sensor", inertia=1e-3))
    rig = Rig((*rig.parts[:2], sensor, Body(name="drum", after="torque_sensor", inertia=2e-3), weighed), rig.run)
    (stage,) = (placed.stage for placed in weighed.stages(rig))
    assert isinstance(stage, Crosstalk)
    assert stage.once == pytest.approx(0.01 * 2.0 * 9.80665 * 0.06)
    assert stage.once_by_speed_squared == pytest.approx(0.01 * 2.0 * 1e-4 * 0.06)
