"""Back-EMF harmonics: sinusoidal currents with a back-EMF that is not exactly sinusoidal, order 6p."""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.terms import HarmonicTorque, Term, Wave

Share = Annotated[float, Parameter("1", "share of the fundamental, negative where turned by half a period")]


@dataclass(frozen=True, kw_only=True)
class BackEmfHarmonics(Part):
    """``T = T_motor (1 + (e_7 - e_5) cos(6 p theta) + ...)`` under field-oriented control, 6k+1 and 6k-1 likewise.

    What the harmonics drive through the current loop comes on top: ``-3/2 p lambda  lambda w_e (e_7 - e_5) Y(6 f_e)``,
    nothing at low speed and independent of the load. Harmonics of orders divisible by three make no torque. A variant
    of commutation_ripple. Source: Jahns & Soong 1996, IEEE Trans. Industrial Electronics 43(2). To first order in the
    harmonics; true below the loop's bandwidth while the DC link suffices; the size is that of the set-point's speed.
    """

    kind: Literal["back_emf_harmonics"] = "back_emf_harmonics"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    shares: dict[int, Share]

    def __post_init__(self) -> None:
        for order in self.shares:
            if order < 5 or order % 6 not in (1, 5):
                raise ValueError(f"{order} is no harmonic that makes torque; write 5, 7, 11, 13, ...")

    def differences(self) -> dict[int, float]:
        """Return ``e_{6k+1} - e_{6k-1}`` by 6k."""
        found: dict[int, float] = {}
        for order, share in self.shares.items():
            six = 6 * round(order / 6)
            found[six] = found.get(six, 0.0) + (share if order > six else -share)
        return {six: share for six, share in sorted(found.items()) if share}

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the torque that the current loop does not suppress; InputError without motor_phases."""
        node, phases = rig.node(self.at), phases_of(rig, self.at)
        if phases.flat_angle is not None:
            raise InputError(f"{self.name}: {phases.name} has a trapezoidal back-EMF already; leave flat_angle out")
        electrical = phases.pole_pairs * abs(rig.run.speed or 0.0)
        waves = []
        for six, share in self.differences().items():
            volts = phases.flux_linkage * electrical * share
            line = -phases.torque_per_ampere * volts * phases.admittance(six * electrical / (2 * pi))
            if line:
                waves.append(Wave(order=float(six * phases.pole_pairs), amplitude=abs(line), phase=phase(line)))
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=tuple(waves)),)

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple that grows with the torque."""
        pairs = phases_of(rig, self.at).pole_pairs
        waves = (
            Wave(order=float(six * pairs), amplitude=abs(share), phase=0.0 if share > 0 else pi)
            for six, share in self.differences().items()
        )
        return (DriveRipple(tuple(waves)),)
