"""The rig's equations as arrays: masses, springs, errors, lines, drive, load; in the output shaft's coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from proof.fleet.design import Design
from proof.fleet.kernel import POINTS
from proof.fleet.laws import DAHL, FleetLaws
from proof.fleet.scale import RPM
from proof.fleet.stages_stated import belt_spring

Floats = NDArray[np.float64]
ANGLE = np.arange(POINTS) * (2.0 * pi / POINTS)
LEAST_FRAME_RATE = 8000.0  # [Hz] at which the torque's course is kept


class Train(NamedTuple):
    """Arrays and numbers of `kernel.run_train`; the springs lie between neighbouring masses, the body is last."""

    inertia: Floats
    stiffness: Floats
    damping: Floats
    viscous: Floats
    half_gap: Floats
    loss: Floats
    errors: Floats
    slopes: Floats
    error_periods: Floats
    has_error: NDArray[np.bool_]
    ratio: float
    branch_inertia: float
    branch_stiffness: float
    branch_damping: float
    sensor_spring: int
    soft_spring: int
    induction: bool
    kp: float
    ki: float
    torque_limit: float
    control_frames: int
    control_delay: int
    breakdown_slip: float
    breakdown_torque: float
    lag: float
    drive_table: Floats
    motor_table: Floats
    load_table: Floats
    blade_table: Floats
    motor_coulomb: float
    motor_width: float
    loss_width: float
    contact_damped: float
    contact_exponent: float
    contact_torque: float
    per_radian: float
    drag: float
    swirl_follows: float
    swirl_torque: float
    friction: int
    friction_width: float
    bristle_angle: float
    dry: Floats
    peak: Floats
    stribeck_speed: float


def frames_per_sample(sample_rate: float) -> int:
    """Return how many frames of the equations' course lie in one recorded sample."""
    return int(np.ceil(LEAST_FRAME_RATE / sample_rate))


def train_of(design: Design, truth: Mapping[str, Any], laws: FleetLaws, phases: np.random.Generator) -> Train:
    """Return the train of a rig with its true values; ``phases`` draws the phases of all stated lines."""
    motor, sensor = truth[design.motor], truth[design.sensor]
    body, coupling = truth[design.body], truth[design.coupling]
    turns = np.array(design.turns)
    masses = len(turns)
    inertia, viscous = np.zeros(masses), np.zeros(masses)
    stiffness, damping, loss = np.zeros(masses - 1), np.zeros(masses - 1), np.zeros(masses - 1)
    inertia[0], viscous[0] = motor["inertia"], motor["viscous"]
    for i, stage in enumerate(design.stages):
        part = truth[stage.name]
        stiffness[i], damping[i] = (
            belt_spring(part) if stage.part["kind"] == "belt" else (part["stiffness"], part["damping"])
        )
        inertia[i + 1] = part.get("output_inertia", part.get("wheel_inertia", 0.0))
        loss[i] = 1.0 / min(part.get("efficiency", part.get("forward_efficiency", 1.0)), 0.995) - 1.0
    if design.second:
        part = truth[design.second]
        stiffness[0], damping[0], inertia[1] = part["stiffness"], part["damping"], part["inertia"]
    inertia[-2], stiffness[-2], damping[-2] = sensor["inertia"], sensor["stiffness"], sensor["damping"]
    inertia[-1], stiffness[-1], damping[-1] = body["inertia"], coupling["stiffness"], coupling["damping"]
    viscous[-1] = body["viscous"]
    output_side = turns[1:] ** 2
    tables = _mesh_tables(design, truth, phases)
    rated = design.scale.output_speed
    flow = truth.get("flow", {})
    width = laws.friction_width * rated
    return Train(
        inertia=inertia * turns**2, stiffness=stiffness * output_side, damping=damping * output_side,
        viscous=viscous * turns**2, half_gap=np.zeros(masses - 1), loss=loss, errors=tables[0], slopes=tables[1],
        error_periods=tables[2], has_error=tables[3], ratio=design.ratio, branch_inertia=0.0, branch_stiffness=0.0,
        branch_damping=0.0, sensor_spring=masses - 3, soft_spring=masses - 2,
        **_drive(design, truth, laws),
        drive_table=np.zeros(POINTS), motor_table=_lines(truth["motor_lines"]["amplitudes"], phases),
        load_table=_lines(truth["load_lines"]["amplitudes"], phases), blade_table=_baffles(truth, phases),
        motor_coulomb=motor["coulomb"], motor_width=5e-4 * design.scale.motor_speed, loss_width=3e-3 * rated,
        contact_damped=float(laws.contact_damped), contact_exponent=laws.contact_exponent,
        contact_torque=design.scale.torque, per_radian=0.5 / pi, drag=flow.get("quadratic", 0.0),
        swirl_follows=float(laws.turbulence_follows_speed), swirl_torque=0.0, friction=laws.friction,
        friction_width=width, bristle_angle=width / (2.0 * pi * 30.0) if laws.friction == DAHL else 1.0,
        dry=np.full(2, body.get("coulomb", 0.0)), peak=np.zeros(2), stribeck_speed=1.0,
    )  # fmt: skip


