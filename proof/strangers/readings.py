"""Strangers of the reading: courses of zero and gain, spikes of a foreign clock, lost samples, echo, angle errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from proof.fleet.effect import Floats
from proof.fleet.setting import Setting
from proof.strangers.stranger import Stranger, any_phase


@dataclass(frozen=True)
class ZeroCourse(Stranger):
    """Volts that are added to the reading; ``at`` is the time [s] of the change in the longest run."""

    domain: ClassVar[str] = "time"
    axis: ClassVar[str] = "s"
    width: ClassVar[float] = 0.1
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "signal"

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw a change of 1 to 15 % of the rated torque between 40 and 60 % of the recording."""
        length = max(run.duration for run in setting.rig.runs)
        size = setting.torque * float(10.0 ** rng.uniform(-2.0, -0.8)) * setting.volts_per_Nm
        return cls(part=setting.rig.design.sensor, at=length * float(rng.uniform(0.4, 0.6)), size=size,
                   more=(length,))  # fmt: skip


class LevelKink(ZeroCourse):
    """A zero that rests and then runs away on a straight line."""

    kind: ClassVar[str] = "level_kink"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the run-away."""
        share = self.at / self.more[0] * time[-1]
        return np.asarray(volts + self.size * np.maximum(time - share, 0.0) / (time[-1] - share))


class LevelStep(ZeroCourse):
    """A zero that jumps once in every recording."""

    kind: ClassVar[str] = "level_step"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the jump."""
        return np.asarray(volts + self.size * (time > self.at / self.more[0] * time[-1]))


class Telegraph(ZeroCourse):
    """A zero that flips between two levels at random instants, about twice a second: a bad contact."""

    kind: ClassVar[str] = "telegraph"
    domain: ClassVar[str] = "distribution"
    axis: ClassVar[str] = "V"
    width: ClassVar[float] = 1.0

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the flips."""
        flips = rng.random(time.size) < 2.0 * time[1]
        return volts + self.size * (np.cumsum(flips) % 2)


class Thermostat(ZeroCourse):
    """A zero that saws with a heater's period of 1.5 to 4 s."""

    kind: ClassVar[str] = "thermostat"
    domain: ClassVar[str] = "frequency"
    axis: ClassVar[str] = "Hz"
    width: ClassVar[float] = 0.05

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the saw."""
        return np.asarray(volts + self.size * np.mod(time * self.at + self.phase, 1.0))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw period and size."""
        size = setting.torque * float(10.0 ** rng.uniform(-2.0, -0.8)) * setting.volts_per_Nm
        return cls(
            part=setting.rig.design.sensor, at=1.0 / float(rng.uniform(1.5, 4.0)), size=size, phase=float(rng.random())
        )


class GainWarmsUp(ZeroCourse):
    """A gain that changes exponentially with temperature, in every recording anew; ``at`` is its time constant [s]."""

    kind: ClassVar[str] = "gain_warms_up"
    width: ClassVar[float] = 1.0

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Change the gain."""
        return np.asarray(volts * (1.0 + self.size * (1.0 - np.exp(-time / self.at))))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw 2 to 25 % and a time constant of a sixth to a half of the recording."""
        length = max(run.duration for run in setting.rig.runs)
        size = float(10.0 ** rng.uniform(-1.7, -0.6) * rng.choice([-1.0, 1.0]))
        return cls(part=setting.rig.design.sensor, at=length * float(rng.uniform(0.17, 0.5)), size=size)


class GainStep(ZeroCourse):
    """A gain that jumps once in every recording."""

    kind: ClassVar[str] = "gain_step"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Change the gain."""
        return np.asarray(volts * (1.0 + self.size * (time > self.at / self.more[0] * time[-1])))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw 3 to 30 %."""
        length = max(run.duration for run in setting.rig.runs)
        return cls(part=setting.rig.design.sensor, at=length * float(rng.uniform(0.35, 0.65)),
                   size=float(10.0 ** rng.uniform(-1.5, -0.5)), more=(length,))  # fmt: skip


