"""Torque along the chain from the motor to the sensor, for each piece of the required motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from torquerig.metrics.sizing.output_torque import Floats, OutputTorque
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import DriveTrain, Place, passive_terms, places_from, springs_of
from torquerig.rig.parts import Gear, Motor
from torquerig.rig.reading_place import reading_place
from torquerig.rig.terms import GROUND, Inertia, Load, Spring, Term
from torquerig.scenario.drive_requirement import DriveRequirement


class _Crossed(NamedTuple):
    """A spring on the way: its nodes, turns before per turn behind [1], efficiency along and against the way [1]."""

    name: str
    near: str
    far: str
    turns: float
    along: float
    against: float


def torque_of_stage(requirement: DriveRequirement, rig: Rig, *, motor: Motor, stage: str) -> OutputTorque:
    """Return torque and speed of the output shaft of the gear, belt or worm ``stage`` on the way to the sensor.

    The motor's torque minus the torque for rotor inertia and friction, times ratio and efficiency of each stage on the
    way where power flows forwards, over the efficiency where it flows back; minus the torque for what hangs on the
    shafts between (inertias J1 of the gearboxes, bodies, branches) and for the stage itself; the output inertia of a
    gear counts as load. Loads before the stage are not subtracted: with such a load the torque is too large.
    """
    way, part = _way(rig, motor.name, stage), rig.part(stage)
    inside = replace(part, output_inertia=0.0) if isinstance(part, Gear) else part
    kept = tuple(term for term in inside.terms(rig) if rig.node(stage) in term.nodes)
    return _walked(requirement, rig, motor, way, last=_without_loads(kept, {rig.node(stage): Place(1.0, 1.0, 1.0)}))


def torque_at_sensor(requirement: DriveRequirement, rig: Rig, *, motor: Motor) -> OutputTorque:
    """Return torque and speed of the shaft before the sensor, as :func:`torque_of_stage`, all before it subtracted."""
    way = _way(rig, motor.name, reading_place(rig))
    node = way[-1].near if way else rig.node(motor.name)
    return _walked(requirement, rig, motor, way[:-1], last=_hung(rig, node, motor.name))


def torque_of_motor(requirement: DriveRequirement, rig: Rig, *, motor: Motor) -> OutputTorque:
    """Return torque and speed of the motor's shaft, the torque for its rotor and its friction subtracted."""
    return _walked(requirement, rig, motor, (), last=DriveTrain(terms=(), places={}))


def _walked(
    requirement: DriveRequirement, rig: Rig, motor: Motor, way: Sequence[_Crossed], *, last: DriveTrain
) -> OutputTorque:
    slope = np.diff(requirement.speed, axis=1)[:, 0] / requirement.duration
    direction = np.sign(requirement.speed.sum(axis=1))[:, None]
    lost = direction * motor.coulomb + motor.viscous * requirement.speed
    torque, ratio = requirement.torque - motor.inertia * slope[:, None] - lost, 1.0
    for spring in way:
        hung = _hung(rig, spring.near, motor.name)
        torque = torque - _needed(hung, requirement.speed / ratio, slope / ratio, direction)
        forwards = torque * np.where(direction == 0, np.sign(torque), direction) >= 0
        back = 1 / spring.against if spring.against > 0 else 0.0  # a locked worm takes no power from its wheel
        torque = torque * abs(spring.turns) * np.where(forwards, spring.along, back)
        ratio *= abs(spring.turns)
    return OutputTorque(
        duration=requirement.duration, speed=requirement.speed / ratio, acceleration=slope / ratio,
        torque=torque - _needed(last, requirement.speed / ratio, slope / ratio, direction),
    )  # fmt: skip


def _needed(train: DriveTrain, speed: Floats, slope: Floats, direction: Floats) -> Floats:
    """Return the torque that a part of the train needs of its shaft [N m], shape (pieces, 2)."""
    slopes, ways = np.broadcast_to(slope[:, None], speed.shape), np.broadcast_to(direction, speed.shape)
    if all(isinstance(term, Inertia) for term in train.terms):
        return train.inertia * slopes
    moved = zip(speed.flat, slopes.flat, ways.flat, strict=True)
    found = [train.torque(float(turned), float(rise), way=float(way)) for turned, rise, way in moved]
    return np.array(found).reshape(speed.shape)


def _hung(rig: Rig, node: str, motor: str) -> DriveTrain:
    """Return inertia and friction at a node on the way to the sensor and on its branches, the motor's own left out."""
    crossed = {spring.name for spring in _way(rig, motor, reading_place(rig))}
    branches = [spring for spring in springs_of(passive_terms(rig)) if spring.name not in crossed]
    return _without_loads(passive_terms(rig, without=motor), places_from(node, branches))


def _without_loads(terms: Sequence[Term], places: dict[str, Place]) -> DriveTrain:
    """Return the inertias and friction among the terms that sit at these places."""
    here = [term for term in terms if not isinstance(term, Load | Spring) and not places.keys().isdisjoint(term.nodes)]
    return DriveTrain(terms=tuple(here), places=places)


def _way(rig: Rig, motor: str, last: str) -> list[_Crossed]:
    """Return the springs from the motor to the part ``last``, in order; empty where no shaft leads."""
    springs, start = springs_of(passive_terms(rig)), rig.node(motor)
    came: dict[str, _Crossed | None] = {start: None}
    waiting = [start]
    while waiting:
        here = waiting.pop(0)
        for one in springs:
            forth = _Crossed(one.name, one.a, one.b, one.ratio, one.efficiency, one.backwards)
            back = _Crossed(one.name, one.b, one.a, 1 / one.ratio, one.backwards, one.efficiency)
            for way in (forth, back):
                if way.near == here and way.far not in came and way.far != GROUND:
                    came[way.far] = way
                    waiting.append(way.far)
    found = next((way for way in came.values() if way is not None and way.name == last), None)
    listed: list[_Crossed] = []
    while found is not None:
        listed.append(found)
        found = came[found.near]
    return listed[::-1]
