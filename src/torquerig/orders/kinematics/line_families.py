"""The kinds of order lines of a drive, and the causes of each kind with their sources."""

from __future__ import annotations

from typing import Literal, get_args

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
    "intermediate",
    "belt",
    "bearing",
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
    "intermediate": ("imbalance, runout or eccentricity of what turns between two gears", "handbook 3.1, 3.3"),
    "belt": ("turn of the belt: its joint, or a place of other thickness or stiffness", "handbook 3.7"),
    "bearing": ("damaged bearing: rolling elements pass the damaged place", "handbook 3.6, Randall & Antoni 2011"),
}
