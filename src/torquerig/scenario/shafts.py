"""The shafts of a rig, each with its ratio to the motor and the meshes, belts and bearings that act on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from math import isclose
from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.orders.kinematics.belt import Belt
from torquerig.orders.kinematics.line_families import CAUSES
from torquerig.orders.kinematics.motor_orders import TORQUE_FAMILIES, missing_counts, motor_orders
from torquerig.orders.kinematics.shafts import LineSource, Shaft
from torquerig.rig.leading_part import leading_motor, leading_part
from torquerig.rig.parts.gear_stage import GearStage, gear_stages
from torquerig.rig.parts.motor import Motor

if TYPE_CHECKING:
    from torquerig.orders.kinematics.line_families import Family
    from torquerig.rig.assembly import Rig


@dataclass
class _Made:
    """A shaft while it is collected: its name, the motor's turns per turn of it, its parts, open gears and lines."""

    name: str
    turns: float
    parts: list[str] = field(default_factory=list)
    open_gears: list[str] = field(default_factory=list)
    sources: list[LineSource] = field(default_factory=list)
    missing: dict[Family, str] = field(default_factory=dict)


def shafts_of(rig: Rig, *, turns: Callable[[str], float], to_output: float) -> tuple[Shaft, ...]:
    """Return the shafts of a rig in the order of its parts, those of branches and behind the sensor included.

    Parameters
    ----------
    rig : Rig
    turns : callable
        Returns the turns of the motor, or of the part whose motion is imposed, per turn of a part [1], > 0.
    to_output : float
        The same of the measured part.

    Notes
    -----
    Couplings and sensors do not change the speed; gears and belts start a new shaft. What moves in a line has no
    orders and is left out.
    """
    made = {one.name: one for one in _collected(rig, turns)}
    for gear in gear_stages(rig):
        if gear.after is None or gear.name not in made or (into := made.get(_shaft_of(rig, gear.after))) is None:
            continue
        out = made[gear.name]
        found = tuple(_of_gear(rig, gear, into.turns, out.turns, to_output))
        out.sources += found
        if not any(one.family == "gear_mesh" for one in found) and _may_mesh(gear):
            into.open_gears.append(gear.name)
            out.open_gears.append(gear.name)
    leader = leading_part(rig)
    driven = "" if leader is None else _shaft_of(rig, leader)
    for one in made.values():
        one.sources += _bearings(rig, one, to_output)
        _add_further_motors(rig, one, to_output)
        if not any(isclose(one.turns, other, rel_tol=1e-9) for other in (1.0, to_output)):
            one.sources.insert(0, _turn(f"{one.name} shaft", one.turns, to_output))
    own = next((motor.name for motor in rig.parts_of(Motor) if motor is leading_motor(rig)), "")
    name = {driven: "motor" if driven in made and own in made[driven].parts else leader}
    return tuple(
        Shaft(name=name.get(one.name) or one.name, ratio=one.turns, parts=tuple(one.parts),
              sources=tuple(one.sources), open_gears=tuple(one.open_gears),
              missing=one.missing)
        for one in made.values()
    )  # fmt: skip


def _collected(rig: Rig, turns: Callable[[str], float]) -> list[_Made]:
    """Return one shaft per first part of a line and per gear, with the parts that turn with it."""
    made: dict[str, _Made] = {}
    for part in rig.parts:
        if not part.on_shaft or rig.in_a_line(part):
            continue
        name = _shaft_of(rig, part.name)
        if name not in made:
            made[name] = _Made(name, turns(name))
        made[name].parts.append(part.name)
    return list(made.values())


def _shaft_of(rig: Rig, name: str) -> str:
    """Return the name of the shaft that a part turns with: its gear, or the first part of its line."""
    part = rig.part(name)
    if not part.on_shaft and part.host is not None:
        return _shaft_of(rig, part.host)
    return part.name if isinstance(part, GearStage) or part.after is None else _shaft_of(rig, part.after)


