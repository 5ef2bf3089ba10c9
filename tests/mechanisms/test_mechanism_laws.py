"""Laws of shafts, gears and loads: YAML comes back, momentum is kept; zero size and lines: ..._obeys_its_laws.py."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from numpy.typing import NDArray
from pydantic import TypeAdapter

from torquerig.document import parse_document, validated
from torquerig.mechanisms import (
    Backlash,
    BladePass,
    Cogging,
    CommutationRipple,
    FlickerNoise,
    GearMesh,
    GranularDrag,
    LoggerLowPass,
    LugreFriction,
    ParallelOffset,
    ParticleLoad,
    QuadraticDrag,
    StribeckFriction,
    ToothMesh,
    TorqueRipple,
    TorsionalMode,
    TurbulentLoad,
)
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, KinematicError, waves_of
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.rig.terms import AppliedTorque, Term
from torquerig.scenario.reading import KINDS
from torquerig.simulation.simulator import simulate

# as a scenario writes it, and what is meant
WRITTEN: dict[str, tuple[str, Part]] = {
    "Backlash": ("{kind: backlash, gap: 0.004 rad}", Backlash(name="it", gap=0.004)),
    "BladePass": (
        "{kind: blade_pass, order_output: 6, amplitude: 0.4 N*m, phase: 0.0}",
        BladePass(name="it", order_output=6.0, amplitude=0.4, phase=0.0),
    ),
    "Cogging": (
        "{kind: cogging, slots: 12, pole_pairs: 7, native: 10 mN*m, unequal_teeth: 20 mN*m}",
        Cogging(name="it", slots=12, pole_pairs=7, native=0.01, unequal_teeth=0.02),
    ),
    "CommutationRipple": (
        "{kind: commutation_ripple, order_motor: 42, depth: 0.05}",
        CommutationRipple(name="it", order_motor=42.0, depth=0.05),
    ),
    "GearMesh": (
        "{kind: gear_mesh, order_output: 84, transmission_error: [5.0e-5 rad], planet_modulation: 0.2}",
        GearMesh(name="it", order_output=84.0, transmission_error=(5e-5,), planet_modulation=0.2),
    ),
    "ParallelOffset": (
        "{kind: parallel_offset, offset: 0.1 mm, radius: 10 mm, jaws: 3, unequal_share: 10 %}",
        ParallelOffset(name="it", offset=1e-4, radius=0.01, jaws=3, unequal_share=0.1),
    ),
    "GranularDrag": (
        "{kind: granular_drag, mean_by_occupancy_percent: {0: 0.05 N*m, 21: 3.8 N*m}, correlation_angle: 4 deg}",
        GranularDrag(name="it", mean_by_occupancy_percent={0.0: 0.05, 21.0: 3.8}, correlation_angle=4 * (pi / 180)),
    ),
    "LugreFriction": (
        "{kind: lugre_friction, coulomb: 1Nm, static: 2Nm, stribeck_speed: 1 rpm, stiffness: 9 Nm/rad, damping: 0 Nms}",
        LugreFriction(name="it", coulomb=1.0, static=2.0, stribeck_speed=2 * pi / 60, stiffness=9.0, damping=0.0),
    ),
    "ParticleLoad": (
        "{kind: particle_load, mean_by_occupancy_percent: {0: 0.05 N*m, 21: 3.8 N*m}, hit_decay: 2 ms}",
        ParticleLoad(name="it", mean_by_occupancy_percent={0.0: 0.05, 21.0: 3.8}, hit_decay=0.002),
    ),
    "TurbulentLoad": (
        "{kind: turbulent_load, quadratic: 1.0e-3 N*m*s^2/rad^2, turbulence: 10 %, turbulence_cutoff: 5 Hz}",
        TurbulentLoad(name="it", quadratic=1e-3, turbulence=0.1, turbulence_cutoff=5.0),
    ),
    "FlickerNoise": ("{kind: flicker_noise, corner: 200 Hz}", FlickerNoise(name="it", corner=200.0)),
    "LoggerLowPass": (
        "{kind: logger_low_pass, cutoff: 1 kHz, order: 8, characteristic: bessel}",
        LoggerLowPass(name="it", cutoff=1000.0, order=8, characteristic="bessel"),
    ),
    "QuadraticDrag": (
        "{kind: quadratic_drag, coefficient: 1.0e-3 N*m*s^2/rad^2}",
        QuadraticDrag(name="it", coefficient=1e-3),
    ),
    "StribeckFriction": (
        "{kind: stribeck_friction, coulomb: 0.2 N*m, static: 0.3 N*m, stribeck_speed: 5 rad/s}",
        StribeckFriction(name="it", coulomb=0.2, static=0.3, stribeck_speed=5.0),
    ),
    "ToothMesh": (
        "{kind: tooth_mesh, module: 0.5 mm, tooth_error: [5.0e-6 m, 2.0e-6 m], planet_shares: [40 %, 30 %, 30 %]}",
        ToothMesh(name="it", module=5e-4, tooth_error=(5e-6, 2e-6), planet_shares=(0.4, 0.3, 0.3)),
    ),
    "TorqueRipple": (
        "{kind: torque_ripple, at: motor, group: electrical, amplitudes: {7: 15 mN*m}}",
        TorqueRipple(name="it", at="motor", group="electrical", amplitudes={7.0: 0.015}),
    ),
    "TorsionalMode": (
        "{kind: torsional_mode, after: wear_part, frequency: 60 Hz, inertia: 5 kg*cm^2, damping_ratio: 0.02}",
        TorsionalMode(name="it", after="wear_part", frequency=60.0, inertia=5e-4, damping_ratio=0.02),
    ),
}


def shaft(*effects: Part, speed_rpm: float = 600.0, kp: float = 1e-6) -> Rig:
    """A motor on 5:1 with a sensor and a wear part; the weak loop leaves every line as it is."""
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=11300, damping=2.0, output_inertia=7e-4),
            Coupling(name="sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5),
            Body(name="wear_part", after="sensor", inertia=2e-3),
            SpeedController(name="controller", kp=kp, ki=0.0),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30),
        measured="sensor",
    )


@pytest.mark.parametrize("name", sorted(WRITTEN))
def test_each_kind_reads_back_from_yaml_under_its_own_word(name: str) -> None:
    text, meant = WRITTEN[name]
    document = parse_document(text, Path("scenario.yaml"))
    word = get_args(get_type_hints(type(meant))["kind"])[0]
    assert document.data["kind"] == word == meant.kind
    assert KINDS[word] is type(meant)
    adapter: TypeAdapter[Any] = TypeAdapter(KINDS[word])
    assert validated(document, adapter, data={"name": "it", **document.data}) == meant


@pytest.mark.parametrize("name", sorted(WRITTEN))
def test_each_kind_refuses_a_misspelt_key(name: str) -> None:
    text, meant = WRITTEN[name]
    document = parse_document(text, Path("scenario.yaml"))
    adapter: TypeAdapter[Any] = TypeAdapter(type(meant))
    with pytest.raises(Exception, match="unknown key"):
        validated(document, adapter, data={"name": "it", **document.data, "amplitued": 1})


def test_a_branch_of_hardly_any_inertia_changes_hardly_anything() -> None:
    """The branch takes momentum in proportion to its inertia: 1e-9 of the wear part's leaves 1e-9 of the torque."""
    ripple = TorqueRipple(name="ripple", at="motor", group="mechanical", amplitudes={1: 0.02})
    branch = TorsionalMode(name="it", after="wear_part", frequency=60, inertia=2e-12, damping_ratio=0.02)
    plain = simulate(shaft(ripple), duration=0.1, seed=5).torque()
    assert simulate(shaft(ripple, branch), duration=0.1, seed=5).torque() == pytest.approx(plain, abs=1e-7)


