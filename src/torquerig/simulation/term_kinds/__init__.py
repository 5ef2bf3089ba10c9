"""The kinds of term as the simulation knows them: one file each, and the list of them all.

springs  with gaps, errors, varying stiffness    harmonics  torques periodic in an angle
frictions  by the speed    bristles  that bend    loads  over time, over the angle, of blades
drives  motors, and how each sees its speed       imposed  motions that are given    kind  what each declares

A kind declares which classes of ``rig/terms`` it lowers, the arrays that they become, the waves that these need, its
share of the linear matrices, and what the linear twin and the exact linear path do not have of it. Lowering, matrices,
choice of the step, twin, batch and refusals go through ``KINDS``. Only the kernel, which is one compiled loop, names
the arrays: a new kind is a file here with its two lines below, and its torque in ``kernel/rare.py``.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from torquerig.simulation.arrays import Floats, Waves
from torquerig.simulation.term_kinds.bristles import BRISTLES, Bristles
from torquerig.simulation.term_kinds.drives import DRIVES, SENSINGS, Drives, Sensings
from torquerig.simulation.term_kinds.frictions import FRICTIONS, Frictions
from torquerig.simulation.term_kinds.harmonics import HARMONICS, Harmonics
from torquerig.simulation.term_kinds.imposed import IMPOSED, Imposed
from torquerig.simulation.term_kinds.kind import Link, Lowering, Reversal, TermKind
from torquerig.simulation.term_kinds.loads import ANGLE_LOADS, BLADES, LOADS, AngleLoads, Blades, Loads
from torquerig.simulation.term_kinds.springs import SPRINGS, VARIED, Springs, Varied

KINDS: tuple[TermKind[Any, Any], ...] = (
    SPRINGS, VARIED, HARMONICS, FRICTIONS, BRISTLES, LOADS, ANGLE_LOADS, BLADES, DRIVES, SENSINGS, IMPOSED,
)  # fmt: skip


class Terms(NamedTuple):
    """All of a rig, as the kernel takes it: one field for each of ``KINDS``."""

    inverse_inertia: Floats  # (nodes + 1,) [1/(kg m^2)], zero for the ground
    waves: Waves
    springs: Springs
    varied: Varied
    harmonics: Harmonics
    frictions: Frictions
    bristles: Bristles
    loads: Loads
    angle_loads: AngleLoads
    blades: Blades
    drives: Drives
    sensings: Sensings
    imposed: Imposed


__all__ = ["KINDS", "Link", "Lowering", "Reversal", "TermKind", "Terms"]
