"""Components of a mixture: one class for each type in YAML."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from torquerig.errors import InputError, did_you_mean
from torquerig.parameter import Parameter
from torquerig.sensor_stages.coloured_noise import low_passed_noise
from torquerig.synthetic.control_signal import control_signal
from torquerig.synthetic.sweep import sweep
from torquerig.synthetic.timeline import Timeline

Torque = Annotated[float, Parameter("N*m", "zero to peak", low=0)]
Frequency = Annotated[float, Parameter("Hz", "frequency", above=0)]


class Component(BaseModel, ABC):
    """A torque of one cause; ``part`` says whether it is load or noise."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    part: Literal["load", "noise"] = "noise"

    @abstractmethod
    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return the component [N m], shape (samples,); random numbers are drawn for its ``name``."""


class Constant(Component):
    """A constant torque."""

    type: Literal["constant"]
    torque: Annotated[float, Parameter("N*m", "the torque")]

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return the torque at every sample."""
        return np.full(timeline.samples, self.torque)


class Step(Component):
    """A torque that begins at ``at`` and ends at ``until``, or with the recording."""

    type: Literal["step"]
    torque: Annotated[float, Parameter("N*m", "the torque")]
    at: Annotated[float, Parameter("s", "begin", low=0)]
    until: Annotated[float, Parameter("s", "end", low=0)] = float("inf")

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return the torque from ``at`` on, before ``until``."""
        return np.where((timeline.time >= self.at) & (timeline.time < self.until), self.torque, 0.0)


class Sine(Component):
    """A line at a fixed frequency, such as the mains."""

    type: Literal["sine"]
    frequency: Frequency
    amplitude: Torque
    phase: Annotated[float, Parameter("rad", "phase at the first sample")] = 0.0

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return amplitude * cos(2 pi f t + phase)."""
        _below_half_the_rate(name, self.frequency, timeline)
        return np.asarray(self.amplitude * np.cos(2 * np.pi * self.frequency * timeline.time + self.phase))


class OrderLine(Component):
    """A line that follows the motor: ``order`` periods per turn of it."""

    type: Literal["order_line"]
    order: Annotated[float, Field(gt=0)]
    amplitude: Torque
    phase: Annotated[float, Parameter("rad", "phase at the first sample")] = 0.0

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return amplitude * cos(order * angle + phase)."""
        if timeline.motor_angle.size != timeline.samples:
            raise InputError(f"{name}: a line of order {self.order:g} needs a speed; add motor_speed: 1000 rpm")
        return np.asarray(self.amplitude * np.cos(self.order * timeline.motor_angle + self.phase))


class WhiteNoise(Component):
    """White Gaussian noise."""

    type: Literal["white_noise"]
    rms: Torque

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return independent samples."""
        return np.asarray(self.rms * timeline.random(name).standard_normal(timeline.samples))


class ColouredNoise(Component):
    """Gaussian noise through a second-order low-pass: slow variation of a load."""

    type: Literal["coloured_noise"]
    rms: Torque
    cutoff: Frequency

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return noise below the cutoff."""
        _below_half_the_rate(name, self.cutoff, timeline)
        return self.rms * low_passed_noise(timeline.samples, timeline.rate, self.cutoff, timeline.random(name))


class Hits(Component):
    """Impacts of particles: jumps at random times with exponential decay."""

    type: Literal["hits"]
    rate: Annotated[float, Parameter("1/s", "mean number per second", above=0)]
    height: Torque
    decay: Annotated[float, Parameter("s", "time constant", above=0)]

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return hits of exponentially distributed height, mean ``height``."""
        from scipy.signal import lfilter

        rng = timeline.random(name)
        counts = rng.poisson(self.rate / timeline.rate, timeline.samples)
        heights = rng.exponential(self.height, timeline.samples) * counts
        return np.asarray(lfilter([1.0], [1.0, -np.exp(-1 / (self.decay * timeline.rate))], heights))


class Sweep(Component):
    """A sine whose frequency varies over the whole recording."""

    type: Literal["sweep"]
    start: Frequency
    stop: Frequency
    amplitude: Torque
    spacing: Literal["logarithmic", "linear"] = "logarithmic"

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return the sweep."""
        for frequency in (self.start, self.stop):
            _below_half_the_rate(name, frequency, timeline)
        logarithmic = self.spacing == "logarithmic"
        wave = sweep(
            timeline.time, start=self.start, stop=self.stop, duration=timeline.duration, logarithmic=logarithmic
        )
        return self.amplitude * wave


class Control(Component):
    """All frequencies at equal amplitude: the reference report's control signal."""

    type: Literal["control"]
    amplitude: Torque

    def values(self, timeline: Timeline, name: str) -> NDArray[np.float64]:
        """Return the control signal."""
        return control_signal(timeline.samples, amplitude=self.amplitude, rng=timeline.random(name))


def _below_half_the_rate(name: str, frequency: float, timeline: Timeline) -> None:
    if frequency >= timeline.rate / 2:
        raise InputError(
            f"{name}: {frequency:g} Hz is not below half the sample rate of {timeline.rate:g} Hz; lower it, or raise "
            "sample_rate"
        )


Any_ = Constant | Step | Sine | OrderLine | WhiteNoise | ColouredNoise | Hits | Sweep | Control
_TYPES = tuple(str(get_args(kind.model_fields["type"].annotation)[0]) for kind in get_args(Any_))


def _known_type(written: Any) -> Any:
    if isinstance(written, dict) and written.get("type") not in _TYPES:
        name = str(written.get("type", ""))
        raise ValueError(f"the component has no known type ({name!r}); {did_you_mean(name, _TYPES)}")
    return written


AnyComponent = Annotated[Any_, Field(discriminator="type"), BeforeValidator(_known_type)]