def line(made: Recording, motor_order: float) -> float:
    """Amplitude of the sensor's line at a motor order, by least squares on the true angle [N m]."""
    angle = motor_order * made.channels["true_motor_angle_rad"].values
    columns = np.column_stack([np.ones(angle.size), np.cos(angle), np.sin(angle)])
    found = np.linalg.lstsq(columns, made.channels["true_sensor_torque_Nm"].values, rcond=None)[0]
    return float(np.hypot(found[1], found[2]))


@pytest.mark.parametrize("speed_rpm", [600.0, 900.0])
def test_commutation_ripple_is_a_share_of_the_motor_torque(speed_rpm: float) -> None:
    """Order 7, depth 10 %: the line at the sensor is that of a plain ripple of 10 % of the mean motor torque."""
    drag = QuadraticDrag(name="drag", coefficient=2.0 / (speed_rpm * pi / 150) ** 2)  # 2 N m at the wear part
    ripple = CommutationRipple(name="it", order_motor=7, depth=0.1)
    made = simulate(shaft(drag, ripple, kp=0.01, speed_rpm=speed_rpm), duration=1.0, seed=3)
    torque = made.channels["true_motor_torque_Nm"].values.mean()
    plain = TorqueRipple(name="it", at="motor", group="electrical", amplitudes={7: 0.1 * torque})
    alike = simulate(shaft(drag, plain, kp=0.01, speed_rpm=speed_rpm), duration=1.0, seed=3)
    assert line(made, 7) == pytest.approx(line(alike, 7), rel=0.02)  # the loop's own answer to the line, 2nd order
    assert line(made, 7) > 10 * line(made, 8)


def test_harmonics_of_a_commutation_ripple_are_lines_of_their_own_depth() -> None:
    ripple = CommutationRipple(name="it", order_motor=7, depth=0.1, harmonics=(0.0, 0.02))
    waves = {wave.order: wave.amplitude for wave in waves_of(ripple.changes_in_host(shaft(ripple)), DriveRipple)}
    assert waves == {7: 0.1, 21: 0.02}


