"""Eccentricity: a rotor off the centre of its stator unbalances the pull of the teeth."""

from __future__ import annotations

from dataclasses import dataclass
from math import lcm, pi
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

SMALLEST_LINE = 1e-4  # lines below this share of one tooth's torque are left out


@dataclass(frozen=True, kw_only=True)
class Eccentricity(Part):
    """Cogging lines of teeth that pull unequally and so do not cancel, in addition to the native cogging.

    Tooth i at a_i = 2 pi i / Q pulls with ``A (sin 2p(theta - a_i) + h sin 4p(theta - a_i)) / g_i^2``, because B^2
    goes with the inverse square of the gap ``g_i = 1 - s cos(a_i) - d cos(a_i - theta)``: s static, d dynamic
    eccentricity. The sum over the teeth, less the one without eccentricity, is taken apart into whole motor orders.
    Static eccentricity gives multiples of 2p, dynamic ones of Q, both together side lines of these. With m the
    distance of 2p from the nearest multiple of Q, order 2p has ``Q A (m + 1) (s/2)^m`` for small s: 9 s A for 9 slots
    and 8 magnets, 9 s^2 A for 12 and 14.

    Source: signatures.md 1.6 (Zhu, Wu & Mohd Jamil 2014, IEEE Trans. Industry Applications 50(5)) for the orders. The
    gap is the magnetic one, magnets included: air gap plus magnet height over its relative permeability. Offsets are
    stated as shares of it, or as lengths together with it. ``tooth_torque`` is measured or computed for one tooth.
    Not valid where iron saturates. Phases are drawn: the direction of the offset relative to the magnets is unknown.
    """

    kind: Literal["eccentricity"] = "eccentricity"
    group: Literal["cogging"] = "cogging"
    at: str = "motor"
    slots: int
    pole_pairs: int
    tooth_torque: Annotated[float, Parameter("N*m", "cogging torque of a single tooth, zero to peak", low=0)]
    second_harmonic: Annotated[float, Parameter("1", "its second harmonic, as a share", low=0, high=1)] = 0.25
    static: Annotated[float, Parameter("1", "static offset, as a share of the magnetic gap", low=0, high=0.5)] = 0.0
    dynamic: Annotated[float, Parameter("1", "dynamic offset, as a share of the magnetic gap", low=0, high=0.4)] = 0.0
    magnetic_gap: Annotated[float, Parameter("m", "magnetic gap, magnets included", above=0)] | None = None
    static_offset: Annotated[float, Parameter("m", "rotor's axis off the stator's centre", low=0)] = 0.0
    dynamic_offset: Annotated[float, Parameter("m", "rotor's centre off its axis", low=0)] = 0.0

    def __post_init__(self) -> None:
        if self.slots < 1 or self.pole_pairs < 1:
            raise ValueError(
                f"{self.slots} slots and {self.pole_pairs} pole pairs are not possible; both are at least 1"
            )
        if (self.static_offset or self.dynamic_offset) and self.magnetic_gap is None:
            raise ValueError("an offset as a length needs the gap that it narrows; write magnetic_gap, such as 3 mm")
        for name, share, highest in (("static", self.shares[0], 0.5), ("dynamic", self.shares[1], 0.4)):
            if share > highest:
                raise ValueError(
                    f"a {name} eccentricity of {share:.3g} of the gap is out of range; at most {highest:g}"
                )

    @property
    def shares(self) -> tuple[float, float]:
        """Static and dynamic eccentricity as shares of the magnetic gap [1]."""
        gap = self.magnetic_gap or 1.0
        return self.static + self.static_offset / gap, self.dynamic + self.dynamic_offset / gap

    def amplitudes(self) -> dict[int, float]:
        """Return the amplitude [N m] by motor order."""
        highest = 2 * lcm(self.slots, 2 * self.pole_pairs)
        angle = 2 * pi * np.arange(4 * highest) / (4 * highest)
        extra = self._pull(angle, *self.shares) - self._pull(angle, 0.0, 0.0)
        lines = 2 * np.abs(np.fft.rfft(extra)) / angle.size
        return {
            order: self.tooth_torque * float(lines[order])
            for order in range(1, highest + 1)
            if self.tooth_torque * lines[order] > self.tooth_torque * SMALLEST_LINE
        }

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the lines between rotor and frame."""
        node = rig.node(self.at)
        waves = tuple(Wave(order=order, amplitude=amplitude) for order, amplitude in self.amplitudes().items())
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=waves),)

    def _pull(self, angle: NDArray[np.float64], static: float, dynamic: float) -> NDArray[np.float64]:
        """Return the torque of all teeth [of one tooth's amplitude] at rotor angles, shape (angles,)."""
        tooth = 2 * pi * np.arange(self.slots)[:, None] / self.slots
        turned = 2 * self.pole_pairs * (angle - tooth)
        gap = 1 - static * np.cos(tooth) - dynamic * np.cos(tooth - angle)
        return np.asarray(((np.sin(turned) + self.second_harmonic * np.sin(2 * turned)) / gap**2).sum(axis=0))
