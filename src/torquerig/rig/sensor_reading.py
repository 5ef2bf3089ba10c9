"""What all sensors share: a true scale, a constant zero, the sense in which they are mounted."""

from __future__ import annotations

from typing import Literal

from torquerig.rig.assembly import Part
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.amplifier import AmplifierLowPass
from torquerig.sensor_stages.noise import WhiteNoise
from torquerig.sensor_stages.scale_and_zero import ScaleAndZero

Mounting = Literal["forward", "reversed"]


def mounting_sign(part: Part) -> float:
    """Return -1 for a sensor that is mounted the other way round, so that it reads a positive torque as negative."""
    return -1.0 if getattr(part, "mounting", "forward") == "reversed" else 1.0


def scale_and_zero(*, scale: float, zero: float) -> tuple[PlacedStage, ...]:
    """Return the stage of a sensor's scale and zero; none for a sensor that reads as its data sheet states."""
    if scale == 1.0 and zero == 0.0:
        return ()
    return (PlacedStage(position=PlacedStage.MECHANICAL, stage=ScaleAndZero(scale=scale, zero=zero)),)


def reading_stages(*, scale: float, zero: float, bandwidth: float | None, noise_rms: float) -> tuple[PlacedStage, ...]:
    """Return the stages of a sensor that writes the SI unit of its quantity: scale and zero, low-pass, noise."""
    low_pass = () if bandwidth is None else (AmplifierLowPass(cutoff=bandwidth),)
    noise = () if noise_rms == 0.0 else (WhiteNoise(rms=noise_rms),)
    return (
        *scale_and_zero(scale=scale, zero=zero),
        *(PlacedStage(position=PlacedStage.AMPLIFIER, stage=stage) for stage in low_pass),
        *(PlacedStage(position=PlacedStage.NOISE, stage=stage) for stage in noise),
    )


def refuse_zero_of_tared(*, tare: bool, zero: float, name: str) -> None:
    """Raise ValueError for a zero that was set and yet is stated as another one."""
    if tare and zero != 0.0:
        raise ValueError(f"tare: true says that the zero was set, and zero: states {zero:g}; keep one of them ({name})")
