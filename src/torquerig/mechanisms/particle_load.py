"""The particle bed on the wear part: a mean by occupancy, hits, and slow variation."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sqrt
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.mean_by_occupancy import mean_at, refuse_empty
from torquerig.rig.terms import Load, Term
from torquerig.sensor_stages.coloured_noise import low_passed_noise

Torque = Annotated[float, Parameter("N*m", "mean load torque", low=0)]
REFERENCE_SIZE = 0.5e-3  # [m] particle size at which the rate and the pulse of the reference rig are stated


@dataclass(frozen=True, kw_only=True)
class ParticleLoad(Part):
    """``mean(occupancy) + hits + slow variation``, never negative, opposing the motion of the shaft of ``at``.

    Hits arrive as a Poisson process of rate ``60 (0.5 mm / d)^1.5 (0.3 + occupancy/10 %)`` 1/s; each is a pulse
    ``a exp(-t / tau)`` with ``tau = 4 ms sqrt(d / 0.5 mm)`` and gamma-distributed a. By Campbell's theorem such shot
    noise has variance ``rate E[a^2] tau / 2``; it is scaled so that its rms is ``hit_rms`` of the mean, and its own
    mean is taken out. The slow variation is white noise through a second-order Butterworth low-pass.

    The mean by occupancy and ``hit_rms`` are measured ones. Free particles would come with a rate as speed over d^3 and
    hits as d^3 (signatures.md 5.1); the reference rig's exponents are weaker and do not know the speed, because a
    blade meets many grains at once. Either way larger grains mean fewer and longer hits.

    Where ``hit_rise`` is stated the pulses are ``(exp(-t/tau) - exp(-t/rise))``: grains that give way, not stones.

    Source: the reference rig; Campbell's theorem as in Rice 1944, Bell System Technical Journal 23, section 1.2.
    Not valid for dense beds, whose drag is rate-invariant (Miller, O'Hern & Behringer 1996, PRL 77).
    """

    kind: Literal["particle_load"] = "particle_load"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    mean_by_occupancy_percent: dict[float, Torque]
    hit_rate: Annotated[float, Parameter("1/s", "hits per second at 0.5 mm and factor 1", above=0)] = 60.0
    hit_decay: Annotated[float, Parameter("s", "pulse decay at 0.5 mm", above=0)] = 0.004
    hit_rise: Annotated[float, Parameter("s", "time over which a pulse rises; 0: at once", low=0)] = 0.0
    hit_shape: Annotated[float, Parameter("1", "shape of the gamma distribution of hits", above=0)] = 1.5
    hit_rms: Annotated[float, Parameter("1", "rms of the hits as a share of the mean", low=0)] = 0.10
    slow_rms: Annotated[float, Parameter("1", "rms of the slow variation as a share of the mean", low=0)] = 0.06
    slow_cutoff: Annotated[float, Parameter("Hz", "low-pass of the slow variation", above=0)] = 1.5
    smoothing: Annotated[float, Parameter("rad/s", "speed over which the direction turns", above=0)] = 0.02

    def __post_init__(self) -> None:
        refuse_empty(self.mean_by_occupancy_percent)

    def mean(self, occupancy_percent: float) -> float:
        """Return the mean torque [N m], linear between the stated occupancies; outside them it is refused."""
        return mean_at(occupancy_percent, self.mean_by_occupancy_percent, name=self.name)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the load of the run's occupancy and particle size."""
        occupancy = rig.run.occupancy_percent or 0.0
        size = (rig.run.particle_size or REFERENCE_SIZE) / REFERENCE_SIZE
        process = ParticleProcess(
            mean=self.mean(occupancy),
            rate=self.hit_rate * size**-1.5 * (0.3 + occupancy / 10),
            decay=self.hit_decay * sqrt(size),
            rise=self.hit_rise,
            shape=self.hit_shape,
            hit_rms=self.hit_rms,
            slow_rms=self.slow_rms,
            slow_cutoff=self.slow_cutoff,
        )
        return (Load(name=self.name, on=rig.node(self.at), process=process, smoothing=self.smoothing),)


@dataclass(frozen=True, kw_only=True)
class ParticleProcess:
    """The random torque of one operating point; see ParticleLoad for the equations."""

    mean: float
    rate: float
    decay: float
    shape: float
    hit_rms: float
    slow_rms: float
    slow_cutoff: float
    rise: float = 0.0

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return ``count`` samples [N m] at ``rate`` [Hz]; the process is stationary from the first sample on."""
        from scipy.signal import lfilter

        warm = int(10 * (self.decay + self.rise) * rate) + 1
        arrivals = rng.poisson(self.rate / rate, count + warm)
        kicks = np.zeros(count + warm)
        hit = np.flatnonzero(arrivals)
        kicks[hit] = rng.gamma(self.shape * arrivals[hit])  # a sum of n gamma variates of one scale is gamma(n shape)
        fall = exp(-1 / (rate * self.decay))
        rise = exp(-1 / (rate * self.rise)) if self.rise else 0.0
        recursion = [1.0, -(fall + rise), fall * rise] if rise else [1.0, -fall]
        pulses = lfilter([1.0], recursion, kicks)[warm:]
        mean_square = self.shape * (self.shape + 1)  # E[a^2] of a gamma variate of scale 1
        # sum and sum of squares of the pulse's samples, two geometric series
        squares = (1 + fall * rise) / ((1 - fall * rise) * (1 - fall**2) * (1 - rise**2))
        deviation = sqrt(self.rate / rate * mean_square * squares)
        expected = self.rate / rate * self.shape / ((1 - fall) * (1 - rise))
        hits = (pulses - expected) / deviation * self.hit_rms
        slow = self.slow_rms * low_passed_noise(count, rate, self.slow_cutoff, rng)
        return np.asarray(np.maximum(0.0, self.mean * (1 + hits + slow)))

    @property
    def clumping(self) -> float:
        """Variance that few hits leave in the logarithm of the power in a time T, times T [s].

        ``E[a^4] / (r E[a^2]^2)``, from the fourth cumulant of shot noise of the rate r (Campbell's theorem); it is
        common to all frequencies.
        """
        return (self.shape + 2) * (self.shape + 3) / (self.shape * (self.shape + 1) * self.rate)

    def density(self, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the one-sided spectral density [(N m)^2/Hz] at ``frequencies`` [Hz], the mean left out.

        The hits' is a Lorentz curve, with a second one where pulses take time to rise (Campbell's theorem), the slow
        part's that of a second-order Butterworth low-pass; never being negative is left out.
        """
        turned = 2 * pi * frequencies
        hits = 4 * (self.decay + self.rise) * self.hit_rms**2 / (1 + (turned * self.decay) ** 2)
        hits = hits / (1 + (turned * self.rise) ** 2)
        return np.asarray(self.mean**2 * (hits + self._slow_density(frequencies)))

    def _slow_density(self, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
        noise_bandwidth = self.slow_cutoff * pi / (2 * sqrt(2))
        return np.asarray(self.slow_rms**2 / noise_bandwidth / (1 + (frequencies / self.slow_cutoff) ** 4))

    def shaped_densities(self, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the same density with hits of other courses, shape (courses, *frequencies.shape).

        Half a sine of the length ``pi d / 2`` and a straight fall of the length ``2 d``, d the decay: both have the
        impulse of the exponential decay, and here its rms. A pulse of finite length has zeros in its spectrum (any
        table of Fourier transforms; Bracewell 2000, *The Fourier Transform and Its Applications*).
        """
        turned = 2 * pi * np.maximum(frequencies, 1e-9 / self.decay) * self.decay
        half = 0.25 * pi * (np.sinc(0.25 * turned - 0.5) + np.sinc(0.25 * turned + 0.5))
        fall = (1 - (1 - np.exp(-2j * turned)) / (2j * turned)) / turned
        energies = (0.25 * pi, 2 / 3)  # of each pulse over its decay; that of the exponential one is 1/2
        hits = [2 * self.decay / energy * np.abs(one) ** 2 for one, energy in zip((half, fall), energies, strict=True)]
        slow = self._slow_density(frequencies)
        return np.asarray(self.mean**2 * np.array([self.hit_rms**2 * each + slow for each in hits]))
