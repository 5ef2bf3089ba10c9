"""The filter of the reference report in the steps of its Figures 4.8 to 4.10: mechanical, ripple, unknown line."""

from __future__ import annotations

from torquerig.filters.chains.filter_chain import REPORT_HALF_WIDTH, REPORT_HARMONICS, Chain, select_lines
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.line_families import Family

STEPS: tuple[tuple[str, tuple[Family, ...]], ...] = (
    ("mechanical noise", ("motor", "shaft")),
    ("mechanical noise and torque ripple", ("cogging_per_pole", "electrical")),
    ("mechanical noise, torque ripple and the unknown line", ("slots_times_pole_pairs",)),
)
"""Lines that each figure removes in addition; the last figure has the whole filter."""


def report_filter_steps(kinematics: Kinematics) -> tuple[Chain, ...]:
    """Return the chains of the three figures, each with the lines of those before it."""
    families: list[Family] = []
    chains = []
    for name, more in STEPS:
        families += more
        lines, left_out = select_lines(kinematics, dict.fromkeys(families, range(1, REPORT_HARMONICS + 1)))
        stage = IdealBandstop(lines=lines, half_width=REPORT_HALF_WIDTH)
        chains.append(Chain(name=name, stages=(stage,), left_out=left_out))
    return tuple(chains)
