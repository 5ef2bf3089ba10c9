"""Ringing: impacts of a damaged rolling bearing in the reading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Ringing:
    """T += sum_k A_k exp(-2 pi zeta f (t - t_k)) sin(2 pi f (t - t_k)), an impact t_k each 1/order of a turn.

    The moments come from the true angle, between samples too, in either direction of turning.

    Parameters
    ----------
    order : float
        Impacts per turn of the shaft [1/rev], > 0.
    frequency : float
        f of the mode that rings [Hz], > 0 and below half the sample rate.
    damping : float
        zeta, decay per radian of ringing [1], > 0.
    amplitude : float
        A [N m at the sensor], >= 0.
    slip : float
        Relative standard deviation of the angle between impacts [1], 0 to 0.2; it adds up from one to the next.
    load_zone : float
        m: A_k = A (1 + m cos(theta - theta_0)), the load zone passing once a turn [1], 0 to 1.
    turns : float
        Turns of the shaft per turn of ``angle`` [1].
    angle : str
        Name of the channel with the true angle.
    source : str
        Name of the cause, which determines the random first angle, load zone and slip.

    Notes
    -----
    Source: handbook 3.8 (Randall & Antoni 2011, MSSP 25(2): impacts, a resonance, slip of 1 to 2 %). The mode is
    local: its effect on the shafts' motion is not modelled.
    """

    order: float
    frequency: float
    damping: float
    amplitude: float
    slip: float = 0.0
    load_zone: float = 0.0
    turns: float = 1.0
    angle: str = "true_motor_angle_rad"
    source: str = "bearing"

    def __post_init__(self) -> None:
        if not (self.order > 0 and self.frequency > 0 and self.damping > 0 and self.amplitude >= 0):
            raise InputError(
                f"impacts of order {self.order}, {self.frequency} Hz, damping {self.damping} and amplitude "
                f"{self.amplitude} N*m cannot be; all must be above 0, the amplitude 0 or more"
            )
        if not (0 <= self.slip <= 0.2 and 0 <= self.load_zone <= 1):
            raise InputError(
                f"impacts with slip {self.slip} and load zone {self.load_zone} cannot be; write 0..0.2 and 0..1"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the ringing on its torque channel."""
        if self.amplitude == 0:
            return recording
        if not self.frequency < 0.5 * recording.sample_rate:
            raise InputError(
                f"{self.source}: a mode of {self.frequency:g} Hz cannot be sampled at {recording.sample_rate:g} Hz; "
                "raise the sample rate above twice its frequency"
            )
        from scipy.signal import lfilter

        name = recording.torque_name()
        channel = recording.channels[name]
        pole = 2 * np.pi * self.frequency * (1j - self.damping)
        kicks = np.zeros(recording.samples, dtype=np.complex128)
        rows, since, strength = self._impacts(recording)
        np.add.at(kicks, rows, strength * np.exp(pole * since / recording.sample_rate))
        # the exact recursion of a decaying rotation; its imaginary part is the decaying sine
        ring = lfilter([1.0], [1.0, -np.exp(pole / recording.sample_rate)], kicks).imag
        return recording.with_values(name, channel.values + ring / channel.si_per_unit)

    def density(self, frequencies: NDArray[np.float64], impacts: float) -> NDArray[np.float64]:
        """Return the one-sided density [(N m)^2/Hz] that ``impacts`` per second leave, averaged over their comb.

        ``2 impacts |R(f)|^2`` with R the transform of one ring, ``A w0 / ((i w + zeta w0)^2 + w0^2)``. True for bands
        wider than the rate of the impacts; slip smears the comb and leaves the average.
        """
        own, w = 2 * np.pi * self.frequency, 2 * np.pi * frequencies
        ring = own / ((1j * w + self.damping * own) ** 2 + own**2)
        return np.asarray(self._struck_power(impacts) * np.abs(ring) ** 2)

    def density_between(
        self, low: NDArray[np.float64], high: NDArray[np.float64], impacts: float
    ) -> NDArray[np.float64]:
        """Return the mean of ``density`` between frequencies ``low`` and ``high`` [Hz], of which it is the integral.

        With the pole ``p = w0 (1 + i zeta)``, ``|R|^2 = A^2 Im(1 / (w^2 - p^2)) / (2 zeta)``, whose integral over w is
        ``Im(log((w - p) / (w + p)) / 2 p)``.
        """
        own = 2 * np.pi * self.frequency
        pole = own * (1 + 1j * self.damping)

        def up_to(frequency: NDArray[np.float64]) -> NDArray[np.float64]:
            w = 2 * np.pi * frequency
            return np.asarray(((np.log(w - pole) - np.log(w + pole)) / (2 * pole)).imag)

        across = (up_to(high) - up_to(low)) / (2 * np.pi * (high - low))
        return np.asarray(self._struck_power(impacts) * across / (2 * self.damping))

    def _struck_power(self, impacts: float) -> float:
        return 2 * impacts * (1 + 0.5 * self.load_zone**2) * self.amplitude**2

    def _impacts(self, recording: Recording) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """Return of each impact the first sample after it, the time since it [samples], and its strength [N m]."""
        rng = recording.random(f"impacts {self.source}")
        way = recording.channel(self.angle).in_si() * self.turns * self.order / (2 * np.pi)
        start, zone = way.min() - rng.uniform(), rng.uniform(0, 2 * np.pi)
        count = int((way.max() - start) * (1 + 2 * self.slip)) + 16
        ways = start + np.cumsum(np.maximum(0.2, 1 + self.slip * rng.standard_normal(count)))
        passed = np.searchsorted(ways, way)
        rows = np.flatnonzero(np.diff(passed)) + 1
        met = ways[np.minimum(passed[rows - 1], passed[rows])]
        since = (way[rows] - met) / (way[rows] - way[rows - 1])
        strength = self.amplitude * (1 + self.load_zone * np.cos(2 * np.pi * met / self.order - zone))
        return rows, since, strength
