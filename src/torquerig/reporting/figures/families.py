"""Names and colours of line families in figures."""

from __future__ import annotations

from torquerig.orders.kinematics.line_families import Family

COLOURS: dict[Family, str] = {
    "shaft": "#1b9e77",
    "motor": "#d95f02",
    "cogging_per_pole": "#7570b3",
    "cogging": "#e7298a",
    "cogging_tolerance_slots": "#66a61e",
    "cogging_tolerance_poles": "#b8860b",
    "electrical": "#1f78b4",
    "six_pulse": "#a6761d",
    "gear_mesh": "#444444",
    "slots_times_pole_pairs": "#c51b1b",
    "intermediate": "#17becf",
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
