"""What a simulation at one sample rate leaves out or costs, before it is run."""

from __future__ import annotations

from math import ceil, pi

from torquerig.rig.assembly import Rig
from torquerig.simulation.condensation.accuracy import fastest_motion
from torquerig.simulation.condensation.lowered_for import FAR, TOLERANCE, lower_for
from torquerig.simulation.step_choice import STEP_ANGLE


def said_beforehand(rig: Rig, *, rate: float, seed: int = 0) -> str:
    """Return what is condensed at ``rate`` [Hz], or that it cannot be; empty where no motion is far above the band."""
    lowered = lower_for(rig, seed, rate=rate)
    if lowered.condensation is not None:
        return f"at {rate:g} Hz the rig is {lowered.condensation.sentence()}"
    fastest = fastest_motion(lowered)
    if fastest < FAR * rate / 2:
        return ""
    steps = ceil(2 * pi * fastest / rate / STEP_ANGLE)
    return (
        f"at {rate:g} Hz motions up to {fastest:.4g} Hz are far above the recorded band, but cannot be condensed "
        f"within {100 * TOLERANCE:g} % of the response; a simulation takes some {steps} integration steps a sample"
    )
