"""Time and motor angle of the samples of a synthetic recording."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.recording import random_for
from torquerig.recordings.run import WANDER_CUTOFF
from torquerig.sensor_stages.coloured_noise import low_passed_noise

MOST_SAMPLES = 10_000_000  # with ten components they take about 1 GB


def samples_of(duration: float, rate: float) -> int:
    """Return the samples of a recording of ``duration`` [s] at ``rate`` [Hz].

    Raises
    ------
    InputError
        For fewer than 2 and more than ``MOST_SAMPLES``, with the longest duration.
    """
    samples = duration * rate
    if samples > MOST_SAMPLES:
        raise InputError(f"a recording of {duration:g} s at {rate:g} Hz has {samples:.4g} samples, too many for the "
                         f"memory; ask for at most {MOST_SAMPLES / rate:.4g} s")  # fmt: skip
    if round(samples) < 2:
        raise InputError(f"a recording of {duration:g} s at {rate:g} Hz has {round(samples)} samples; ask for more")
    return round(samples)


@dataclass(frozen=True, kw_only=True)
class Timeline:
    """The samples of one recording.

    Parameters
    ----------
    samples : int
    rate : float
        [Hz].
    seed : int
        Random seed; every component has a separate generator by its name.
    motor_angle : ndarray, shape (samples,)
        [rad]; zeros where the motor has no speed.
    """

    samples: int
    rate: float
    seed: int
    motor_angle: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))

    @property
    def time(self) -> NDArray[np.float64]:
        """The time of each sample [s]."""
        return np.asarray(np.arange(self.samples) / self.rate, dtype=np.float64)

    @property
    def duration(self) -> float:
        """[s]."""
        return self.samples / self.rate

    def random(self, purpose: str) -> np.random.Generator:
        """Return the random generator of one purpose."""
        return random_for(self.seed, purpose)


def turning(*, samples: int, rate: float, seed: int, speed: float, error: float = 0.0, wander: float = 0.0) -> Timeline:
    """Return the samples of a motor that turns at ``speed`` [rad/s] times 1 + ``error``, with slow ``wander``.

    Both are shares of the speed; the wander is the rms of noise below 0.3 Hz.
    """
    course = np.full(samples, 1.0 + error)
    if wander:
        course += wander * low_passed_noise(samples, rate, WANDER_CUTOFF, random_for(seed, "wander of the speed"))
    return Timeline(samples=samples, rate=rate, seed=seed, motor_angle=np.cumsum(speed * course) / rate)
