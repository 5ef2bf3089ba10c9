"""Tooth mesh: the lines of a gear from its tooth counts, module and errors, with what the planets cancel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, pi
from typing import Annotated, Literal, NamedTuple

from torquerig.errors import InputError
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError, StiffnessVariation
from torquerig.rig.parts.gear_stage import gear_stage
from torquerig.rig.terms import Term, Wave

Length = Annotated[float, Parameter("m", "zero-to-peak error of a harmonic, along the line of action", low=0)]
Share = Annotated[float, Parameter("1", "zero-to-peak share", low=0)]
SMALLEST_SHARE = 1e-9  # below this share a line that the planets cancel is only rounding error


class MeshLine(NamedTuple):
    """One line: its cause, its order on the output shaft, its size, and lines of one ``key`` share a phase."""

    cause: str
    order: float
    size: float
    key: str


@dataclass(frozen=True, kw_only=True)
class ToothMesh(Part):
    """``e = sum_h (x_h / r) sum_k w_k (1 + sum_s m_s cos(s theta_k)) cos(h z theta_k + phi_h)`` in the gear's twist.

    A variant of gear_mesh whose orders and sizes come from the teeth of ``gear``: z periods per turn of the output,
    x_h the transmission error of one mesh, r its lever ``module/2 cos(alpha)`` times the wheel's teeth (sun + ring
    where the carrier is the output), theta_k = theta + 2 pi k/n the place of planet k, w_k its share of the load. Of n
    equal planets only orders that are multiples of n remain: in phase (sun/n whole) the mesh and all harmonics, else
    every n-th and side lines h z +- s. Unequal shares leave something of all. m_s is what depends on the place round
    the ring (runout 1, ovality 2). An eccentric wheel (fixed axis) adds a line at its turn, e/r, and side
    lines at its turns on both sides of h z, h e/module of the line (phase modulation, small index).

    ``stiffness_variation`` is the gear's stiffness over a tooth pitch, k (1 + sum_h s_h cos(h z theta)), with what the
    planets leave of it. Ripple in proportion to the load follows (to first order s_h T of the torque T), its
    harmonics, and growth without any error where the mesh frequency is twice a mode's (parametric resonance); the
    damping stays. ``tooth_error`` is a measured or toleranced deviation.

    Source: signatures.md 4.1, 4.2; Smith, Gear Noise and Vibration; McFadden & Smith 1985, Proc. IMechE (side lines);
    Parker 2000, J. Sound and Vibration 236(4) (phasing); Gregory, Harris & Munro 1963; Nayfeh & Mook 1979, Nonlinear
    Oscillations, 5.3. Not valid for a sun that floats, nor where teeth part in a gear that states no backlash.
    """

    kind: Literal["tooth_mesh"] = "tooth_mesh"
    group: Literal["mechanical"] = "mechanical"
    gear: str = "gearbox"
    module: Annotated[float, Parameter("m", "module", above=0)]
    pressure_angle: Annotated[float, Parameter("rad", "pressure angle", above=0, high=pi / 4)] = pi / 9
    tooth_error: tuple[Length, ...] = ()
    stiffness_variation: tuple[Share, ...] = ()
    planet_shares: tuple[Share, ...] = ()
    position_modulation: tuple[Share, ...] = ()
    pinion_eccentricity: Annotated[float, Parameter("m", "pinion's centre off its axis", low=0)] = 0.0
    wheel_eccentricity: Annotated[float, Parameter("m", "wheel's centre off its axis", low=0)] = 0.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the gear carries the error; InputError where the gear or its teeth cannot have it."""
        teeth = self._teeth(rig)
        if isinstance(teeth, Planetary):
            if self.pinion_eccentricity or self.wheel_eccentricity:
                raise InputError(
                    f"{self.name}: an eccentric wheel needs a fixed-axis pair; of a planetary stage state "
                    "position_modulation or planet_shares"
                )
            if self.planet_shares and (
                len(self.planet_shares) != teeth.planets or abs(sum(self.planet_shares) - 1) > 1e-6
            ):
                raise InputError(
                    f"{self.name}: planet_shares are {len(self.planet_shares)} numbers of sum "
                    f"{sum(self.planet_shares):g}; write one per planet of {self.gear}, of sum 1"
                )
        elif self.planet_shares:
            raise InputError(f"{self.name}: {self.gear} has no planets; leave planet_shares out")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the gear and how its stiffness varies."""
        teeth = self._teeth(rig)
        return KinematicError(self._error(teeth)), StiffnessVariation(self._stiffness(teeth))

    def _error(self, teeth: Planetary | Spur) -> tuple[Wave, ...]:
        """Return the waves of the error in the twist [rad]."""
        lever = 0.5 * self.module * cos(self.pressure_angle) * teeth.lever_teeth
        return tuple(
            Wave(order=line.order, amplitude=line.size / lever, phase_key=line.key) for line in self.lines(teeth)
        )

    def _stiffness(self, teeth: Planetary | Spur) -> tuple[Wave, ...]:
        """Return what the planets leave of the varying of the mesh stiffness [1]."""
        waves = []
        for harmonic, share in enumerate(self.stiffness_variation, start=1):
            order = harmonic * int(teeth.mesh_order_out)
            left = teeth.torque_share(order, self.planet_shares) if isinstance(teeth, Planetary) else 1.0
            if share * left > SMALLEST_SHARE:
                waves.append(Wave(order=order, amplitude=share * left, phase_key=f"{self.name}.k{harmonic}"))
        return tuple(waves)

    def lines(self, teeth: Planetary | Spur) -> tuple[MeshLine, ...]:
        """Return the lines that the planets leave, with their sizes along the line of action [m]."""
        drawn = (*self._mesh_lines(teeth), *self._wheel_lines(teeth))
        return tuple(line for line in drawn if line.size > 0)

    def _mesh_lines(self, teeth: Planetary | Spur) -> Iterator[MeshLine]:
        for harmonic, error in enumerate(self.tooth_error, start=1):
            order, key = harmonic * int(teeth.mesh_order_out), f"{self.name}.{harmonic}"
            sides = [(f"mesh {harmonic}", order, error)]
            for turn, share in enumerate(self.position_modulation, start=1):
                sides += [
                    (f"mesh {harmonic} {way * turn:+d}", order + way * turn, 0.5 * share * error) for way in (-1, 1)
                ]
            for cause, at, size in sides:
                left = teeth.torque_share(at, self.planet_shares) if isinstance(teeth, Planetary) else 1.0
                yield MeshLine(cause, float(at), size * left if left > SMALLEST_SHARE else 0.0, key)

    def _wheel_lines(self, teeth: Planetary | Spur) -> Iterator[MeshLine]:
        wheels = (("pinion", teeth.ratio, self.pinion_eccentricity), ("wheel", 1.0, self.wheel_eccentricity))
        for wheel, turns, off in wheels:
            yield MeshLine(wheel, turns, off, f"{self.name}.{wheel}")
            for harmonic, error in enumerate(self.tooth_error, start=1):
                size, order = error * harmonic * off / self.module, harmonic * teeth.mesh_order_out
                for way, sign in ((-1, "-"), (1, "+")):
                    key = f"{self.name}.{harmonic}.{wheel}"
                    yield MeshLine(f"mesh {harmonic} {sign} {wheel}", order + way * turns, size, key)

    def _teeth(self, rig: Rig) -> Planetary | Spur:
        stage = gear_stage(rig, self.gear, owner=self.name)
        if len(stage.teeth) != 1 or not isinstance(stage.teeth[0], Planetary | Spur):
            raise InputError(
                f"{self.name}: {self.gear} states no teeth, or those of several stages; write teeth of one stage, such "
                "as {sun: 21, ring: 84, planets: 3}, and each further stage as a separate gear"
            )
        return stage.teeth[0]
