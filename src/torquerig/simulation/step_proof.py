"""Check of the step size: the same run with half the step, and the change of the sensor's signal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.simulation.sampling import SAMPLE_RATE, SETTLING
from torquerig.simulation.simulator import choice_for, simulate
from torquerig.simulation.step_choice import StepChoice

SENSOR = "true_sensor_torque_Nm"
RELATIVE = 1e-4  # [1] tolerance where no converter sets one: of the largest torque
HALVINGS = 4  # how often the step is halved in search of one that is proven


@dataclass(frozen=True)
class StepProof:
    """The change by halving the step.

    Parameters
    ----------
    choice : StepChoice
        The step of the run and what fixed it.
    change : float
        Largest change of the sensor's torque before its amplifier [N m], at ``at`` [s] of the recording.
    at : float
    tolerance : float
        [N m].
    tolerance_is : str
        Where the tolerance comes from, in words.
    steps_needed : int or None
        The fewest steps per sample, in doublings, whose halving stays within the tolerance; None where none did.
    """

    choice: StepChoice
    change: float
    at: float
    tolerance: float
    tolerance_is: str
    steps_needed: int | None

    @property
    def proven(self) -> bool:
        """Whether the step of the run is short enough."""
        return self.steps_needed == self.choice.steps

    def sentence(self) -> str:
        """Return the proof in one sentence."""
        choice = self.choice
        words = (
            f"step: {choice.steps} a sample ({1e6 * choice.step:.3g} us), fixed by {choice.fixed_by.what}, which turns "
            f"{choice.angle:.2g} rad in it; halving it changes the sensor's torque by at most {self.change:.2g} N*m "
            f"(at {self.at:.4g} s)"
        )
        against = f"the tolerance of {self.tolerance:.2g} N*m ({self.tolerance_is})"
        if self.proven:
            return f"{words}, within {against}: proven"
        if self.steps_needed is None:
            return f"{words}, beyond {against}: NOT proven, nor with up to {choice.steps * 2 ** (HALVINGS - 1)} steps"
        return f"{words}, beyond {against}: NOT proven; {self.steps_needed} steps a sample are"


def prove_step(
    rig: Rig, *, duration: float, seed: int, sample_rate: float = SAMPLE_RATE, wander: float = 0.0,
    settling: float = SETTLING, substeps: int | None = None, tolerance: float | None = None,
) -> StepProof:  # fmt: skip
    """Return the change of the sensor's torque by halving the step, and a step that is short enough.

    The other parameters are those of ``simulate``; the run is repeated with 2, 4, ... times the steps until two
    neighbours agree, at most ``HALVINGS`` times. A rig whose motion is chaotic (rattle over many seconds) has no step
    that passes: there the signal is one of many, and only its statistics are the same.

    Parameters
    ----------
    tolerance : float, optional
        [N m]; one step of the sensor's converter when not given, or 1e-4 of the largest torque without a converter.
    """

    def torque(steps: int) -> NDArray[np.float64]:
        made = simulate(
            rig, duration=duration, seed=seed, sample_rate=sample_rate, wander=wander, settling=settling, substeps=steps
        )
        return made.channels[SENSOR].values

    choice = choice_for(
        rig, duration=duration, seed=seed, sample_rate=sample_rate, wander=wander, settling=settling, substeps=substeps
    )
    steps, coarse = choice.steps, torque(choice.steps)
    allowed, source = (tolerance, "as asked") if tolerance is not None else _tolerance(rig, coarse)
    first: tuple[float, float] | None = None
    needed = None
    for _ in range(HALVINGS):
        fine = torque(2 * steps)
        moved = np.abs(fine - coarse)
        first = first or (float(moved.max()), float(moved.argmax() / sample_rate))
        if moved.max() <= allowed:
            needed = steps
            break
        steps, coarse = 2 * steps, fine
    change, at = first or (0.0, 0.0)
    return StepProof(choice, change, at, allowed, source, needed)


def _tolerance(rig: Rig, torque: NDArray[np.float64]) -> tuple[float, str]:
    sensor = rig.part(rig.measured)
    if isinstance(sensor, AmplifiedTorqueSensor):
        code = 2 * sensor.converter_range / 2**sensor.converter_bits / sensor.sensitivity
        return code, "one step of its converter"
    return RELATIVE * float(np.abs(torque).max()), f"{RELATIVE:g} of the largest torque"
