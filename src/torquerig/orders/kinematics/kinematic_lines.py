"""Order lines of a motor and gearbox, from poles, slots, ratio and teeth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite, lcm, pi, prod
from typing import Literal, get_args

from torquerig.errors import InputError
from torquerig.orders.kinematics.stage_kinds import ChainStage, Toothed, Untoothed, set_of_teeth, untoothed
from torquerig.orders.kinematics.teeth import Planetary

Family = Literal[
    "shaft",
    "motor",
    "cogging_per_pole",
    "cogging",
    "cogging_tolerance_slots",
    "cogging_tolerance_poles",
    "electrical",
    "six_pulse",
    "gear_mesh",
    "slots_times_pole_pairs",
]
FAMILIES: tuple[Family, ...] = get_args(Family)

# cause of the line and its source
CAUSES: dict[Family, tuple[str, str]] = {
    "shaft": ("imbalance, runout or one-sided wear of what turns after the gearbox", "handbook 3.1, 3.3"),
    "motor": ("imbalance, eccentricity or encoder error of the motor's rotor", "handbook 2.5, 3.1"),
    "cogging_per_pole": (
        "cogging periods per magnet, LCM(slots, magnets) / magnets: no cogging torque has this order",
        "handbook 1.1",
    ),
    "cogging": ("native cogging: rotor positions of equal magnetic energy", "handbook 1.1, Zhu & Howe 2000"),
    "cogging_tolerance_slots": (
        "tolerance cogging: unequal magnets pass equal slots",
        "handbook 1.2, Gasparin et al. 2009",
    ),
    "cogging_tolerance_poles": (
        "tolerance cogging: unequal teeth see equal poles; also current gain error",
        "handbook 1.2, 2.2",
    ),
    "electrical": ("one electrical period: current offset or Hall sensor error", "handbook 2.1"),
    "six_pulse": (
        "six torque pulses per electrical period: commutation, back-EMF harmonics or dead time",
        "handbook 1.4, 1.5, 2.3",
    ),
    "gear_mesh": ("teeth of the gearbox in mesh", "handbook 4.1, 4.2"),
    "slots_times_pole_pairs": (
        "slots x pole pairs per output turn: no torque of the motor has this order, but a gear mesh may have it",
        "handbook 4.2",
    ),
}


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
    """

    pole_pairs: int | None = None
    slots: int | None = None
    ratio: float = 1.0
    teeth: tuple[ChainStage, ...] = ()

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
        return kinematic_lines(
            pole_pairs=self.pole_pairs, slots=self.slots, ratio=self.ratio, teeth=self.teeth, harmonics=harmonics
        )

    @property
    def left_out(self) -> dict[Family, str]:
        """The families without lines, each with the missing data."""
        missing: dict[Family, str] = {}
        if self.pole_pairs is None:
            missing |= dict.fromkeys(("cogging_tolerance_poles", "electrical", "six_pulse"), "pole pairs unknown")
        if self.slots is None:
            missing["cogging_tolerance_slots"] = "slots unknown"
        if self.pole_pairs is None or self.slots is None:
            reason = "slots unknown" if self.slots is None else "pole pairs unknown"
            missing |= dict.fromkeys(("cogging_per_pole", "cogging", "slots_times_pole_pairs"), reason)
        if len(open_stages := untoothed(self.teeth)) == len(self.teeth):
            missing["gear_mesh"] = "tooth counts unknown"
        elif open_stages:
            listed = " and ".join(f"{stage.ratio:g}:1" for stage in open_stages)
            missing["gear_mesh"] = f"of the stage of {listed}, whose tooth counts are unknown"
        return {family: missing[family] for family in FAMILIES if family in missing}


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
    """

    family: Family
    harmonic: int
    motor_order: float
    output_order: float
    cause: str
    source: str
    cancelled: bool = False

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
    if harmonics < 1:
        raise InputError(f"{harmonics} harmonics are not possible; write 1 for the fundamental alone")
    kinematics = Kinematics(pole_pairs=pole_pairs, slots=slots, ratio=ratio, teeth=teeth)
    return tuple(
        KinematicLine(
            family, harmonic, harmonic * motor, harmonic * output, cause, CAUSES[family][1],
            cancelled=_cancelled(stage, harmonic, harmonics),
        )
        for family, motor, output, cause, stage in _fundamentals(kinematics)
        for harmonic in range(1, harmonics + 1)
    )  # fmt: skip


def _fundamentals(kinematics: Kinematics) -> Iterator[tuple[Family, float, float, str, Toothed | None]]:
    """Yield family, motor order, output order and cause of each fundamental, and the stage of a gear mesh."""
    ratio, p, slots = kinematics.ratio, kinematics.pole_pairs, kinematics.slots
    yield "shaft", 1 / ratio, 1.0, CAUSES["shaft"][0], None
    motor_orders: dict[Family, int | None] = {
        "motor": 1,
        "cogging_per_pole": lcm(slots, 2 * p) // (2 * p) if p and slots else None,
        "cogging": lcm(slots, 2 * p) if p and slots else None,
        "cogging_tolerance_slots": slots,
        "cogging_tolerance_poles": 2 * p if p else None,
        "electrical": p,
        "six_pulse": 6 * p if p else None,
    }
    for family, order in motor_orders.items():
        if order is not None:
            yield family, float(order), order * ratio, CAUSES[family][0], None
    for position, stage in enumerate(kinematics.teeth):
        if isinstance(stage, Untoothed):
            continue
        before = prod(earlier.ratio for earlier in kinematics.teeth[:position])
        after = prod(later.ratio for later in kinematics.teeth[position + 1 :])
        cause = f"{CAUSES['gear_mesh'][0]}: {stage.spoken}"
        yield "gear_mesh", stage.mesh_order_in / before, stage.mesh_order_out * after, cause, stage
    if p and slots:
        yield "slots_times_pole_pairs", p * slots / ratio, float(p * slots), CAUSES["slots_times_pole_pairs"][0], None


def _cancelled(stage: Toothed | None, harmonic: int, harmonics: int) -> bool:
    """Return whether equal planets cancel a mesh harmonic in the torque."""
    teeth = None if stage is None else set_of_teeth(stage)
    return isinstance(teeth, Planetary) and harmonic not in teeth.torque_harmonics(harmonics)