class ForeignClockSpikes(Stranger):
    """Spikes of a millisecond locked to a foreign clock of 3 to 17 Hz."""

    kind: ClassVar[str] = "foreign_clock_spikes"
    domain: ClassVar[str] = "frequency"
    axis: ClassVar[str] = "Hz"
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "signal"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the spikes, at least one sample long."""
        place = np.mod(time * self.at + self.phase, 1.0)
        return np.asarray(volts + self.size * (place < max(1e-3, 1.01 * time[1]) * self.at))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw clock and height: half to ten times the torque's variation."""
        size = setting.level * float(10.0 ** rng.uniform(-0.3, 1.0)) * setting.volts_per_Nm
        return cls(
            part=setting.rig.design.sensor, at=float(rng.uniform(3.0, 17.0)), size=size, phase=float(rng.random())
        )


class Echo(Stranger):
    """A share of the reading that comes once more after 5 to 40 ms."""

    kind: ClassVar[str] = "echo"
    domain: ClassVar[str] = "frequency"
    axis: ClassVar[str] = "Hz"
    width: ClassVar[float] = 1.0
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "signal"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the echo; the mean stays."""
        late = max(round(1.0 / self.at / time[1]), 1)
        echo = np.concatenate([np.full(late, volts[0]), volts[:-late]])
        return np.asarray(volts + self.size * (echo - np.mean(volts)))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw delay and share; the place is one over the delay."""
        return cls(
            part=setting.rig.design.sensor, at=1.0 / float(rng.uniform(0.005, 0.04)), size=float(rng.uniform(0.15, 0.6))
        )


class LostSamples(Stranger):
    """A recorder that loses 10 to 60 ms of all channels once in a recording, so that time jumps."""

    kind: ClassVar[str] = "lost_samples"
    domain: ClassVar[str] = "time"
    axis: ClassVar[str] = "s"
    width: ClassVar[float] = 0.1
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "signal"

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Shift what follows; the last samples are repeated backwards."""
        return self._jumped(volts, time)

    def on_angle(self, angle: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Shift the angle likewise; it goes on with its last speed."""
        lost = self._lost(time)
        more = angle[-1] + (angle[-1] - angle[-2]) * np.arange(1, lost + 1)
        return np.asarray(np.concatenate([angle, more])[self._index(time)])

    def _lost(self, time: Floats) -> int:
        return max(round(float(self.size / time[1])), 2)

    def _index(self, time: Floats) -> Any:
        start = int(self.at / self.more[0] * time.size)
        return np.arange(time.size) + np.where(np.arange(time.size) < start, 0, self._lost(time))

    def _jumped(self, volts: Floats, time: Floats) -> Floats:
        lost = self._lost(time)
        return np.asarray(np.concatenate([volts, volts[-lost:][::-1]])[self._index(time)])

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw instant and length."""
        length = max(run.duration for run in setting.rig.runs)
        return cls(part=setting.rig.design.sensor, at=length * float(rng.uniform(0.35, 0.65)),
                   size=float(rng.uniform(0.01, 0.06)), more=(length,))  # fmt: skip


class EncoderAngleError(Stranger):
    """An encoder whose angle is wrong at an uneven order of the motor, by 2 to 30 mrad; the loop does not see it."""

    kind: ClassVar[str] = "encoder_angle_error"
    axis: ClassVar[str] = "motor_shaft"
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "angle error in PART"

    def on_angle(self, angle: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the error."""
        return np.asarray(angle + self.size * np.sin(self.at * angle + self.phase))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw order and size; None without an encoder."""
        if setting.rig.design.angle != "encoder":
            return None
        return cls(
            part="encoder",
            at=float(rng.choice([1.0, 2.0, 3.0])),
            size=float(10.0 ** rng.uniform(-2.7, -1.5)),
            phase=any_phase(rng),
        )
