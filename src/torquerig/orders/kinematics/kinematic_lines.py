"""Order lines of a motor and gearbox, from poles, slots, ratio and teeth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite, pi, prod
from typing import NamedTuple

from torquerig.errors import InputError
from torquerig.orders.kinematics.line_families import CAUSES, FAMILIES, Family
from torquerig.orders.kinematics.motor_orders import missing_counts, motor_orders
from torquerig.orders.kinematics.shafts import OpenMesh, Shaft
from torquerig.orders.kinematics.stage_kinds import ChainStage, Toothed, Untoothed, set_of_teeth, untoothed
from torquerig.orders.kinematics.teeth import Planetary, Teeth

MOST_COUNTED = 10_000  # [1] poles or slots; the largest wind generators have some hundred
LARGEST_RATIO = 1e6  # [1] gears in series reach some thousand


@dataclass(frozen=True, kw_only=True)
class Kinematics:
    """Poles, slots, ratio and teeth of a drive, which determine its order lines.

    Parameters
    ----------
    pole_pairs, slots : int or None
        Of the motor; None where unknown or not applicable. Lines that need them are then left out.
    ratio : float
        Motor turns per output turn [1], > 0.
    teeth : tuple of ChainStage
        The stages from the motor to the output, those without known teeth by their ratio; empty where no tooth count is
        known.
    possible_teeth : tuple of Planetary or Spur
        The single stages that the gear may be, where several are possible.
    shafts : tuple of Shaft
        All shafts of a rig, with their meshes, belts and bearings, whose lines replace those of ``teeth``; empty where
        only the drive is known.
    input_name : str
        What turns with the motor's angle: ``motor``, or the part whose motion is imposed on a rig without a motor.
    has_motor : bool
        False where no motor is in the rig, so that no line has poles or slots.
    gear_unknown : bool
        True where nothing states whether there is a gear.
    """

    pole_pairs: int | None = None
    slots: int | None = None
    ratio: float = 1.0
    teeth: tuple[ChainStage, ...] = ()
    possible_teeth: tuple[Teeth, ...] = ()
    shafts: tuple[Shaft, ...] = ()
    input_name: str = "motor"
    has_motor: bool = True
    gear_unknown: bool = False

    def __post_init__(self) -> None:
        for name, count in (("pole pairs", self.pole_pairs), ("slots", self.slots)):
            if count is not None and not 1 <= count <= MOST_COUNTED:
                raise InputError(
                    f"{count} {name} are not possible; write 1 to {MOST_COUNTED}, or leave it out where it is unknown"
                )
        if not (isfinite(self.ratio) and 1 / LARGEST_RATIO <= self.ratio <= LARGEST_RATIO):
            raise InputError(
                f"a gear ratio of {self.ratio:g} is not possible; write motor turns per output turn, more than 0 and "
                f"at most {LARGEST_RATIO:g}"
            )
        by_teeth = prod(stage.ratio for stage in self.teeth)
        if self.teeth and abs(by_teeth / self.ratio - 1) > 0.02:
            raise InputError(
                f"the teeth give a ratio of {by_teeth:.4g}, the gearbox states {self.ratio:.4g}; correct one of them"
            )

    def lines(self, harmonics: int = 4) -> tuple[KinematicLine, ...]:
        """Return the lines with ``harmonics`` members per family, family by family."""
        return _lines_of(self, harmonics)

    @property
    def left_out(self) -> dict[Family, str]:
        """The families without lines, each with the missing data."""
        missing = {family: f"{count} unknown" for family, count in missing_counts(self.pole_pairs, self.slots).items()}
        if not self.has_motor:
            elsewhere = {source.family for shaft in self.shafts for source in shaft.sources if source.at}
            reason = f"no motor turns with {self.input_name}" if elsewhere else "the rig has no motor"
            missing = {family: reason for family in missing if family not in elsewhere}
        for shaft in self.shafts:
            for family, reason in shaft.missing.items():
                missing[family] = " and ".join(one for one in (missing.get(family), reason) if one)
        if reason := self._unknown_teeth():
            missing["gear_mesh"] = reason
        return {family: missing[family] for family in FAMILIES if family in missing}

    def _unknown_teeth(self) -> str:
        """Return why mesh lines are missing; empty where none is."""
        if self.shafts:
            gears = dict.fromkeys(gear for shaft in self.shafts for gear in shaft.open_gears)
            meshed = any(source.family == "gear_mesh" for shaft in self.shafts for source in shaft.sources)
            if not gears:
                return "" if meshed else "the rig has no gear"
            return f"tooth counts of {' and '.join(gears)} unknown" if meshed else "tooth counts unknown"
        if self.possible_teeth:
            return f"one of {len(self.possible_teeth)} sets of teeth is possible, which one is not known"
        if len(open_stages := untoothed(self.teeth)) == len(self.teeth):
            return "tooth counts unknown"
        listed = " and ".join(f"{stage.ratio:g}:1" for stage in open_stages)
        return f"of the stage of {listed}, whose tooth counts are unknown" if listed else ""

    @property
    def shaft_turns(self) -> dict[str, float]:
        """Turns of each shaft per turn of the output shaft [1], by its name: motor, intermediate shafts, output."""
        named = {self.input_name: self.ratio, **{shaft.name: self.ratio / shaft.ratio for shaft in self.shafts}}
        speeds = {turns: name for name, turns in reversed(named.items())}
        return {name: turns for turns, name in sorted(speeds.items(), reverse=True)} | (
            {} if 1.0 in speeds else {"output": 1.0}
        )

    @property
    def fastest_shaft(self) -> tuple[str, float]:
        """The name of the shaft that turns most, and its turns per turn of the output shaft [1], at least 1."""
        return next(iter(self.shaft_turns.items()))

    @property
    def open_meshes(self) -> tuple[OpenMesh, ...]:
        """The gears whose teeth are not known, from each shaft on which they mesh."""
        if self.shafts:
            return tuple(
                OpenMesh(shaft=shaft.name, turns=self.ratio / shaft.ratio) for shaft in self.shafts if shaft.open_gears
            )
        if self.possible_teeth:
            orders = tuple(dict.fromkeys(stage.mesh_order_out for stage in self.possible_teeth))
            return (OpenMesh(shaft="output", turns=1.0, teeth=orders),)
        if self.teeth or (self.ratio == 1.0 and not self.gear_unknown):
            return ()
        shafts = dict.fromkeys((("output", 1.0), (self.input_name, self.ratio)))
        return tuple(OpenMesh(shaft=name, turns=turns) for name, turns in shafts)


@dataclass(frozen=True)
class KinematicLine:
    """A spectral line of the torque whose frequency is proportional to the shaft's speed.

    Parameters
    ----------
    family : Family
        The name of its cause.
    harmonic : int
        1 is the fundamental.
    motor_order, output_order : float
        Periods per turn of the motor and of the output shaft [1/rev].
    cause, source : str
        The cause in words, and its equation or handbook section.
    cancelled : bool
        Whether equal planets cancel it in the torque; unequal planets do not cancel it completely.
    name : str
        The cause in a label, without the harmonic; empty for that of the family.
    at : str
        The part of the rig at which its torque acts, where it is a further motor; empty for the drive itself.
    """

    family: Family
    harmonic: int
    motor_order: float
    output_order: float
    cause: str
    source: str
    cancelled: bool = False
    name: str = ""
    at: str = ""

    @property
    def label(self) -> str:
        """The cause in a label, without the harmonic: ``gear mesh``."""
        return self.name or self.family.replace("_", " ")

    def frequency(self, motor_speed: float) -> float:
        """Return the frequency of the line [Hz] at a motor speed [rad/s] of either sign."""
        return self.motor_order * abs(motor_speed) / (2 * pi)


def kinematic_lines(
    *,
    pole_pairs: int | None,
    slots: int | None,
    ratio: float,
    teeth: tuple[ChainStage, ...] = (),
    harmonics: int = 4,
) -> tuple[KinematicLine, ...]:
    """Return the order lines of a motor and gearbox, the fundamental first in each family.

    Parameters
    ----------
    pole_pairs, slots, ratio, teeth
        As in :class:`Kinematics`; lines that need unknown data are left out.
    harmonics : int
        Members per family; 1 is the fundamental alone.

    Raises
    ------
    InputError
        For impossible counts, ratio or teeth.

    Notes
    -----
    Source: handbook 0, 1, 2 and 4; reference report, eq. 3.1-3.4 and Table I, for ``cogging_per_pole`` and
    ``slots_times_pole_pairs``. Slip of an induction machine, bearing and belt lines are not included. Orders do not
    determine amplitudes.
    """
    kinematics = Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=ratio, teeth=teeth)
    return _lines_of(kinematics, harmonics)


def _lines_of(kinematics: Kinematics, harmonics: int) -> tuple[KinematicLine, ...]:
    if harmonics < 1:
        raise InputError(f"{harmonics} harmonics are not possible; write 1 for the fundamental alone")
    return tuple(
        KinematicLine(
            one.family, harmonic, harmonic * one.motor, harmonic * one.output, one.cause, CAUSES[one.family][1],
            cancelled=_cancelled(one.stage, harmonic, harmonics),
            name=one.name, at=one.at,
        )
        for one in _fundamentals(kinematics)
        for harmonic in range(1, harmonics + 1)
    )  # fmt: skip


class _Fundamental(NamedTuple):
    """A fundamental: its orders [1/rev], cause, the stage of a mesh, a name in place of the family's, and its motor."""

    family: Family
    motor: float
    output: float
    cause: str
    stage: Toothed | None = None
    name: str = ""
    at: str = ""


