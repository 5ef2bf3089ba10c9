"""A labelled mixture: a torque together with a channel for every component."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.synthetic.components import AnyComponent
from torquerig.synthetic.faults.registry import AnyFault, with_faults
from torquerig.synthetic.grid import on_grid
from torquerig.synthetic.timeline import Timeline, samples_of, turning
from torquerig.version import __version__

TRUE_LOAD, TRUE_NOISE = "true_load_Nm", "true_noise_Nm"


def _named(written: object) -> object:
    if not isinstance(written, dict) or not written:
        raise ValueError("a mixture needs components; write for example {mains: {type: sine, frequency: 50 Hz, ...}}")
    for name in written:
        if not str(name).isidentifier():
            raise ValueError(f"{name!r} cannot name a component; use letters, digits and _")
    return written


class Mixture(BaseModel):
    """Description of a mixture; the same description and random seed give the same samples."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    synthetic: str = "mixture"
    duration: Annotated[float, Parameter("s", "length of the recording", above=0)] = 10.0
    sample_rate: Annotated[float, Parameter("Hz", "sample rate", above=0)] = 25_000.0
    seed: Annotated[int, Field(ge=0)] = 1
    motor: str | None = None
    gear_ratio: Annotated[float, Field(gt=0)] | None = None
    motor_speed: Annotated[float, Parameter("rad/s", "set-point of the motor")] | None = None
    speed_error: Annotated[float, Parameter("1", "relative error of the real speed against the set-point")] = 0.0
    speed_wander: Annotated[float, Parameter("1", "rms of the slow wander as a share of the speed", low=0)] = 0.0
    counts_per_rev: Annotated[int, Field(ge=1)] | None = None
    components: Annotated[dict[str, AnyComponent], BeforeValidator(_named)]
    faults: tuple[AnyFault, ...] = ()


def mixed(mixture: Mixture) -> Recording:
    """Return the mixture: torque, encoder where it has one, true load and noise, and each component [N m].

    Every component is rounded to a grid on which sums are exact: the torque is the sum of the components, and the sum
    of load and noise, to the last bit. Faults disturb the torque and the encoder afterwards.

    Raises
    ------
    InputError
        For a line without a speed, a frequency above half the sample rate, fewer than two samples.
    """
    timeline = _timeline(mixture)
    parts = {name: on_grid(one.values(timeline, name)) for name, one in mixture.components.items()}
    load, noise = (
        sum((parts[name] for name, one in mixture.components.items() if one.part == word), np.zeros(timeline.samples))
        for word in ("load", "noise")
    )
    channels = {"torque_V": volts(load + noise)}
    if mixture.counts_per_rev is not None:
        channels["encoder_count"] = _counts(timeline.motor_angle, mixture.counts_per_rev)
    channels |= {TRUE_LOAD: truth(load), TRUE_NOISE: truth(noise)}
    channels |= {component_name(name): truth(values) for name, values in parts.items()}
    run = Run(motor=mixture.motor, gear_ratio=mixture.gear_ratio, speed=mixture.motor_speed)
    made = Recording(
        sample_rate=timeline.rate,
        channels=channels,
        run=run,
        origin={"synthetic": mixture.synthetic, "seed": mixture.seed, "torquerig": __version__},
        name=mixture.synthetic,
    )
    return with_faults(made, mixture.faults, seed=mixture.seed)


def component_name(name: str) -> str:
    """Return the channel of a component."""
    return f"component_{name}_Nm"


def truth(values: NDArray[np.float64]) -> Channel:
    """Return the channel of a true torque, which a measurement does not have."""
    return Channel(values=values, quantity="torque", unit="N*m", truth=True)


def volts(values: NDArray[np.float64]) -> Channel:
    """Return a torque [N m] as a sensor of 1 V per N m reads it."""
    return Channel(values=values, quantity="torque", unit="V")


def components_of(recording: Recording) -> Mapping[str, NDArray[np.float64]]:
    """Return the components of a mixture by name [N m]."""
    return {
        name.removeprefix("component_").removesuffix("_Nm"): channel.values
        for name, channel in recording.channels.items()
        if name.startswith("component_")
    }


def _timeline(mixture: Mixture) -> Timeline:
    samples, rate = samples_of(mixture.duration, mixture.sample_rate), mixture.sample_rate
    if mixture.motor_speed is None:
        if mixture.counts_per_rev is not None:
            raise InputError("an encoder needs a speed to count; add motor_speed: 1000 rpm")
        return Timeline(samples=samples, rate=rate, seed=mixture.seed)
    return turning(
        samples=samples, rate=rate, seed=mixture.seed, speed=mixture.motor_speed, error=mixture.speed_error,
        wander=mixture.speed_wander,
    )  # fmt: skip


def _counts(angle: NDArray[np.float64], per_turn: int) -> Channel:
    counts = np.floor(angle * (per_turn / (2 * pi)))
    return Channel(values=counts, quantity="motor_angle", unit="count", si_per_unit=2 * pi / per_turn)
