"""The seed's filter in the steps of its Figures 4.8 to 4.10: mechanical noise, then ripple, then the unknown line."""

from __future__ import annotations

from torquerig.filters.chains.filter_chain import SEED_HALF_WIDTH, SEED_HARMONICS, Chain, select_lines
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.orders.kinematics.kinematic_lines import Family, Kinematics

STEPS: tuple[tuple[str, tuple[Family, ...]], ...] = (
    ("mechanical noise", ("motor", "shaft")),
    ("mechanical noise and torque ripple", ("cogging_as_published", "electrical")),
    ("mechanical noise, torque ripple and the unknown line", ("unknown_as_published",)),
)
"""What is cut in addition in each figure; the last one is the whole filter."""


def seed_steps(kinematics: Kinematics) -> tuple[Chain, ...]:
    """Return the chains of the three figures, each with the lines of those before it."""
    families: list[Family] = []
    chains = []
    for name, more in STEPS:
        families += more
        lines, left_out = select_lines(kinematics, dict.fromkeys(families, range(1, SEED_HARMONICS + 1)))
        stage = IdealBandstop(lines=lines, half_width=SEED_HALF_WIDTH)
        chains.append(Chain(name=name, stages=(stage,), left_out=left_out))
    return tuple(chains)
