"""Gear mesh: the transmission error of a stage, periodic in its output angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError
from torquerig.rig.parts.gear_stage import gear_stage
from torquerig.rig.terms import Term, Wave


@dataclass(frozen=True, kw_only=True)
class GearMesh(Part):
    """``e(theta) = sum_h e_h cos(h z theta + phi_h) (1 + m cos(n theta))``, added to the output twist of the gear.

    z = ``order_output`` is the tooth count of the ring (planetary with fixed ring) or of the output wheel. The torque
    that follows is the gear's stiffness and damping times e, through the shafts. Source: Smith, Gear Noise and
    Vibration (transmission error as the excitation); McFadden & Smith 1985, Proc. IMechE (planet modulation).
    The errors are measured ones (single-flank test, or the angle error of a data sheet); tooth_mesh derives order and
    size from the teeth. Not valid where the mesh stiffness varies much over a tooth (heavily loaded spur gears).
    """

    kind: Literal["gear_mesh"] = "gear_mesh"
    gear: str = "gearbox"
    group: Literal["mechanical"] = "mechanical"
    order_output: Annotated[float, Parameter("1", "mesh order on the output shaft", above=0)]
    transmission_error: tuple[Annotated[float, Parameter("rad", "zero-to-peak error of a harmonic", low=0)], ...]
    phases: tuple[float, ...] = ()
    planets: int = 3
    planet_modulation: Annotated[float, Parameter("1", "modulation at the planet order", low=0)] = 0.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the gear carries the error; InputError where ``gear`` is none."""
        gear_stage(rig, self.gear, owner=self.name)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the gear; the modulation as its two side lines."""
        waves = []
        for harmonic, amplitude in enumerate(self.transmission_error, start=1):
            order = harmonic * self.order_output
            phase = self.phases[harmonic - 1] if harmonic <= len(self.phases) else None
            side = 0.5 * self.planet_modulation * amplitude
            for shift, share in ((0, amplitude), (self.planets, side), (-self.planets, side)):
                if share > 0:
                    key = f"{self.name}.{harmonic}"
                    waves.append(Wave(order=order + shift, amplitude=share, phase=phase, phase_key=key))
        return (KinematicError(tuple(waves)),)
