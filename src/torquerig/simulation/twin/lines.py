"""Order lines of a rig: causes, motor orders, and the inputs of the linear model at which they act."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.rig.assembly import Rig
from torquerig.rig.host_changes import DriveRipple, KinematicError, StiffnessVariation, waves_of
from torquerig.rig.terms import GROUND, BladeTorque, HarmonicTorque
from torquerig.simulation.lower import Lowered
from torquerig.simulation.twin.operating_point import OperatingPoint


@dataclass(frozen=True)
class OrderLine:
    """One line that follows the motor.

    Parameters
    ----------
    cause : str
        The effect's name in the rig, or the family of a kinematic line.
    order : float
        Periods per turn of the motor [1/rev].
    enters : str
        Input of the twin; ``error of GEAR`` [rad], all others torques [N m].
    amplitude : float or None
        Zero to peak, in the unit of the input; None where only the kinematics are known.
    against : str
        The node that the opposite torque acts on: the frame, or a motor's housing that a sensor holds.
    """

    cause: str
    order: float
    enters: str
    amplitude: float | None
    against: str = GROUND

    def frequency(self, motor_speed: float) -> float:
        """Return the frequency of the line [Hz] at a motor speed [rad/s]."""
        return self.order * abs(motor_speed) / (2 * pi)


def order_lines(
    rig: Rig, lowered: Lowered, point: OperatingPoint, *, kinematic: Iterable[KinematicLine] = ()
) -> tuple[OrderLine, ...]:
    """Return the lines of the rig's effects, and those of ``kinematic`` whose order no effect has.

    A kinematic line is taken to enter at its motor, its amplitude unknown. Blade pulses count by their first harmonic.
    """
    motor = lowered.leader()
    turns = {node: abs(ratio) for node, ratio in rig.speed_ratios(motor).items()}
    errors, varying = _errors(rig, lowered, turns), _varying(rig, lowered, point, turns)
    found = [*_torques(rig, turns), *errors, *varying, *_ripple(rig, lowered, point), *_sensed(lowered, point)]
    known = {round(line.order, 9) for line in found}
    for line in kinematic:
        if round(line.motor_order, 9) not in known:
            name = line.label
            name += f" x{line.harmonic}" if line.harmonic > 1 else ""
            found.append(
                OrderLine(name, line.motor_order, f"torque on {rig.node(line.at) if line.at else motor}", None)
            )
    return tuple(sorted(found, key=lambda line: line.order))


def _torques(rig: Rig, turns: dict[str, float]) -> list[OrderLine]:
    found = []
    for term in rig.terms():
        if isinstance(term, HarmonicTorque) and term.angle in turns:
            found += [OrderLine(term.name, wave.order * turns[term.angle], f"torque on {term.on}", wave.amplitude,
                                against=term.against)
                      for wave in term.waves if wave.amplitude]  # fmt: skip
        elif isinstance(term, BladeTorque) and term.amplitude and term.on in turns:
            first = 4 / (3 * pi) * term.amplitude  # of max(0, cos)^2
            found.append(OrderLine(term.name, term.order * turns[term.on], f"torque on {term.on}", first))
    return found


def _errors(rig: Rig, lowered: Lowered, turns: dict[str, float]) -> list[OrderLine]:
    return [
        OrderLine(part.name, wave.order * turns[rig.node(spring)], f"error of {spring}", wave.amplitude)
        for part in rig.parts
        for spring in lowered.spring_names
        if part.host == spring
        for wave in waves_of(rig.changes_of(part), KinematicError)
        if wave.amplitude and rig.node(spring) in turns
    ]


def _varying(rig: Rig, lowered: Lowered, point: OperatingPoint, turns: dict[str, float]) -> list[OrderLine]:
    """Return the varying of stiffness as the error that makes, to first order, the same torque at the point."""
    twists = dict(
        zip(lowered.spring_names, np.abs(point.spring_torques) / lowered.arrays.springs.stiffness, strict=True)
    )
    return [
        OrderLine(part.name, wave.order * turns[rig.node(spring)], f"error of {spring}", wave.amplitude * float(twist))
        for part in rig.parts
        for spring, twist in twists.items()
        if part.host == spring
        for wave in waves_of(rig.changes_of(part), StiffnessVariation)
        if wave.amplitude and rig.node(spring) in turns
    ]


def _ripple(rig: Rig, lowered: Lowered, point: OperatingPoint) -> list[OrderLine]:
    """Return the lines in proportion to the motor's torque, at that of the operating point."""
    motor, torque = lowered.leader(), abs(point.drive_torque)
    against = lowered.drive_terms[0].against if lowered.drive_terms else GROUND
    return [
        OrderLine(part.name, wave.order, f"torque on {motor}", wave.amplitude * torque, against=against)
        for part in rig.parts
        if part.host == motor
        for wave in waves_of(rig.changes_of(part), DriveRipple)
        if wave.amplitude
    ]


def _sensed(lowered: Lowered, point: OperatingPoint) -> list[OrderLine]:
    """Return what each speed loop, at the point's speed, answers to an angle error of its encoder."""
    found = []
    for drive in lowered.drive_terms:
        for wave in drive.sensing.error:
            s = 1j * wave.order * abs(float(point.speeds[lowered.node(drive.on)]))
            if not s or not wave.amplitude:
                continue
            answer = (drive.kp * s + drive.ki) * wave.amplitude / (1 + drive.sensing.filter_time * s)
            found.append(OrderLine(f"encoder of {drive.name}", wave.order, f"demand of {drive.name}", abs(answer)))
    return found