def _of_gear(rig: Rig, gear: GearStage, into: float, out: float, to_output: float) -> Iterator[LineSource]:
    """Yield the lines of a gear or belt: its meshes, the shafts between its stages, the turn of its belt.

    ``into`` and ``out`` are the motor's turns per turn of its input and of its output.
    """
    before = into
    for number, stage in enumerate(gear.teeth, start=1):
        after = out if number == len(gear.teeth) else before * stage.ratio
        cause = f"{CAUSES['gear_mesh'][0]}: {stage.spoken}"
        name = "belt mesh" if isinstance(stage, Belt) else "gear mesh" if len(gear_stages(rig)) == 1 else ""
        yield LineSource(
            family="gear_mesh", order=stage.mesh_order_out, motor_order=stage.mesh_order_in / before,
            output_order=stage.mesh_order_out * (to_output / after), cause=cause, stage=stage,
            name=name or f"gear mesh of {gear.name}",
        )  # fmt: skip
        if number < len(gear.teeth):
            yield _turn(f"shaft behind stage {number} of {gear.name}", after, to_output)
        before = after
    if not gear.teeth:
        yield from _stated_meshes(rig, gear, out, to_output)
    belt = _belt_of(rig, gear)
    if belt is not None:
        yield _on(
            "belt", belt.belt_order_out, out, to_output, name="belt" if gear.kind == "belt" else f"belt of {gear.name}",
            cause=f"{CAUSES['belt'][0]}: {belt.spoken}",
        )  # fmt: skip


def _stated_meshes(rig: Rig, gear: GearStage, out: float, to_output: float) -> Iterator[LineSource]:
    """Yield the mesh of a gear without teeth whose order an effect states."""
    for order in dict.fromkeys(mesh.order_output for mesh in rig.of_kind("gear_mesh") if mesh.gear == gear.name):
        name = "gear mesh" if len(gear_stages(rig)) == 1 else f"gear mesh of {gear.name}"
        cause = f"{CAUSES['gear_mesh'][0]}: {order:g} per turn of {gear.name}"
        yield _on("gear_mesh", order, out, to_output, name=name, cause=cause)


def _belt_of(rig: Rig, gear: GearStage) -> Belt | None:
    """Return the belt of a belt stage, or the one that an effect states for a plain gear."""
    geometry = getattr(gear, "geometry", None)
    if geometry is not None:
        return geometry() if isinstance(geometry(), Belt) else None
    for lines in rig.of_kind("belt_lines"):
        if lines.gear == gear.name:
            try:
                belt = lines.belt(rig)
            except InputError:  # terms() reports it with the effect's name
                return None
            return belt if isinstance(belt, Belt) else None
    return None


def _may_mesh(gear: GearStage) -> bool:
    """Return whether a stage without known teeth has teeth at all; a smooth belt has none."""
    return gear.kind != "belt"


def _bearings(rig: Rig, shaft: _Made, to_output: float) -> list[LineSource]:
    cause = CAUSES["bearing"][0]
    return [
        _on("bearing", defect.order, shaft.turns, to_output, name=defect.name.replace("_", " "), cause=cause)
        for defect in rig.of_kind("bearing_defect")
        if defect.at in shaft.parts
    ]


def _add_further_motors(rig: Rig, shaft: _Made, to_output: float) -> None:
    """Add the lines of the motors on a shaft, but for the leading one: cogging, electrical period, torque pulses."""
    leader = leading_motor(rig)
    for motor in rig.parts_of(Motor):
        leads = motor is leader and isclose(shaft.turns, 1.0, rel_tol=1e-9)
        if leads or motor.name not in shaft.parts:
            continue
        known = motor_orders(motor.pole_pairs, motor.slots)
        shaft.sources += [
            replace(_on(family, known[family], shaft.turns, to_output, name=f"{motor.name} {family.replace('_', ' ')}",
                        cause=f"{motor.name}: {CAUSES[family][0]}"), at=motor.name)
            for family in TORQUE_FAMILIES if family in known
        ]  # fmt: skip
        for family, count in missing_counts(motor.pole_pairs, motor.slots).items():
            if family in TORQUE_FAMILIES:
                others = [shaft.missing[family]] if family in shaft.missing else []
                shaft.missing[family] = " and ".join([*others, f"{count} of {motor.name} unknown"])


def _turn(name: str, turns: float, to_output: float) -> LineSource:
    return _on("intermediate", 1.0, turns, to_output, name=name, cause=CAUSES["intermediate"][0])


def _on(family: Family, order: float, turns: float, to_output: float, *, name: str, cause: str) -> LineSource:
    """Return a line of ``order`` periods per turn of the shaft that the motor turns ``turns`` times as fast as."""
    return LineSource(
        family=family, order=order, motor_order=order / turns, output_order=order * (to_output / turns), name=name,
        cause=cause,
    )  # fmt: skip
