"""What a torque at another shaft is in the measured one."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.reading_place import reading_place


def load_lever(rig: Rig, node: str) -> float:
    """Return the turns of ``node`` per turn of the measured shaft [1], in a line [m/rad]; negative where it reverses.

    A torque at the node is in the measured shaft as torque times lever, by the power that both carry; losses between
    are left out. 1 where no shaft leads there.
    """
    return rig.speed_ratios(rig.node(reading_place(rig))).get(node, 1.0)
