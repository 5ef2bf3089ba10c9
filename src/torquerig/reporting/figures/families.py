"""Names and colours of line families in figures."""

from __future__ import annotations

from torquerig.orders.kinematics.line_families import Family

COLOURS: dict[Family, str] = {
    "shaft": "#009e73",
    "motor": "#e69f00",
    "cogging_per_pole": "#7a68a6",
    "cogging": "#cc79a7",
    "cogging_tolerance_slots": "#8c4a73",
    "cogging_tolerance_poles": "#b8860b",
    "electrical": "#0072b2",
    "six_pulse": "#a6761d",
    "gear_mesh": "#444444",
    "slots_times_pole_pairs": "#4b3b8f",
    "intermediate": "#56b4e9",
    "belt": "#8c564b",
    "bearing": "#e377c2",
}

SHORT: dict[Family, str] = {
    "shaft": "output shaft",
    "motor": "motor shaft",
    "cogging_per_pole": "cogging per pole",
    "cogging": "cogging",
    "cogging_tolerance_slots": "cogging, magnets",
    "cogging_tolerance_poles": "cogging, teeth",
    "electrical": "electrical",
    "six_pulse": "six-pulse",
    "gear_mesh": "gear mesh",
    "slots_times_pole_pairs": "slots x pole pairs",
    "intermediate": "intermediate shaft",
    "belt": "belt",
    "bearing": "bearing",
}
"""For labels inside a figure; ``NAMES`` are for legends."""

NAMES: dict[Family, str] = {
    "shaft": "output shaft",
    "motor": "motor shaft",
    "cogging_per_pole": "cogging periods per pole",
    "cogging": "cogging",
    "cogging_tolerance_slots": "cogging, unequal magnets",
    "cogging_tolerance_poles": "cogging, unequal teeth",
    "electrical": "electrical period",
    "six_pulse": "six pulses per electrical period",
    "gear_mesh": "gear mesh",
    "slots_times_pole_pairs": "slots x pole pairs per output turn",
    "intermediate": "intermediate shaft",
    "belt": "turn of the belt",
    "bearing": "bearing",
}
