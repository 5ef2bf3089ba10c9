"""Granular drag: the drag of a dense bed of particles depends on the angle of the wear part, not on its speed."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.mean_by_occupancy import mean_at, refuse_empty
from torquerig.rig.terms import AngleLoad, Term

Torque = Annotated[float, Parameter("N*m", "mean load torque", low=0)]
REFERENCE_SIZE = 0.5e-3  # [m] particle size at which the correlation angle is stated
POINTS_PER_TURN = 2048
TURNS = 64  # period of the bed in turns


@dataclass(frozen=True, kw_only=True)
class GranularDrag(Part):
    """``T(theta) = mean(occupancy) (1 + rms x(theta))``, never negative, opposing the motion of the shaft of ``at``.

    x is Gaussian with the spectrum ``1 / (1 + (k c)^2)`` over the angle (k in 1/rad): force chains build up and break
    within the correlation angle c, which grows as the particle size. The trace over the angle is the same at any speed;
    over time its spectrum falls with the square of the frequency and its corner moves with the speed.

    Source: Miller, O'Hern & Behringer 1996, Phys. Rev. Lett. 77(15): stresses of slowly sheared grains, rate-invariant,
    spectra falling as the square. Not valid for thin or fast beds, where grains fly (particle_load), nor beyond 64
    turns, after which the same bed comes again.
    """

    kind: Literal["granular_drag"] = "granular_drag"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    mean_by_occupancy_percent: dict[float, Torque]
    rms: Annotated[float, Parameter("1", "rms of the variation as a share of the mean", low=0)] = 0.1
    correlation_angle: Annotated[float, Parameter("rad", "correlation angle at 0.5 mm", above=0)] = 0.05
    smoothing: Annotated[float, Parameter("rad/s", "speed over which the direction turns", above=0)] = 0.02

    def __post_init__(self) -> None:
        refuse_empty(self.mean_by_occupancy_percent)

    def mean(self, occupancy_percent: float) -> float:
        """Return the mean torque [N m], linear between the stated occupancies; outside them it is refused."""
        return mean_at(occupancy_percent, self.mean_by_occupancy_percent, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the load of the run's occupancy and particle size; none of zero size."""
        mean = self.mean(rig.run.occupancy_percent or 0.0)
        size = (rig.run.particle_size or REFERENCE_SIZE) / REFERENCE_SIZE
        if mean == 0:
            return ()
        process = GranularProcess(mean=mean, rms=self.rms, correlation_angle=size * self.correlation_angle)
        return (AngleLoad(name=self.name, on=rig.node(self.at), process=process, smoothing=self.smoothing),)


@dataclass(frozen=True, kw_only=True)
class GranularProcess:
    """The torque over the angle at one operating point; see GranularDrag."""

    mean: float
    rms: float
    correlation_angle: float
    points_per_turn: int = POINTS_PER_TURN

    def sample(self, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return the torque [N m] over 64 turns, whose end joins their beginning."""
        count = TURNS * self.points_per_turn
        k = 2 * pi * np.fft.rfftfreq(count, 2 * pi / self.points_per_turn)
        shape = 1 / np.sqrt(1 + (k * self.correlation_angle) ** 2)
        shape[0] = 0.0  # the mean is stated
        power = 2 * (shape**2).sum() - shape[-1] ** 2  # of a real signal: every line but the last has its mirror
        x = np.fft.irfft(np.fft.rfft(rng.standard_normal(count)) * shape, count) / np.sqrt(power / count)
        return np.asarray(self.mean * np.maximum(0.0, 1 + self.rms * x))
