"""Torque along the chain from the motor to the sensor, for each piece of the required motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.metrics.sizing.output_torque import Floats, OutputTorque
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import DriveTrain, Place, drive_train, passive_terms, places_from, springs_of
from torquerig.rig.parts import Gear, Motor, ReactionTorqueSensor
from torquerig.rig.reading_place import reading_place
from torquerig.rig.terms import GROUND, Inertia, ShaftMotion, Spring, Term
from torquerig.scenario.drive_requirement import DriveRequirement

NOTHING = DriveTrain(terms=(), places={})


class _Crossed(NamedTuple):
    """A spring on the way: its nodes, turns before per turn behind [1], efficiency along and against the way [1]."""

    name: str
    near: str
    far: str
    turns: float
    along: float
    against: float


class _Loads(NamedTuple):
    """Loads at both ends of each piece, shape (pieces, 2).

    Parameters
    ----------
    share : ndarray
        What the rig's own loads are multiplied by [1].
    stated : ndarray
        What the profile states at ``node`` [N m], where the rig has no load, or the drive holds it at rest (``held``).
    """

    share: Floats
    stated: Floats
    held: NDArray[np.bool_]
    node: str


def torque_of_stage(requirement: DriveRequirement, rig: Rig, *, motor: Motor, stage: str) -> OutputTorque:
    """Return torque and speed of the output shaft of the gear, belt or worm ``stage`` on the way to the sensor.

    The motor's torque minus the torque for rotor inertia and friction, times ratio and efficiency of each stage on the
    way where power flows forwards, over the efficiency where it flows back; minus the torque for what hangs on the
    shafts between (inertias J1 of the gearboxes, bodies, branches, their loads) and for the stage itself; the output
    inertia of a gear counts as load.
    """
    way, part = _way(rig, motor.name, stage), rig.part(stage)
    inside = replace(part, output_inertia=0.0) if isinstance(part, Gear) else part
    kept = tuple(term for term in inside.terms(rig) if rig.node(stage) in term.nodes)
    return _walked(requirement, rig, motor, way, inside=_at_places(kept, {rig.node(stage): Place(1.0, 1.0, 1.0)}))


def torque_at_sensor(requirement: DriveRequirement, rig: Rig, *, motor: Motor) -> OutputTorque:
    """Return torque and speed of the shaft before the sensor, as :func:`torque_of_stage`, all before it subtracted.

    A sensor at the motor's foot reads the motor's torque less the motor's friction.
    """
    if isinstance(rig.part(rig.measured), ReactionTorqueSensor):
        return _walked(requirement, rig, replace(motor, inertia=0.0), ())
    way = _way(rig, motor.name, reading_place(rig))
    node = way[-1].near if way else rig.node(motor.name)
    return _walked(requirement, rig, motor, way[:-1], hung=_hung(rig, node, motor.name))


def torque_of_motor(requirement: DriveRequirement, rig: Rig, *, motor: Motor) -> OutputTorque:
    """Return torque and speed of the motor's shaft, the torque for its rotor and its friction subtracted."""
    return _walked(requirement, rig, motor, ())


def _walked(
    requirement: DriveRequirement, rig: Rig, motor: Motor, way: Sequence[_Crossed], *, hung: DriveTrain = NOTHING,
    inside: DriveTrain = NOTHING,
) -> OutputTorque:  # fmt: skip
    """Return the torque at the end of the way, less what is ``hung`` on that shaft and ``inside`` the last stage."""
    slope = np.diff(requirement.speed, axis=1)[:, 0] / requirement.duration
    direction = np.sign(requirement.speed.sum(axis=1))[:, None]
    lost = direction * motor.coulomb + motor.viscous * requirement.speed
    torque, ratio = requirement.torque - motor.inertia * slope[:, None] - lost, 1.0
    loads = _stated_loads(requirement, drive_train(rig, rig.node(motor.name)))
    for spring in way:
        before = _hung(rig, spring.near, motor.name)
        torque = torque - _needed(before, requirement.speed / ratio, slope / ratio, direction, loads)
        forwards = torque * np.where(direction == 0, np.sign(torque), direction) >= 0
        back = 1 / spring.against if spring.against > 0 else 0.0  # a locked worm takes no power from its wheel
        torque = torque * abs(spring.turns) * np.where(forwards, spring.along, back)
        ratio *= abs(spring.turns)
    speed, slope = requirement.speed / ratio, slope / ratio
    torque = torque - _needed(hung, speed, slope, direction, loads)
    torque = torque - _needed(inside, speed, slope, direction, loads._replace(node=""))
    return OutputTorque(duration=requirement.duration, speed=speed, acceleration=slope, torque=torque)


def _stated_loads(requirement: DriveRequirement, train: DriveTrain) -> _Loads:
    """Return the loads of each piece as :meth:`DriveTrain.torque` and :meth:`DriveTrain.holding_torque` take them."""
    own, held = np.isnan(requirement.load), np.broadcast_to(requirement.held[:, None], requirement.load.shape)
    further = held | (not train.mean_load)
    share = np.where(own, 1.0, 0.0 if not train.mean_load else requirement.load / (train.mean_load or 1.0))
    stated = np.where(own | ~further, 0.0, requirement.load)
    if not stated.any():
        return _Loads(share=share, stated=stated, held=held, node="")
    node = train.loaded_node()
    way = np.where(held, np.sign(train.places[node].ratio), 1.0)  # what is held has the sign of its place's turn
    return _Loads(share=share, stated=way * stated, held=held, node=node)


def _needed(train: DriveTrain, speed: Floats, slope: Floats, direction: Floats, loads: _Loads) -> Floats:
    """Return the torque that a part of the train needs of its shaft [N m], shape (pieces, 2)."""
    slopes, ways = np.broadcast_to(slope[:, None], speed.shape), np.broadcast_to(direction, speed.shape)
    place = train.places.get(loads.node)
    if all(isinstance(term, Inertia) for term in train.terms) and place is None:
        return train.inertia * slopes
    moved = zip(speed.flat, slopes.flat, ways.flat, *(each.flat for each in loads[:3]), strict=True)
    found = []
    for turned, rise, way, share, stated, held in moved:
        motion = ShaftMotion(float(turned), float(rise), float(way), 0.0, float(share))
        if held:  # only the stated load is held at rest
            found.append(0.0 if place is None else stated * abs(place.ratio) / place.efficiency)
        else:
            found.append(train.needed(motion, {} if place is None else {loads.node: float(stated)}))
    return np.array(found).reshape(speed.shape)


def _hung(rig: Rig, node: str, motor: str) -> DriveTrain:
    """Return what is at a node on the way to the sensor and on its branches, the motor's own left out."""
    crossed = {spring.name for spring in _way(rig, motor, reading_place(rig))}
    branches = [spring for spring in springs_of(passive_terms(rig)) if spring.name not in crossed]
    return _at_places(passive_terms(rig, without=motor), places_from(node, branches))


def _at_places(terms: Sequence[Term], places: dict[str, Place]) -> DriveTrain:
    """Return the inertias, frictions and loads among the terms that sit at these places."""
    here = [term for term in terms if not isinstance(term, Spring) and not places.keys().isdisjoint(term.nodes)]
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
