"""The spring of a gear, belt or coupling with the changes of the rig's effects."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.host_changes import KinematicError, StiffnessVariation, total_gap, total_shift, waves_of
from torquerig.rig.terms import Spring


def stage_spring(
    rig: Rig, name: str, *, stiffness: float, damping: float, gap: float = 0.0, rest: float = 0.0,
    ratio: float = 1.0, efficiency: float = 1.0, backward_efficiency: float | None = None,
    smoothing: float = 0.02,
) -> Spring:  # fmt: skip
    """Return the spring of the part ``name`` with the errors, gaps and stiffness waves that effects add to it.

    Parameters
    ----------
    rig : Rig
        Whose effects in the part are collected, all of ``host_changes.IN_A_SPRING``.
    stiffness, damping, gap, rest
        At the output [N m/rad], [N m s/rad], [rad], [rad].
    ratio, efficiency, backward_efficiency, smoothing
        As in :class:`torquerig.rig.terms.Spring`.
    """
    changes = rig.changes_in(name)
    return Spring(
        name=name,
        a=rig.upstream(name),
        b=rig.node(name),
        stiffness=stiffness,
        damping=damping,
        gap=gap + total_gap(changes),
        rest=rest + total_shift(changes),
        ratio=ratio,
        efficiency=efficiency,
        backward_efficiency=backward_efficiency,
        smoothing=smoothing,
        error=waves_of(changes, KinematicError),
        stiffness_waves=waves_of(changes, StiffnessVariation),
    )
