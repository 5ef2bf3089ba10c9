"""Which part of a rig moves as each recording states."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion, InductionDrive, SpeedController, TorqueController


def imposed_part(rig: Rig) -> ImposedMotion | None:
    """Return the part whose motion each recording states, where nothing else drives the rig, or None.

    The effort of that part is compared where ``measured`` names it, else the torque in the measured spring.
    """
    part = rig.part(rig.measured)
    if isinstance(part, ImposedMotion):
        return part if part.recording is None else None
    driven = any(rig.parts_of(drive) for drive in (SpeedController, TorqueController, InductionDrive))
    imposed = [one for one in rig.parts_of(ImposedMotion) if one.from_ is not None]
    return imposed[0] if len(imposed) == 1 and part.opens_node and not driven else None
