"""The spring of a gear, belt or coupling with what the effects of the rig put into it."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Spring


def stage_spring(
    rig: Rig, name: str, *, stiffness: float, damping: float, gap: float = 0.0, ratio: float = 1.0,
    efficiency: float = 1.0,
) -> Spring:  # fmt: skip
    """Return the spring of the part ``name`` with the errors, gaps and stiffness waves that effects add to it.

    Parameters
    ----------
    rig : Rig
        Whose parts are asked for their ``kinematic_error``, ``stiffness_waves`` and ``extra_gap``.
    stiffness, damping, gap
        At the output [N m/rad], [N m s/rad], [rad].
    ratio, efficiency
        As in :class:`torquerig.rig.terms.Spring`.
    """
    return Spring(
        name=name,
        a=rig.upstream(name),
        b=rig.node(name),
        stiffness=stiffness,
        damping=damping,
        gap=gap + sum(part.extra_gap(name) for part in rig.parts),
        ratio=ratio,
        efficiency=efficiency,
        error=tuple(wave for part in rig.parts for wave in part.kinematic_error(name, rig)),
        stiffness_waves=tuple(wave for part in rig.parts for wave in part.stiffness_waves(name, rig)),
    )