def _drive(design: Design, truth: Mapping[str, Any], laws: FleetLaws) -> dict[str, Any]:
    """Return the controller and current loop, or the slip characteristic of an induction motor."""
    frame_rate = design.sample_rate * frames_per_sample(design.sample_rate)
    common = {"control_frames": max(1, round(frame_rate / laws.control_rate)), "control_delay": laws.control_delay}
    if design.motor_kind != "induction":
        controller = truth["controller"]
        limit = float(truth[design.motor]["torque_limit"].split()[0])
        lag = 2.0 * pi * float(truth[design.motor]["current_loop_bandwidth"].split()[0])
        return common | {"induction": False, "kp": controller["kp"], "ki": controller["ki"], "torque_limit": limit,
                         "breakdown_slip": 1.0, "breakdown_torque": 0.0, "lag": lag}  # fmt: skip
    supply = truth["supply"]
    field = 2.0 * pi * 50.0 / supply["pole_pairs"]
    slip = field - float(supply["rated_speed"].split()[0]) * RPM
    over = supply["breakdown_torque"] / float(supply["rated_torque"].split()[0])
    breakdown = slip * (over + np.sqrt(over**2 - 1.0))  # Kloss through the rated point
    lag = breakdown / field * 2.0 * pi * 50.0
    return common | {"induction": True, "kp": 0.0, "ki": 0.0, "torque_limit": 1e12, "breakdown_slip": breakdown,
                     "breakdown_torque": supply["breakdown_torque"], "lag": lag}  # fmt: skip


def _lines(amplitudes: Mapping[int, float], phases: np.random.Generator) -> Floats:
    table = np.zeros(POINTS)
    for order, amplitude in amplitudes.items():
        table += amplitude * np.cos(order * ANGLE + phases.uniform(0.0, 2.0 * pi))
    return table


def _baffles(truth: Mapping[str, Any], phases: np.random.Generator) -> Floats:
    if "baffles" not in truth:
        return np.zeros(POINTS)
    part = truth["baffles"]
    return blades(part["order_output"], part["amplitude"], float(phases.uniform(0.0, 2.0 * pi)))


def blades(order: int, amplitude: float, phase: float) -> Floats:
    """Return the resistance of blades over one turn: A max(0, cos)^2 per blade."""
    return np.asarray(amplitude * np.maximum(0.0, np.cos(order * ANGLE + phase)) ** 2)


def _mesh_tables(
    design: Design, truth: Mapping[str, Any], phases: np.random.Generator
) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
    springs = len(design.turns) - 1
    errors, slopes = np.zeros((springs, POINTS)), np.zeros((springs, POINTS))
    periods = np.array([turn / (2.0 * pi) for turn in np.abs(design.turns[1:])])
    has_error = np.zeros(springs, dtype=np.bool_)
    for i, stage in enumerate(design.stages):
        mesh = truth.get(f"{stage.name}_mesh")
        if mesh is None:
            continue
        for harmonic, size in enumerate(mesh["transmission_error"], start=1):
            add_error(errors[i], slopes[i], order=harmonic * mesh["order_output"], size=size,
                      phase=float(phases.uniform(0.0, 2.0 * pi)), turns=abs(design.turns[i + 1]))  # fmt: skip
        has_error[i] = True
    return errors, slopes, periods, has_error


def add_error(error: Floats, slope: Floats, *, order: float, size: float, phase: float, turns: float) -> None:
    """Add an angle error of an order of its shaft [rad of that shaft] to a table over that shaft's turn, in place."""
    error += size / turns * np.cos(order * ANGLE + phase)
    slope += -size * order * np.sin(order * ANGLE + phase)
