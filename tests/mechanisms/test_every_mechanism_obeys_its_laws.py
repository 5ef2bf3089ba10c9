"""Every mechanism of the library, in one table: zero size changes nothing, and its lines stand where the handbook says.

A mechanism without a row fails here. A row states the effect, the same at zero size (or why there is no such size),
and the lines: orders of the motor's shaft on 5:1, or fixed frequencies, or why it has none.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from inspect import getdoc
from math import pi

import numpy as np
import pytest

from torquerig import mechanisms
from torquerig.mechanisms import (
    BackEmfHarmonics,
    Backlash,
    BearingDefect,
    BeltLines,
    BendingCrosstalk,
    BladePass,
    Clipping,
    Cogging,
    CommutationRipple,
    CurrentGain,
    CurrentOffset,
    DeadTime,
    Eccentricity,
    EncoderError,
    FieldOrientedControl,
    FlickerNoise,
    GainRipple,
    GearMesh,
    GranularDrag,
    HallMisplacement,
    Imbalance,
    JawCoupling,
    LoggerLowPass,
    LugreFriction,
    MainsInterference,
    Misalignment,
    NoiseHump,
    ParallelOffset,
    ParticleLoad,
    PhaseUnbalance,
    PwmAliasing,
    PwmRipple,
    QuadraticDrag,
    Quantization,
    ReadingCourse,
    SensorBandwidth,
    SensorDrift,
    SensorHysteresis,
    SensorNonlinearity,
    SignalDropout,
    SixStepCommutation,
    SpeedCourse,
    StribeckFriction,
    ToothMesh,
    TorqueRipple,
    TorsionalMode,
    TurbulentLoad,
)
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, MotorEncoder, MotorPhases, SpeedController, TorqueSensor
from torquerig.simulation.simulator import simulate

WINDING = {"slots": 12, "pole_pairs": 7}
BELT = {"pinion": 20, "wheel": 100, "belt_teeth": 160}
BALLS = {"balls": 8, "ball_diameter": 8e-3, "pitch_diameter": 40e-3}
FIFTH = TorqueRipple(name="fifth", at="wear_part", group="mechanical", amplitudes={25.0: 0.2})  # of the motor


@dataclass(frozen=True, kw_only=True)
class Row:
    """What one mechanism must do; ``orders`` and ``hertz`` of its lines, ``others`` what it needs in the rig."""

    effect: Part
    nothing: Part | None = None
    why_no_zero: str = ""
    orders: tuple[float, ...] = ()
    hertz: tuple[float, ...] = ()
    why_no_lines: str = ""
    others: tuple[Part, ...] = ()


ROWS: tuple[Row, ...] = (
    # motor and drive: signatures.md 1 and 2
    Row(
        effect=BackEmfHarmonics(name="it", shares={5: 0.04, 7: 0.01, 11: 0.01}),
        nothing=BackEmfHarmonics(name="it", shares={5: 0.0, 7: 0.0}),
        orders=(42, 84),
    ),
    Row(
        effect=Cogging(name="it", **WINDING, native=0.01, unequal_magnets=0.01, unequal_teeth=0.01),
        nothing=Cogging(name="it", **WINDING),
        orders=(12, 14, 84),
    ),
    Row(
        effect=CommutationRipple(name="it", order_motor=42, depth=0.05),
        nothing=CommutationRipple(name="it", order_motor=42, depth=0.0),
        orders=(42,),
    ),
    Row(
        effect=CurrentGain(name="it", pole_pairs=7, mismatch=0.02),
        nothing=CurrentGain(name="it", pole_pairs=7, mismatch=0.0),
        orders=(14,),
    ),
    Row(
        effect=CurrentOffset(name="it", pole_pairs=7, torque_constant=0.11, offset_a=0.02),
        nothing=CurrentOffset(name="it", pole_pairs=7, torque_constant=0.11, offset_a=0.0),
        orders=(7,),
    ),
    Row(effect=DeadTime(name="it", dead_time=1e-6), nothing=DeadTime(name="it", dead_time=0.0), orders=(42, 84)),
    Row(
        effect=Eccentricity(name="it", **WINDING, tooth_torque=0.1, static=0.2, dynamic=0.2),
        nothing=Eccentricity(name="it", **WINDING, tooth_torque=0.1),
        orders=(11, 12, 13, 14, 15),
    ),
    Row(
        effect=EncoderError(name="it", amplitudes={2: 0.005}, offset=0.01),
        nothing=EncoderError(name="it", amplitudes={2: 0.0}),
        orders=(2, 4),
    ),
    Row(
        effect=FieldOrientedControl(name="it", current_offset=(0.02, 0.0)),
        nothing=FieldOrientedControl(name="it"),
        orders=(7,),
    ),
    Row(
        effect=HallMisplacement(name="it", shift=(0.1, -0.05, 0.0)),
        nothing=HallMisplacement(name="it"),
        orders=(14, 28),
    ),
    Row(
        effect=PhaseUnbalance(name="it", extra_resistance=(0.05, 0.0, 0.0)),
        nothing=PhaseUnbalance(name="it"),
        orders=(14,),
    ),
    Row(
        effect=PwmRipple(name="it", switching_frequency=20e3),
        why_no_zero="it goes out with a frequency without end, and no size goes in",
        hertz=(5000,),
    ),
    Row(
        effect=SixStepCommutation(name="it"),
        why_no_zero="the machine commutates or does not; no size goes in",
        orders=(42, 84),
    ),
    Row(
        effect=TorqueRipple(name="it", at="motor", group="electrical", amplitudes={7.0: 0.015, 21.0: 0.01}),
        nothing=TorqueRipple(name="it", at="motor", group="electrical", amplitudes={7.0: 0.0}),
        orders=(7, 21),
    ),
    # shafts and gears: signatures.md 3 and 4
    Row(
        effect=Backlash(name="it", gap=0.004),
        nothing=Backlash(name="it", gap=0.0),
        why_no_lines="only where the torque turns round: test_rattle_and_hunting.py",
    ),
    Row(
        effect=BearingDefect(name="it", fault="outer", **BALLS, ring_frequency=300.0, amplitude=0.2),
        nothing=BearingDefect(name="it", order_output=3.2, ring_frequency=300.0, amplitude=0.0),
        orders=(4 * 0.8 / 5, 8 * 0.8 / 5, 12 * 0.8 / 5),
    ),
    Row(
        effect=BeltLines(name="it", **BELT, belt_error=(1e-3,), tooth_error=2e-5, pinion_runout=2e-4),
        nothing=BeltLines(name="it", **BELT, belt_error=(0.0,)),
        orders=(0.125, 1, 20),
    ),
    Row(
        effect=GearMesh(name="it", order_output=84, transmission_error=(5e-5, 2e-5), planet_modulation=0.2),
        nothing=GearMesh(name="it", order_output=84, transmission_error=(0.0, 0.0)),
        orders=(16.2, 16.8, 17.4, 33.6),
    ),
    Row(
        effect=Imbalance(name="it", mass=0.5, eccentricity=1e-3),
        nothing=Imbalance(name="it", mass=0.5, eccentricity=0.0),
        orders=(0.2,),
    ),
    Row(
        effect=JawCoupling(name="it", jaws=3, jaw_error=1e-3, leg_error=5e-4),
        nothing=JawCoupling(name="it", jaws=3),
        orders=(0.6, 1.2),
    ),
    Row(effect=Misalignment(name="it", angle=0.1), nothing=Misalignment(name="it", angle=0.0), orders=(0.4,)),
    Row(
        effect=ParallelOffset(name="it", offset=1e-3, radius=1e-2, unequal_share=0.1),
        nothing=ParallelOffset(name="it", offset=0.0, radius=1e-2, unequal_share=0.1),
        orders=(0.2, 0.4),
    ),
    Row(
        effect=ToothMesh(
            name="it",
            module=1e-3,
            tooth_error=(5e-6, 2e-6),
            stiffness_variation=(0.1,),
            position_modulation=(0.0, 0.0, 0.2),
        ),
        nothing=ToothMesh(
            name="it", module=1e-3, tooth_error=(0.0,), stiffness_variation=(0.0,), position_modulation=(0.1,)
        ),
        orders=(16.2, 16.8, 17.4, 33.6),
    ),
    Row(
        effect=TorsionalMode(name="it", after="wear_part", frequency=60.0, inertia=5e-4, damping_ratio=0.02),
        why_no_zero="a branch without inertia is no branch; nearly none is tried in test_mechanism_laws.py",
        why_no_lines="it raises the lines of others",
    ),
    # load: signatures.md 5
    Row(
        effect=BladePass(name="it", order_output=15, amplitude=0.4),
        nothing=BladePass(name="it", order_output=15, amplitude=0.0),
        orders=(3, 6),
    ),
    Row(
        effect=GranularDrag(name="it", mean_by_occupancy_percent={0.0: 0.5}),
        nothing=GranularDrag(name="it", mean_by_occupancy_percent={0.0: 0.0}),
        why_no_lines="broadband over the angle",
    ),
    Row(
        effect=LugreFriction(name="it", coulomb=0.2, static=0.3, stribeck_speed=5.0, stiffness=100.0, damping=0.05),
        nothing=LugreFriction(name="it", coulomb=0.0, static=0.0, stribeck_speed=1.0, stiffness=100.0, damping=0.05),
        why_no_lines="a mean, while the speed keeps its sign",
    ),
    Row(
        effect=ParticleLoad(name="it", mean_by_occupancy_percent={0.0: 0.05, 21.0: 3.8}),
        nothing=ParticleLoad(name="it", mean_by_occupancy_percent={0.0: 0.0}),
        why_no_lines="broadband by Campbell's theorem",
    ),
    Row(
        effect=QuadraticDrag(name="it", coefficient=1e-3),
        nothing=QuadraticDrag(name="it", coefficient=0.0),
        why_no_lines="a mean",
    ),
    Row(
        effect=TurbulentLoad(name="it", quadratic=1e-3, turbulence=0.1, turbulence_cutoff=5.0),
        nothing=TurbulentLoad(name="it", quadratic=0.0, turbulence=0.1, turbulence_cutoff=5.0),
        why_no_lines="a mean and turbulence of a continuous spectrum",
    ),
    Row(
        effect=StribeckFriction(name="it", coulomb=0.2, static=0.3, stribeck_speed=5.0),
        nothing=StribeckFriction(name="it", coulomb=0.0, static=0.0, stribeck_speed=1.0),
        why_no_lines="a mean, while the speed keeps its sign",
    ),
    # sensor, cable and file: signatures.md 6
    Row(
        effect=BendingCrosstalk(name="it", once=0.02, twice=0.01),
        nothing=BendingCrosstalk(name="it", once=0.0),
        orders=(0.2, 0.4),
    ),
    Row(
        effect=Clipping(name="it", limit=0.85),
        nothing=Clipping(name="it", limit=20.0),
        orders=(10, 15),
        others=(FIFTH,),
    ),
    Row(
        effect=MainsInterference(name="it", amplitudes=(0.05, 0.02)),
        nothing=MainsInterference(name="it", amplitudes=(0.0,)),
        hertz=(50, 100),
    ),
    Row(
        effect=NoiseHump(name="it", rms=0.02, frequency=400.0),
        nothing=NoiseHump(name="it", rms=0.0, frequency=400.0),
        why_no_lines="a band of noise",
    ),
    Row(
        effect=ReadingCourse(name="it", shape="step", at=0.4, zero=0.1, gain=0.1),
        nothing=ReadingCourse(name="it", shape="step", at=0.4),
        why_no_lines="a slow zero and gain",
    ),
    Row(
        effect=GainRipple(name="it", order_motor=4.3, depths=(0.05, 0.02)),
        nothing=GainRipple(name="it", order_motor=4.3, depths=(0.0,)),
        orders=(4.3, 8.6),
    ),
    Row(
        effect=SpeedCourse(name="it", shape="kink", at=50.0, size=0.1),
        nothing=SpeedCourse(name="it", shape="window", at=50.0),
        why_no_lines="a mean torque",
    ),
    Row(
        effect=FlickerNoise(name="it", corner=200.0),
        nothing=FlickerNoise(name="it", corner=0.0),
        why_no_lines="a continuous spectrum",
    ),
    Row(
        effect=LoggerLowPass(name="it", cutoff=100.0, order=6),
        nothing=LoggerLowPass(name="it", cutoff=100.0, order=0),
        why_no_lines="it lowers the lines of others",
    ),
    Row(
        effect=PwmAliasing(name="it", switching_frequency=24e3, amplitude=0.03),
        nothing=PwmAliasing(name="it", switching_frequency=24e3, amplitude=0.0),
        hertz=(1000,),
    ),
    Row(
        effect=Quantization(name="it", step=0.05),
        nothing=Quantization(name="it", step=0.0),
        why_no_lines="a floor, while the signal crosses many codes",
    ),
    Row(
        effect=SensorBandwidth(name="it", cutoff=400.0),
        nothing=SensorBandwidth(name="it", cutoff=3000.0),
        why_no_lines="it lowers the lines of others",
    ),
    Row(
        effect=SensorDrift(name="it", span=-0.2, time_constant=2.0),
        nothing=SensorDrift(name="it", span=0.0),
        why_no_lines="a slow zero",
    ),
    Row(
        effect=SensorHysteresis(name="it", width=0.04, reach=0.02),
        nothing=SensorHysteresis(name="it", width=0.0, reach=0.1),
        orders=(15,),
        others=(FIFTH,),
    ),
    Row(
        effect=SensorNonlinearity(name="it", full_scale=1.0, quadratic=0.5, cubic=0.5),
        nothing=SensorNonlinearity(name="it", full_scale=10.0),
        orders=(10, 15),
        others=(FIFTH,),
    ),
    Row(
        effect=SignalDropout(name="it", duration=0.005, rate=10.0, level=-10.0),
        nothing=SignalDropout(name="it", duration=0.005, rate=0.0),
        why_no_lines="moments at random",
    ),
)
IDS = [row.effect.kind for row in ROWS]


def rig(*effects: Part, speed_rpm: float, noise: float = 0.0, bits: int = 32) -> Rig:
    """Return a driven 5:1 rig with motor phases, teeth, a sensor and 0.8 N m to carry at any speed."""
    sensor = TorqueSensor(
        name="torque_sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5, bandwidth=3000,
        noise_rms=noise, converter_bits=bits,
    )  # fmt: skip
    teeth = (Planetary(21, 84, 3),)
    phases = MotorPhases(
        name="phases", pole_pairs=7, phase_resistance=0.2, phase_inductance=0.3e-3, flux_linkage=0.01, dc_link=48.0,
        current_loop_bandwidth=1000.0,
    )  # fmt: skip
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0, current_loop_bandwidth=1000.0, **WINDING),
            phases,
            Gear(name="gearbox", after="motor", teeth=teeth, stiffness=11300, damping=2.0, output_inertia=7e-4),
            sensor,
            Coupling(name="coupling", after="torque_sensor", stiffness=6500, damping=0.4),
            Body(name="wear_part", after="coupling", inertia=2e-3, viscous=0.001),
            StribeckFriction(name="drag", coulomb=0.8, static=0.8, stribeck_speed=1.0),
            SpeedController(name="controller", kp=0.05, ki=0.5),
            MotorEncoder(name="encoder"),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
    )


def crowded(*effects: Part) -> Rig:
    """Return the rig with a bed, noise, codes and odd lines, among which a wave of no size must not be seen."""
    return rig(
        ParticleLoad(name="bed", mean_by_occupancy_percent={0.0: 0.2}),
        TorqueRipple(name="rotor", at="motor", group="cogging", amplitudes={2.5: 0.01, 7.5: 0.01}),
        TorqueRipple(name="drum", at="wear_part", group="mechanical", amplitudes={0.8: 0.05, 5.6: 0.05}),
        GearMesh(name="mesh", order_output=84.7, transmission_error=(1e-5, 1e-5)),
        *effects,
        speed_rpm=1000.0, noise=0.005, bits=16,
    )  # fmt: skip


def recorded(made: Recording) -> dict[str, bytes]:
    return {name: channel.values.tobytes() for name, channel in made.channels.items()}


@pytest.fixture(scope="module")
def plain() -> dict[str, bytes]:
    return recorded(simulate(crowded(), duration=0.2, seed=5, settling=0.2))


def test_every_mechanism_of_the_library_has_a_row_that_says_all() -> None:
    named = [type(row.effect).__name__ for row in ROWS]
    assert sorted(named) == sorted(mechanisms.__all__), "add the mechanism's Row to ROWS in this file"
    for row in ROWS:
        assert type(row.nothing or row.effect) is type(row.effect)
        assert (row.nothing is None) == bool(row.why_no_zero), row.effect.kind
        assert bool(row.orders or row.hertz) != bool(row.why_no_lines), row.effect.kind


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_it_says_its_equation_its_source_and_where_it_stops_being_true(row: Row) -> None:
    told = " ".join((getdoc(type(row.effect)) or "").split())
    assert re.search(r"``|order", told)
    assert re.search(r"Source: |\([A-Z]\w+.* \d{4}, ", told)
    limits = r"[Nn]ot (true|valid)|[Tt]rue (while|near)|not in here|clamped at|Below the smoothing|is that of"
    assert re.search(limits, told)


@pytest.mark.parametrize(
    "row", [row for row in ROWS if row.nothing], ids=[row.effect.kind for row in ROWS if row.nothing]
)
def test_zero_size_changes_nothing_bit_for_bit(row: Row, plain: dict[str, bytes]) -> None:
    assert row.nothing
    assert recorded(simulate(crowded(row.nothing), duration=0.2, seed=5, settling=0.2)) == plain


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_a_real_size_changes_the_reading_and_only_what_is_on_the_shafts_changes_the_shafts(
    row: Row, plain: dict[str, bytes]
) -> None:
    noisy = simulate(crowded(row.effect), duration=0.2, seed=5, settling=0.2)
    if isinstance(row.effect, PwmRipple | Clipping):  # below a code of this converter; beyond what this load reaches
        noisy = simulate(rig(row.effect, *row.others, speed_rpm=1000.0), duration=0.2, seed=5, settling=0.2)
        quiet = simulate(rig(*row.others, speed_rpm=1000.0), duration=0.2, seed=5, settling=0.2)
        assert recorded(noisy)["torque_V"] != recorded(quiet)["torque_V"]
        return
    changed = {name for name, values in recorded(noisy).items() if values != plain[name]}
    assert "torque_V" in changed
    assert (changed == {"torque_V"}) == (row.effect.group == "sensor")


def amplitudes(made: Recording, turns: tuple[float, ...], hertz: tuple[float, ...]) -> np.ndarray:
    """Amplitudes of the reading's lines at motor orders and at fixed frequencies, fitted together [V]."""
    angle, time = made.channels["true_motor_angle_rad"].values, made.time()
    phases = [order * angle for order in turns] + [2 * pi * f * time for f in hertz]
    columns = [np.ones(time.size), np.linspace(-1, 1, time.size)]
    columns += [wave for phase in phases for wave in (np.cos(phase), np.sin(phase))]
    window = np.hanning(time.size)  # what lies far off does not leak in
    found = np.linalg.lstsq(
        np.column_stack(columns) * window[:, None], made.channels["torque_V"].values * window, rcond=None
    )[0][2:]
    return np.hypot(found[::2], found[1::2])


