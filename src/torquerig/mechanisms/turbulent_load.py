"""Turbulent load: a resistance in proportion to the speed or its square, with turbulence around it."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sqrt
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.leading_part import leading_part
from torquerig.rig.terms import Friction, Load, Term


@dataclass(frozen=True, kw_only=True)
class TurbulentLoad(Part):
    """``T = a w + b w |w| + (a w0 + b w0^2) s(t)`` against the shaft of ``at``: a mixer, pump, fan or propeller.

    The mean follows the speed w at every instant. s is Gaussian, of relative rms ``turbulence``, with the one-sided
    density ``2 turbulence^2 / (pi fc) / (1 + (f/fc)^2)``, fc the ``turbulence_cutoff``: it falls by 20 dB a decade
    above. w0 is the set-point of the run (the largest of a profile) at that shaft.

    Source: similarity of flow at constant drag coefficient (b), Stokes flow (a); the density is Dryden's
    longitudinal one (MIL-F-8785C, 1980). Not true for turbulence during ramps, whose rms stays that of w0, nor for
    gusts so strong that the flow turns back (turbulence above about 0.3).
    """

    acts_from_outside: ClassVar[bool] = True

    kind: Literal["turbulent_load"] = "turbulent_load"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    linear: Annotated[float, Parameter("N*m*s/rad", "resistance in proportion to the speed (a)", low=0)] = 0.0
    quadratic: Annotated[float, Parameter("N*m*s^2/rad^2", "resistance by the speed's square (b)", low=0)] = 0.0
    turbulence: Annotated[float, Parameter("1", "rms of the variation as a share of the mean", low=0, high=1)] = 0.0
    turbulence_cutoff: Annotated[float, Parameter("Hz", "frequency above which it falls", above=0)] | None = None

    def __post_init__(self) -> None:
        if self.turbulence and self.turbulence_cutoff is None:
            raise ValueError("turbulence needs its spectrum; add turbulence_cutoff:, such as 2 Hz")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the resistance, and the turbulence around it."""
        node = rig.node(self.at)
        mean = Friction(name=self.name, on=node, viscous=self.linear, quadratic=self.quadratic)
        leader = leading_part(rig)
        if not self.turbulence or self.turbulence_cutoff is None or leader is None or not rig.run.speed:
            return (mean,)
        speed = abs(rig.run.speed * rig.speed_ratios(rig.node(leader)).get(node, 0.0))
        torque = self.linear * speed + self.quadratic * speed**2
        process = Turbulence(rms=self.turbulence * torque, cutoff=self.turbulence_cutoff)
        return mean, Load(name=self.name, on=node, process=process)


@dataclass(frozen=True, kw_only=True)
class Turbulence:
    """Gaussian torque of first-order spectrum around zero; see TurbulentLoad."""

    rms: float
    cutoff: float
    mean: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return ``count`` samples [N m] at ``rate`` [Hz], exact at any rate and stationary from the first one on."""
        from scipy.signal import lfilter

        kept = exp(-2 * pi * self.cutoff / rate)
        kicks = sqrt(1 - kept**2) * rng.standard_normal(count)
        kicks[:1] /= sqrt(1 - kept**2)
        return np.asarray(self.rms * lfilter([1.0], [1.0, -kept], kicks))

    def density(self, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the one-sided spectral density [(N m)^2/Hz] at ``frequencies`` [Hz]."""
        return np.asarray(2 * self.rms**2 / (pi * self.cutoff) / (1 + (frequencies / self.cutoff) ** 2))
