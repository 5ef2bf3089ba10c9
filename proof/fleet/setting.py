"""What the draw of an effect needs to know of a rig: its train, runs and signal level."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from proof.fleet.recording import record, train_with
from proof.fleet.rig import FleetRig
from proof.fleet.scale import RPM
from proof.fleet.train import Train

LEAST_LINE = 5e-4  # of the rated torque; smaller lines lie below a sensor's accuracy


@dataclass(frozen=True)
class Setting:
    """A rig without effects and its level.

    Parameters
    ----------
    level : float
        Rms of the sensed torque around its mean, in the first run [N m].
    volts_per_Nm : float
        Sensitivity.
    """

    rig: FleetRig
    train: Train
    level: float
    volts_per_Nm: float  # noqa: N815 (the unit)
    mean: float

    @property
    def torque(self) -> float:
        """Rated torque [N m]."""
        return self.rig.design.scale.torque

    @property
    def output_speed(self) -> float:
        """Output speed of the fastest run [rad/s]."""
        return max(run.speed for run in self.rig.runs) / abs(self.rig.design.ratio)

    @property
    def nyquist(self) -> float:
        """Half the sample rate [Hz]."""
        return 0.5 * self.rig.design.sample_rate

    @property
    def bandwidth(self) -> float:
        """Stated bandwidth of the amplifier [Hz]."""
        return float(self.rig.design.parts[self.rig.design.sensor]["bandwidth"].split()[0])

    @property
    def noise(self) -> float:
        """Stated rms of the sensor noise [V]."""
        return float(self.rig.design.parts[self.rig.design.sensor]["noise_rms"].value)

    def rotation(self, turns: float = 1.0) -> float:
        """Return the rotation frequency [Hz] of a shaft that turns so often per output turn, in the fastest run."""
        return self.output_speed / (60.0 * RPM) * turns

    def line_size(self, rng: np.random.Generator) -> float:
        """Draw the size of a line at the sensor [N m]: from a hundredth of the torque's variation to twice it."""
        return float(max(self.level * 10.0 ** rng.uniform(-2.0, 0.3), LEAST_LINE * self.torque))


def setting_of(rig: FleetRig) -> Setting:
    """Return the setting of a rig without effects."""
    train = train_with(rig, ())
    one = record(rig, 0, effects=())
    per_volt = float(rig.design.parts[rig.design.sensor]["sensitivity"].split()[0])
    volts = one.volts
    if rig.runs[0].profile != "steady":  # the level without the slow course of a ramp
        width = max(int(0.1 * rig.design.sample_rate), 2)
        volts = volts - np.convolve(volts, np.ones(width) / width, mode="same")
        volts = volts[width:-width]
    return Setting(rig, train, float(np.std(volts)) / per_volt, per_volt, one.mean_torque)
