"""Whether the sampled speed loop of a rig is stable, as far as its linear twin says."""

from __future__ import annotations

from torquerig.errors import TorquerigError
from torquerig.rig.assembly import Rig
from torquerig.simulation.failure import unstable
from torquerig.simulation.twin.linear_twin import twin_of


def loop_warning(rig: Rig, *, rate: float) -> str:
    """Return one sentence where the speed loop, sampled at ``rate`` [Hz], is unstable at the set-point; else empty.

    Empty too where no loop controls a speed, or where the rig has no one operating point (``twin_of``).
    """
    try:
        twin = twin_of(rig, rate=rate)
    except TorquerigError:
        return ""
    if twin.stable or not any(drive.holds_speed for drive in twin.lowered.drive_terms):
        return ""
    return unstable(twin)