def _fundamentals(kinematics: Kinematics) -> Iterator[_Fundamental]:
    """Yield the fundamental of each line, family by family."""
    ratio, p, slots = kinematics.ratio, kinematics.pole_pairs, kinematics.slots
    driven = "" if kinematics.has_motor else kinematics.input_name
    yield _Fundamental("shaft", 1 / ratio, 1.0, CAUSES["shaft"][0], name=driven if ratio == 1 else "")
    cause = f"imbalance or eccentricity of {driven}" if driven else CAUSES["motor"][0]
    yield _Fundamental("motor", 1.0, ratio, cause, name=driven)
    for family, order in motor_orders(p, slots).items():
        yield _Fundamental(family, float(order), order * ratio, CAUSES[family][0])
    if kinematics.shafts:
        for source in (source for shaft in kinematics.shafts for source in shaft.sources):
            yield _Fundamental(
                source.family,
                source.motor_order,
                source.output_order,
                source.cause,
                source.stage,
                source.name,
                source.at,
            )
    else:
        yield from _meshes(kinematics)
    if p and slots:
        cause = CAUSES["slots_times_pole_pairs"][0]
        yield _Fundamental("slots_times_pole_pairs", p * slots / ratio, float(p * slots), cause)


def _meshes(kinematics: Kinematics) -> Iterator[_Fundamental]:
    for position, stage in enumerate(kinematics.teeth):
        if isinstance(stage, Untoothed):
            continue
        before = prod(earlier.ratio for earlier in kinematics.teeth[:position])
        after = prod(later.ratio for later in kinematics.teeth[position + 1 :])
        cause = f"{CAUSES['gear_mesh'][0]}: {stage.spoken}"
        yield _Fundamental("gear_mesh", stage.mesh_order_in / before, stage.mesh_order_out * after, cause, stage)


def _cancelled(stage: Toothed | None, harmonic: int, harmonics: int) -> bool:
    """Return whether equal planets cancel a mesh harmonic in the torque."""
    teeth = None if stage is None else set_of_teeth(stage)
    return isinstance(teeth, Planetary) and harmonic not in teeth.torque_harmonics(harmonics)
