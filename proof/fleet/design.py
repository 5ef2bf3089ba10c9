"""Whole rigs as people describe them: kind of drive, transmission, load, sensor, and all stated numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import pi
from typing import Any

import numpy as np

from proof.fleet.loads_stated import state_load
from proof.fleet.motors_stated import state_motor
from proof.fleet.scale import Scale, draw_scale
from proof.fleet.stages_stated import Stage, state_stages
from proof.fleet.stated import Parts, Stated

MOTORS = ("servo", "bldc", "induction")
DRIVES = ("direct", "belt", "one_stage", "two_stage", "three_stage", "worm")
LOADS = ("particles", "fan", "brake", "mixer", "conveyor", "free")
SAMPLE_RATES = (1000.0, 2000.0, 2500.0, 4000.0, 5000.0, 8000.0, 10000.0, 20000.0, 25600.0, 51200.0)
BODY_NAMES = {
    "particles": ("wear_part", "blade", "rotor"), "fan": ("fan", "wheel", "impeller"), "brake": ("brake", "disc"),
    "mixer": ("impeller", "stirrer"), "conveyor": ("drum", "pulley"), "free": ("flywheel", "drum", "inertia"),
}  # fmt: skip


@dataclass(frozen=True)
class Design:
    """One rig as its owner knows it.

    Parameters
    ----------
    motor_kind, drive, load_kind : str
        Out of `MOTORS`, `DRIVES` and `LOADS`.
    parts : dict
        What stands under ``rig:`` of the scenario, with `Stated` numbers in SI units.
    scale : Scale
        Rated torque, speeds and inertias.
    stages : tuple of Stage
        Gear stages or belt from the motor on.
    motor, sensor, body, coupling, second : str
        Names of the parts; ``second`` is a coupling between motor and sensor, or empty.
    sample_rate : float
        [Hz].
    angle : str
        ``encoder``, ``tacho`` or ``none``.
    angle_counts : int
        Counts or pulses per turn of the shaft that has it.
    """

    motor_kind: str
    drive: str
    load_kind: str
    parts: Parts
    scale: Scale
    stages: tuple[Stage, ...]
    motor: str
    sensor: str
    body: str
    coupling: str
    second: str
    sample_rate: float
    angle: str
    angle_counts: int
    notes: dict[str, Any] = field(default_factory=dict)

    @property
    def ratio(self) -> float:
        """Motor turns per output turn, negative where the stages reverse."""
        return float(np.prod([stage.ratio for stage in self.stages])) if self.stages else 1.0

    @property
    def turns(self) -> tuple[float, ...]:
        """Turns of the shaft of every mass per output turn: motor, stage outputs (or second coupling), sensor, body."""
        turns = [self.ratio]
        for stage in self.stages:
            turns.append(turns[-1] / stage.ratio)
        return (*turns, *([1.0] if self.second else []), 1.0, 1.0)

    def shafts(self) -> dict[str, float]:
        """Return turns per output turn of every shaft by the names that a diagnosis may use."""
        named = {"output_shaft": 1.0, "motor_shaft": abs(self.ratio), self.motor: abs(self.ratio)}
        named |= {stage.name: abs(turn) for stage, turn in zip(self.stages, self.turns[1:], strict=False)}
        return named | {self.sensor: 1.0, self.body: 1.0, self.coupling: 1.0}


def draw_design(
    rng: np.random.Generator, *, motors: Sequence[str] = MOTORS, drives: Sequence[str] = DRIVES,
    loads: Sequence[str] = LOADS,
) -> Design:  # fmt: skip
    """Draw a rig; the kinds can be restricted."""
    motor_kind, drive, load_kind = str(rng.choice(motors)), str(rng.choice(drives)), str(rng.choice(loads))
    scale = draw_scale(rng, motor_kind=motor_kind, drive=drive, load_kind=load_kind)
    motor = str(rng.choice(["motor", "drive_motor", "machine"]))
    sensor = str(rng.choice(["torque_sensor", "sensor", "flange", "cell"]))
    body = str(rng.choice(BODY_NAMES[load_kind]))
    stages = state_stages(rng, drive, scale)
    ratio = float(np.prod([stage.ratio for stage in stages])) if stages else 1.0
    second = "input_coupling" if not stages and rng.random() < 0.5 else ""
    coupling = str(rng.choice(["coupling", "bellows", "shaft"]))
    sample_rate = float(rng.choice(SAMPLE_RATES))
    parts: Parts = {}
    parts |= state_motor(rng, motor_kind, motor, scale, ratio=ratio)
    for stage in stages:
        parts[stage.name] = stage.part
    if second:
        parts[second] = _coupling(rng, scale, scale.stiffness * float(rng.uniform(2.0, 6.0)), scale.inertia * 0.05)
        parts[second]["inertia"] = Stated(scale.inertia * 0.05, "kg*m^2", 0.1)
    parts[sensor] = _sensor(rng, scale, sample_rate)
    parts[coupling] = _coupling(rng, scale, scale.stiffness, scale.inertia)
    parts[body] = {"kind": "body", "inertia": Stated(scale.inertia, "kg*m^2", float(rng.choice([0.05, 0.1, 0.15])))}
    parts |= state_load(rng, load_kind, body, parts[body], scale)
    parts |= _meshes(rng, stages, scale)
    angle = str(rng.choice(["encoder", "tacho", "none"], p=[0.45, 0.25, 0.3]))
    counts = int(rng.choice([1024, 2048, 4096, 8192])) if angle == "encoder" else int(rng.choice([24, 60, 120]))
    if angle == "encoder":
        parts["encoder"] = {"kind": "motor_encoder", "counts_per_rev": counts}
    elif angle == "tacho":
        counts = _possible_teeth(counts, scale.motor_speed, sample_rate)
        parts["tacho"] = {"kind": "tacho", "at": motor, "teeth": counts}
    return Design(
        motor_kind=motor_kind, drive=drive, load_kind=load_kind, parts=parts, scale=scale, stages=tuple(stages),
        motor=motor, sensor=sensor, body=body, coupling=coupling, second=second, sample_rate=sample_rate, angle=angle,
        angle_counts=counts,
    )  # fmt: skip


def _possible_teeth(teeth: int, motor_speed: float, sample_rate: float) -> int:
    """Return teeth of a tacho wheel whose pulses have at least eight samples."""
    most = sample_rate / 8.0 / (1.3 * motor_speed / (2.0 * pi))
    return max(1, min(teeth, int(most)))


def _sensor(rng: np.random.Generator, scale: Scale, sample_rate: float) -> dict[str, Any]:
    full = _round_up(scale.torque * float(rng.uniform(2.2, 4.0)))
    volts = float(rng.choice([5.0, 10.0]))
    stiffness, inertia = scale.stiffness * float(rng.uniform(3.0, 10.0)), scale.inertia * float(rng.uniform(0.03, 0.12))
    bandwidth = min(sample_rate * float(rng.choice([0.2, 0.25, 0.3])), float(rng.choice([1000.0, 2000.0, 4000.0])))
    return {
        "kind": "torque_sensor",
        "stiffness": Stated(stiffness, "N*m/rad", 0.05),
        "damping": Stated(2.0 * scale.damping * (stiffness * inertia) ** 0.5, "N*m*s/rad", 0.3),
        "inertia": Stated(inertia, "kg*m^2", 0.1),
        "sensitivity": f"{volts / full:.6g} V/(N*m)",
        "bandwidth": f"{bandwidth:g} Hz",
        "noise_rms": Stated(volts * float(10.0 ** rng.uniform(-4.0, -3.3)), "V", 0.3),
        "converter_range": f"{volts:g} V",
        "converter_bits": 16,
        "gain_tolerance": float(rng.choice([0.001, 0.002, 0.005])),
        "zero_tolerance": f"{0.005 * full:.6g} N*m",
    }


def _coupling(rng: np.random.Generator, scale: Scale, stiffness: float, inertia: float) -> dict[str, Any]:
    damping = 2.0 * float(rng.uniform(0.7, 1.5)) * scale.damping * (stiffness * inertia) ** 0.5
    return {
        "kind": "coupling",
        "stiffness": Stated(stiffness, "N*m/rad", float(rng.choice([0.1, 0.15, 0.2]))),
        "damping": Stated(damping, "N*m*s/rad", 0.3),
    }


def _meshes(rng: np.random.Generator, stages: Sequence[Stage], scale: Scale) -> Parts:
    """State the mesh lines of about half of the toothed stages."""
    parts: Parts = {}
    for stage in stages:
        if stage.mesh_order and rng.random() < 0.5:
            size = scale.torque * float(10.0 ** rng.uniform(-2.3, -1.5)) / scale.stiffness * stage.output_turns
            errors = [Stated(size, "rad", 0.25), Stated(size * float(rng.uniform(0.2, 0.5)), "rad", 0.25)]
            parts[f"{stage.name}_mesh"] = {
                "kind": "gear_mesh", "gear": stage.name, "order_output": stage.mesh_order,
                "transmission_error": errors,
            }  # fmt: skip
    return parts


def _round_up(value: float) -> float:
    """Return the next of 1, 2, 5, 10 ... above a value, as sensors are sold."""
    decade = 10.0 ** np.floor(np.log10(value))
    return float(next(step * decade for step in (1.0, 2.0, 5.0, 10.0) if step * decade >= value * 0.999))