@cache
def without_effect(speed_rpm: float, *, fifth: bool) -> Recording:
    return simulate(rig(*[FIFTH] * fifth, speed_rpm=speed_rpm), duration=1.0, seed=3, settling=1.0)


@pytest.mark.parametrize("speed_rpm", [600.0, 930.0])
@pytest.mark.parametrize("row", [row for row in ROWS if row.orders or row.hertz],
                         ids=[row.effect.kind for row in ROWS if row.orders or row.hertz])  # fmt: skip
def test_lines_stand_where_the_handbook_says_at_two_speeds(row: Row, speed_rpm: float) -> None:
    """Ten times what stands 0.37 of a turn, or 7 Hz, beside; and nothing much stood there without the effect."""
    with_it = simulate(rig(*row.others, row.effect, speed_rpm=speed_rpm), duration=1.0, seed=3, settling=1.0)
    without = without_effect(speed_rpm, fifth=bool(row.others))
    orders = (*row.orders, *(order + 0.37 for order in row.orders))
    hertz = (*row.hertz, *(frequency + 7.0 for frequency in row.hertz))
    lines, before = (amplitudes(made, orders, hertz) for made in (with_it, without))
    at, beside, before = lines[: lines.size // 2], lines[lines.size // 2 :], before[: lines.size // 2]
    assert (at > 10 * beside).all(), (at, beside)
    assert (at > 10 * before).all(), (at, before)