def test_planet_modulation_puts_side_lines_at_the_planet_order() -> None:
    """Amplitude modulation m = 0.5 gives m/2 at z - n and z + n; the transfer changes little from 81 to 87."""
    mesh = GearMesh(name="it", order_output=84, transmission_error=(5e-5,), planets=3, planet_modulation=0.5)
    waves = {wave.order: wave.amplitude for wave in waves_of(mesh.changes_in_host(shaft(mesh)), KinematicError)}
    assert waves == pytest.approx({84: 5e-5, 81: 1.25e-5, 87: 1.25e-5})
    made = simulate(shaft(mesh), duration=1.0, seed=3)
    assert line(made, 16.2) > 10 * line(made, 15.5)
    assert line(made, 17.4) > 10 * line(made, 15.5)


@dataclass(frozen=True)
class Constant:
    """One torque for all time."""

    mean: float

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.full(count, self.mean)


@dataclass(frozen=True, kw_only=True)
class Push(Part):
    """2 N m from outside on the motor."""

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on="motor", process=Constant(2.0)),)


@pytest.mark.parametrize(
    "effect",
    [Backlash(name="it", gap=0.002), Push(name="it")],
    ids=["backlash", "none, two pushes"],
)
@pytest.mark.parametrize("ratio", [5.0, -3.572])
def test_what_is_not_against_the_frame_keeps_the_momentum(effect: Part, ratio: float) -> None:
    """Equal and opposite: with the push alone against the frame, ``J1 w1 ratio + J2 w2`` grows by its impulse."""
    gear = Gear(name="gearbox", after="motor", ratio=ratio, stiffness=1100, damping=0.1, output_inertia=0.02)
    rig = Rig(
        (Motor(name="motor", inertia=1.5e-3, torque_limit=1.0), gear, Push(name="push"), effect), measured="gearbox"
    )
    made = simulate(rig, duration=0.3, seed=1, settling=0.0)
    motor, output = (made.channels[f"true_{name}_speed_rad_s"].values for name in ("motor", "output"))
    pushed = 4.0 if isinstance(effect, Push) else 2.0
    assert 1.5e-3 * ratio * motor + 0.02 * output == pytest.approx(pushed * ratio * made.time(), abs=1e-9)
    assert np.ptp(made.torque()) > 0.5  # the shafts did work on each other


def test_the_housing_bears_what_an_error_of_the_gear_takes() -> None:
    """A lever that changes with the angle: the momentum is short by the integral of ``T e'`` (no work of its own)."""
    gear = Gear(name="gearbox", after="motor", ratio=5.0, stiffness=1100, damping=0.1, output_inertia=0.02)
    mesh = GearMesh(name="it", order_output=7, transmission_error=(1e-3,), phases=(0.3,))
    parts = (Motor(name="motor", inertia=1.5e-3, torque_limit=1.0), gear, Push(name="push"), mesh)
    made = simulate(Rig(parts, measured="gearbox"), duration=0.3, seed=1, settling=0.0)
    motor, output = (made.channels[f"true_{name}_speed_rad_s"].values for name in ("motor", "output"))

    def summed(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.concatenate([[0.0], np.cumsum(0.5 * (values[1:] + values[:-1]))]) / made.sample_rate

    lever = -7 * 1e-3 * np.sin(7 * summed(output) + 0.3)
    short = summed(made.channels["true_sensor_torque_Nm"].values * lever)
    assert np.abs(short).max() > 1e-3
    assert 1.5e-3 * 5.0 * motor + 0.02 * output == pytest.approx(10.0 * made.time() - short, abs=1e-6)


def test_a_torsional_branch_takes_from_the_shaft_what_it_gets() -> None:
    branch = TorsionalMode(name="it", after="motor", frequency=60, inertia=5e-4, damping_ratio=0.02)
    rig = Rig((Motor(name="motor", inertia=1.5e-3, torque_limit=1.0), branch, Push(name="push")), measured="it")
    made = simulate(rig, duration=0.3, seed=1, settling=0.0)
    motor, output = (made.channels[f"true_{name}_speed_rad_s"].values for name in ("motor", "output"))
    assert 1.5e-3 * motor + 5e-4 * output == pytest.approx(2.0 * made.time(), abs=1e-9)
    assert np.ptp(made.torque()) > 0.1


@pytest.mark.parametrize("name", ["BladePass", "ParticleLoad", "QuadraticDrag", "StribeckFriction"])
def test_a_load_takes_as_much_momentum_as_its_torque_says(name: str) -> None:
    """Against the frame: the momentum at the end is the push less the integral of the true load, by trapezoids."""
    rig = Rig(
        (
            Motor(name="motor", inertia=1.5e-3, torque_limit=1.0),
            Coupling(name="sensor", after="motor", stiffness=1100, damping=0.1),
            Body(name="wear_part", after="sensor", inertia=0.02),
            Push(name="push"),
            WRITTEN[name][1],
        ),
        measured="sensor",
    )
    made = simulate(rig, duration=0.3, seed=1, settling=0.0)
    motor, output = (made.channels[f"true_{end}_speed_rad_s"].values[-1] for end in ("motor", "output"))
    load = made.channels["true_load_Nm"].values
    taken = (load.sum() - 0.5 * (load[0] + load[-1])) / made.sample_rate
    assert taken > 1e-3
    left = 2.0 * made.time()[-1] - taken
    assert 1.5e-3 * motor + 0.02 * output == pytest.approx(left, rel=1e-4)  # trapezoids over 40 us
