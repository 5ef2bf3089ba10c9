"""Laws of the sensor's, cable's and line effects: YAML comes back, seeds, refusals."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import pytest
from pydantic import TypeAdapter

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document, validated
from torquerig.errors import InputError
from torquerig.mechanisms import (
    BearingDefect,
    BeltLines,
    BendingCrosstalk,
    Clipping,
    CurrentGain,
    CurrentOffset,
    Eccentricity,
    GainRipple,
    GearMesh,
    Imbalance,
    JawCoupling,
    MainsInterference,
    Misalignment,
    NoiseHump,
    PwmAliasing,
    Quantization,
    ReadingCourse,
    SensorBandwidth,
    SensorDrift,
    SensorHysteresis,
    SensorNonlinearity,
    SignalDropout,
    SpeedCourse,
    TorqueRipple,
)
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, MotorEncoder, SpeedController, TorqueSensor
from torquerig.scenario.reading import KINDS, read_scenario
from torquerig.simulation.simulator import simulate

# as a scenario writes it, and what is meant
EFFECTS: list[tuple[str, Part]] = [
    (
        "{kind: mains_interference, amplitudes: [50 mV, 0 V, 0.01 V]}",
        MainsInterference(name="it", frequency=50.0, amplitudes=(0.05, 0.0, 0.01)),
    ),
    (
        "{kind: noise_hump, rms: 20 mV, frequency: 0.4 kHz, width: 0.1}",
        NoiseHump(name="it", rms=0.02, frequency=400.0, width=0.1),
    ),
    (
        "{kind: reading_course, shape: ramp, at: 0.4, zero: 20 mV, gain: -5 %}",
        ReadingCourse(name="it", shape="ramp", at=0.4, zero=0.02, gain=-0.05),
    ),
    (
        "{kind: gain_ripple, frequency: 7 Hz, depths: [2 %, 0.01]}",
        GainRipple(name="it", frequency=7.0, depths=(0.02, 0.01)),
    ),
    (
        "{kind: speed_course, shape: window, at: 40 rad/s, size: -20 mN*m}",
        SpeedCourse(name="it", shape="window", at=40.0, size=-0.02),
    ),
    (
        "{kind: pwm_aliasing, switching_frequency: 24 kHz, amplitude: 30 mV}",
        PwmAliasing(name="it", switching_frequency=24_000.0, amplitude=0.03),
    ),
    (
        "{kind: sensor_bandwidth, cutoff: 0.4 kHz}",
        SensorBandwidth(name="it", cutoff=400.0),
    ),
    (
        "{kind: sensor_drift, span: -0.2 V, time_constant: 2 s}",
        SensorDrift(name="it", span=-0.2, time_constant=2.0),
    ),
    ("{kind: clipping, limit: 1.1 V}", Clipping(name="it", limit=1.1)),
    ("{kind: quantization, step: 50 mV}", Quantization(name="it", step=0.05)),
    (
        "{kind: signal_dropout, duration: 5 ms, rate: 600 per minute, level: -10 V}",
        SignalDropout(name="it", duration=0.005, rate=10.0, level=-10.0),
    ),
    (
        "{kind: bearing_defect, order_output: 3.572, ring_frequency: 2 kHz, amplitude: 0.2 N*m, slip: 1 %}",
        BearingDefect(name="it", order_output=3.572, ring_frequency=2000.0, amplitude=0.2, slip=0.01),
    ),
    (
        "{kind: bending_crosstalk, once: 20 mN*m, once_by_speed_squared: 1.0e-5 N*m*s^2/rad^2}",
        BendingCrosstalk(name="it", once=0.02, once_by_speed_squared=1e-5),
    ),
    (
        "{kind: sensor_nonlinearity, full_scale: 10 N*m, gain_error: 0.5 %, cubic: 0.2 %}",
        SensorNonlinearity(name="it", full_scale=10.0, gain_error=0.005, cubic=0.002),
    ),
    (
        "{kind: sensor_hysteresis, width: 20 mN*m, reach: 0.1 N*m}",
        SensorHysteresis(name="it", width=0.02, reach=0.1),
    ),
    (
        "{kind: current_offset, pole_pairs: 7, torque_constant: 0.11 N*m/A, offset_a: 20 mA, offset_b: -10 mA}",
        CurrentOffset(name="it", pole_pairs=7, torque_constant=0.11, offset_a=0.02, offset_b=-0.01),
    ),
    (
        "{kind: current_gain, pole_pairs: 7, mismatch: 2 %}",
        CurrentGain(name="it", pole_pairs=7, mismatch=0.02),
    ),
    (
        "{kind: eccentricity, slots: 12, pole_pairs: 7, tooth_torque: 0.1 N*m, static: 20 %, dynamic: 0.1}",
        Eccentricity(name="it", slots=12, pole_pairs=7, tooth_torque=0.1, static=0.2, dynamic=0.1),
    ),
    (
        "{kind: imbalance, mass: 500 g, eccentricity: 0.1 mm}",
        Imbalance(name="it", mass=0.5, eccentricity=1e-4),
    ),
    (
        f"{{kind: misalignment, angle: {pi / 90!r} rad}}",
        Misalignment(name="it", angle=pi / 90),
    ),
    (
        "{kind: jaw_coupling, jaws: 3, jaw_error: 1 mrad, leg_error: 0.5 mrad}",
        JawCoupling(name="it", jaws=3, jaw_error=1e-3, leg_error=5e-4),
    ),
    (
        "{kind: belt_lines, pinion: 20, wheel: 100, belt_teeth: 120, belt_error: [1 mrad], tooth_error: 2.0e-5 rad}",
        BeltLines(name="it", pinion=20, wheel=100, belt_teeth=120, belt_error=(1e-3,), tooth_error=2e-5),
    ),
]
KIND_OF_ROW = [meant.kind for _, meant in EFFECTS]


def sensed(*effects: Part) -> Rig:
    """A driven 5:1 rig with a real sensor, 1 N m of load, all of the measuring chain, and odd lines on each shaft.

    The lines make the kernel's cosines differ to the last bits once a wave of a new order joins them.
    """
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=11300, damping=2.0, output_inertia=7e-4),
            TorqueSensor(
                name="torque_sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5, bandwidth=3000,
                noise_rms=0.005,
            ),
            Coupling(name="coupling", after="torque_sensor", stiffness=6500, damping=0.4),
            Body(name="wear_part", after="coupling", inertia=2e-3, viscous=0.05),
            SpeedController(name="controller", kp=0.05, ki=0.5),
            MotorEncoder(name="encoder"),
            TorqueRipple(name="rotor", at="motor", group="cogging", amplitudes={2.5: 0.01, 7.5: 0.01}),
            TorqueRipple(name="drum", at="wear_part", group="mechanical", amplitudes={0.8: 0.05, 5.6: 0.05}),
            GearMesh(name="mesh", order_output=84.7, transmission_error=(1e-5, 1e-5)),
            *effects,
        ),
        Run(speed=1000 * pi / 30),
    )  # fmt: skip


@pytest.mark.parametrize("effect", [meant for _, meant in EFFECTS], ids=KIND_OF_ROW)
def test_the_same_seed_gives_the_same_bytes(effect: Part) -> None:
    first, second = (simulate(sensed(effect), duration=0.05, seed=9, settling=0.1).torque() for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_a_scenario_with_all_of_them_reads_back() -> None:
    lines = ["rig:", *(f"  {name}: {text}" for name, text in SHAFT.items())]
    lines += [f"  it_{row}: {written}" for row, (written, _) in enumerate(EFFECTS)]
    scenario = read_scenario(parse_document("\n".join(lines), Path("all.yaml")), Catalog(), seed=1)
    for row, (_, meant) in enumerate(EFFECTS):
        assert replace(scenario.rig.part(f"it_{row}"), name="it") == meant
        assert type(meant) is KINDS[meant.kind]


SHAFT = {
    "motor": "{kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 10 N*m}",
    "gearbox": "{kind: gear, ratio: 5, stiffness: 11300 N*m/rad, damping: 2 N*m*s/rad, output_inertia: 7 kg*cm^2}",
    "torque_sensor": "{kind: torque_sensor, stiffness: 1100 N*m/rad, damping: 0.12 N*m*s/rad, inertia: 0.4 kg*cm^2, "
    "bandwidth: 3 kHz}",
    "coupling": "{kind: coupling, stiffness: 6500 N*m/rad, damping: 0.4 N*m*s/rad}",
    "wear_part": "{kind: body, inertia: 20 kg*cm^2}",
    "speed_controller": "{kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}",
}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("{kind: pwm_aliasing, amplitude: 0.1 V}", "state one of frequency"),
        ("{kind: pwm_aliasing, frequency: 1 kHz, switching_frequency: 24 kHz, amplitude: 0.1 V}", "state one of"),
        ("{kind: sensor_hysteresis, width: 1 N*m, reach: 0.1 N*m}", "cannot be wider"),
        ("{kind: belt_lines, pinion: 20, wheel: 100, belt_teeth: 60}", "does not go round"),
        (
            "{kind: current_offset, pole_pairs: 0, torque_constant: 1 N*m/A, offset_a: 1 A}",
            "pole pairs are not possible",
        ),
        ("{kind: current_gain, pole_pairs: 0, mismatch: 1 %}", "pole pairs are not possible"),
        ("{kind: eccentricity, slots: 0, pole_pairs: 7, tooth_torque: 1 N*m}", "are not possible"),
        ("{kind: eccentricity, slots: 12, pole_pairs: 7, tooth_torque: 1 N*m, static: 0.9}", "at most"),
        ("{kind: jaw_coupling, jaws: 0}", "is not possible"),
        ("{kind: clipping, limit: 0 V}", "more than 0"),
    ],
)
def test_values_that_cannot_be_are_refused_with_their_place(text: str, told: str) -> None:
    document = parse_document(text, Path("scenario.yaml"))
    with pytest.raises(InputError, match=rf"scenario\.yaml.*{told}"):
        validated(document, TypeAdapter(KINDS[document.data["kind"]]), data={"name": "it", **document.data})


@pytest.mark.parametrize(
    "effect",
    [
        SensorBandwidth(name="it", sensor="coupling", cutoff=400.0),
        Misalignment(name="it", coupling="gearbox", angle=0.01),
        JawCoupling(name="it", coupling="motor", jaws=3),
        BeltLines(name="it", gear="coupling", pinion=20, wheel=100, belt_teeth=120),
        CurrentGain(name="it", at="wear_part", pole_pairs=7, mismatch=0.01),
    ],
    ids=lambda effect: effect.kind,
)
def test_an_effect_in_a_part_where_it_cannot_live_is_refused(effect: Part) -> None:
    with pytest.raises(InputError, match=r"it: .*; name one"):
        sensed(effect).terms()
