"""A further measured channel: the torque in any spring; speed, angle or acceleration of any shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from torquerig.errors import InputError
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class Probe(Part):
    """An ideal instrument: no inertia, no noise, no bandwidth; it writes the channel ``name`` with the unit behind it.

    Parameters
    ----------
    quantity : {"torque", "speed", "angle", "acceleration"}
        Torque in the spring of ``at`` [N m], or speed [rad/s], angle [rad] or acceleration [rad/s^2] of its shaft.
    at : str
        A gear, sensor or coupling for a torque; any part on a shaft for the others.
    """

    kind: Literal["probe"] = "probe"
    quantity: Literal["torque", "speed", "angle", "acceleration"]
    at: str

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return nothing; InputError where there is no such spring or shaft."""
        if self.quantity == "torque" and not rig.part(self.at).opens_node:
            raise InputError(f"{self.name}: {self.at!r} has no spring whose torque could be read; name a gear, sensor "
                             "or coupling")  # fmt: skip
        rig.node(self.at)
        return ()
