"""Current gain: the drive's current sensors differ in gain, which causes a line of order 2p that grows with load."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts import Motor
from torquerig.rig.terms import Term, Wave


@dataclass(frozen=True, kw_only=True)
class CurrentGain(Part):
    """``T = T_motor (1 + (dk/k)/sqrt(3) cos(2 p theta + phi))``, dk/k the relative difference of the two gains.

    Zero without load; a variant of commutation_ripple with the order and depth that follow. Source: Chung & Sul 1998,
    IEEE Trans. Industry Applications 34(5). The mean changes by half as much, which the speed loop takes back and
    which is left out. Not valid above the bandwidth of the current loop.
    """

    kind: Literal["current_gain"] = "current_gain"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    pole_pairs: int
    mismatch: Annotated[float, Parameter("1", "relative difference of the gains", low=0)]
    phase: float | None = None

    def __post_init__(self) -> None:
        if self.pole_pairs < 1:
            raise ValueError(f"{self.pole_pairs} pole pairs are not possible; write at least 1")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where ``at`` is no motor."""
        if not isinstance(rig.part(self.at), Motor):
            raise InputError(f"{self.name}: at: {self.at!r} is no motor; name one")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple of the motor's torque; none where the gains are alike."""
        if self.mismatch == 0:
            return ()
        depth = self.mismatch / sqrt(3)
        return (
            DriveRipple((Wave(order=2 * self.pole_pairs, amplitude=depth, phase=self.phase, phase_key=self.name),)),
        )
