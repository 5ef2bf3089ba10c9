"""The changes that an effect can make inside its host part: the closed set of results of ``changes_in_host``.

A term stands next to other terms; a ripple in proportion to a motor's torque, a gear's transmission error or a gap does
not. Each of these is a class here. A host states which of them it has a place for (``Part.takes``), collects them with
``Rig.changes_in`` and builds them into its own term or stage; a rig refuses an effect whose host has no place for it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from torquerig.rig.terms import Wave


@dataclass(frozen=True)
class DriveRipple:
    """Ripple [1] in proportion to the torque of the motor, over the angle of its shaft."""

    what: ClassVar[str] = "a ripple in proportion to the torque"
    waves: tuple[Wave, ...]


@dataclass(frozen=True)
class EncoderAngleError:
    """Angle error [rad] of an encoder on the motor's shaft, over the angle of that shaft."""

    what: ClassVar[str] = "an angle error of the encoder"
    waves: tuple[Wave, ...]


@dataclass(frozen=True)
class KinematicError:
    """Kinematic (transmission) error [rad] in the twist of a spring, on its output side and over its output angle."""

    what: ClassVar[str] = "a kinematic error"
    waves: tuple[Wave, ...]


@dataclass(frozen=True)
class StiffnessVariation:
    """Relative variation [1] of a spring's stiffness over its output angle."""

    what: ClassVar[str] = "a stiffness that varies"
    waves: tuple[Wave, ...]


@dataclass(frozen=True)
class ExtraGap:
    """A gap in a spring on its output side: full width and middle [rad, or m in a line]; both add to the stated."""

    what: ClassVar[str] = "a gap"
    gap: float
    middle: float = 0.0


@dataclass(frozen=True)
class AmplifierCutoff:
    """The cutoff [Hz] of a sensor's amplifier; the lowest of all stated ones and of the sensor's is effective."""

    what: ClassVar[str] = "a cutoff of the amplifier"
    cutoff: float


Waved = DriveRipple | EncoderAngleError | KinematicError | StiffnessVariation
HostChange = Waved | ExtraGap | AmplifierCutoff

IN_A_MOTOR: tuple[type[HostChange], ...] = (DriveRipple, EncoderAngleError)
IN_A_SPRING: tuple[type[HostChange], ...] = (KinematicError, StiffnessVariation, ExtraGap)
IN_A_SENSOR: tuple[type[HostChange], ...] = (AmplifierCutoff,)


def waves_of(changes: Iterable[HostChange], kind: type[Waved]) -> tuple[Wave, ...]:
    """Return the waves of all changes of one kind, in their order."""
    return tuple(wave for change in changes if isinstance(change, kind) for wave in change.waves)


def total_gap(changes: Iterable[HostChange]) -> float:
    """Return the sum of the gaps among the changes [rad, or m in a line]."""
    return sum(change.gap for change in changes if isinstance(change, ExtraGap))


def total_shift(changes: Iterable[HostChange]) -> float:
    """Return the sum of the middles of the gaps among the changes [rad, or m in a line]."""
    return sum(change.middle for change in changes if isinstance(change, ExtraGap))


def lowest_cutoff(bandwidth: float, changes: Iterable[HostChange]) -> float:
    """Return the lowest of a sensor's ``bandwidth`` [Hz] and of the cutoffs among the changes [Hz]."""
    return min((bandwidth, *(change.cutoff for change in changes if isinstance(change, AmplifierCutoff))))
