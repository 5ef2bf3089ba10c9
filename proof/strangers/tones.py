"""Strangers at a fixed or wandering frequency: torque on the body, or volts, by time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from proof.fleet.effect import Floats, Motion
from proof.fleet.setting import Setting
from proof.strangers.stranger import Stranger, any_phase, burst, load_size


@dataclass(frozen=True)
class Tone(Stranger):
    """A torque of a frequency on the body; kinds differ in its course."""

    domain: ClassVar[str] = "frequency"
    axis: ClassVar[str] = "Hz"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the torque on the body."""
        return {"push_load": self.size * self.wave(motion, rng)}

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the course of unit size."""
        raise NotImplementedError

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw a frequency between 6 Hz and a third of the usable range, away from the mains."""
        highest = min(0.5 * setting.nyquist, 180.0)
        frequency = 50.0
        while min(abs(frequency - mains * k) for mains in (50.0, 60.0) for k in (1, 2, 3)) < 1.5:
            frequency = float(6.0 * (highest / 6.0) ** rng.random())
        size = load_size(rng, setting, frequency)
        return cls(
            part=setting.rig.design.body,
            at=frequency,
            size=size,
            phase=any_phase(rng),
            more=(float(rng.uniform(0.3, 1.2)),),
        )


class AmplitudeModulatedTone(Tone):
    """A tone whose amplitude sways fully at 0.3 to 1.2 Hz."""

    kind: ClassVar[str] = "amplitude_modulated_tone"
    width: ClassVar[float] = 0.03

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the swaying tone."""
        sway = 1.0 + 0.9 * np.cos(2.0 * np.pi * self.more[0] * motion.time)
        return np.asarray(sway * np.cos(2.0 * np.pi * self.at * motion.time + self.phase))


class WanderingTone(Tone):
    """A tone whose frequency wanders by 2 % over seconds."""

    kind: ClassVar[str] = "wandering_tone"
    width: ClassVar[float] = 0.05

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the wandering tone."""
        sway = np.sin(2.0 * np.pi * 0.23 * motion.time + rng.uniform(0, 6.28)) + np.sin(
            2.0 * np.pi * 0.61 * motion.time
        )
        frequency = self.at * (1.0 + 0.01 * sway)
        return np.cos(2.0 * np.pi * np.cumsum(frequency) / motion.rate + self.phase)


class ToneInHalf(Tone):
    """A tone of a neighbour machine that runs during the second half of every recording."""

    kind: ClassVar[str] = "tone_in_half"

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the tone of the second half."""
        on = burst(motion.time, 0.5 * motion.duration, 2.0 * motion.duration)
        return np.asarray(on * np.cos(2.0 * np.pi * self.at * motion.time + self.phase))


class Chirp(Tone):
    """A tone that rises by 40 % during a recording."""

    kind: ClassVar[str] = "chirp"
    width: ClassVar[float] = 0.25

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the rising tone."""
        t = np.clip(motion.time, 0.0, motion.duration)
        return np.cos(2.0 * np.pi * self.at * (0.8 * t + 0.2 * t * t / motion.duration) + self.phase)


class BeatingTones(Tone):
    """Two tones 0.3 to 1.2 Hz apart, as of two asynchronous motors of a neighbour."""

    kind: ClassVar[str] = "beating_tones"
    width: ClassVar[float] = 0.05

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return both tones."""
        second = self.at + self.more[0]
        return np.cos(2.0 * np.pi * self.at * motion.time + self.phase) + np.cos(2.0 * np.pi * second * motion.time)


class WanderingResonance(Tone):
    """Random torque of a narrow band whose middle moves by 10 % to and fro during a recording."""

    kind: ClassVar[str] = "wandering_resonance"
    width: ClassVar[float] = 0.2

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return band noise on a moving middle: two slow random amplitudes on a swaying carrier."""
        points = int((motion.time[-1] - motion.time[0]) * 40.0) + 2
        keep = np.exp(-2.0 * np.pi * 0.02 * self.at / 40.0)
        kicks = rng.standard_normal((2, points))
        slow = np.zeros((2, points))
        for i in range(1, points):
            slow[:, i] = keep * slow[:, i - 1] + np.sqrt(1.0 - keep**2) * kicks[:, i]
        grid = np.linspace(motion.time[0], motion.time[-1], points)
        first, second = (np.interp(motion.time, grid, row) for row in slow)
        sway = self.at * (1.0 + 0.1 * np.sin(2.0 * np.pi * motion.time / motion.duration))
        carrier = 2.0 * np.pi * np.cumsum(sway) / motion.rate
        return np.asarray(first * np.cos(carrier) + second * np.sin(carrier))


class LoadSwell(Tone):
    """A load that swells at a fixed frequency, in proportion to the torque of the run."""

    kind: ClassVar[str] = "load_swell"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the swell of the load."""
        mean = float(np.mean(motion.torque))
        return {"push_load": -self.size * mean * np.cos(2.0 * np.pi * self.at * motion.time + self.phase)}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw 0.7 to 4 Hz and 1 to 20 % of the mean."""
        frequency = float(rng.uniform(0.7, 4.0))
        return cls(
            part=setting.rig.design.body,
            at=frequency,
            size=float(10.0 ** rng.uniform(-2.0, -0.7)),
            phase=any_phase(rng),
        )


class OffsetLine(Tone):
    """A line that is always a few hertz above three times the output speed, as of a neighbour motor with slip."""

    kind: ClassVar[str] = "offset_line"
    width: ClassVar[float] = 0.03

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the line."""
        offset = self.at - self.more[0]
        return np.cos(3.0 * motion.output_angle + 2.0 * np.pi * offset * motion.time + self.phase)

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw an offset of 2.2 to 7 Hz; the place is that of the fastest run."""
        shaft = 3.0 * setting.rotation()
        frequency = shaft + float(rng.uniform(2.2, 7.0))
        if frequency > 0.8 * setting.nyquist:
            return None
        size = load_size(rng, setting, frequency)
        return cls(part=setting.rig.design.body, at=frequency, size=size, phase=any_phase(rng), more=(shaft,))


class RootSpeedLine(Tone):
    """A line whose frequency grows with the root of the speed, as of a liquid that sloshes."""

    kind: ClassVar[str] = "root_speed_line"
    width: ClassVar[float] = 0.03

    def wave(self, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the line."""
        share = np.sqrt(np.abs(motion.output_speed) / self.more[0])
        return np.cos(2.0 * np.pi * np.cumsum(self.at * share) / motion.rate + self.phase)

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw 5 to 40 Hz at the highest speed."""
        frequency = float(rng.uniform(5.0, min(40.0, 0.5 * setting.nyquist)))
        size = load_size(rng, setting, frequency)
        return cls(
            part=setting.rig.design.body, at=frequency, size=size, phase=any_phase(rng), more=(setting.output_speed,)
        )
