"""What an effect can lay its hand on: the machine, its inputs, the voltage, the file."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program.forcing import Forcing
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run
from proof.rig_program.recorded import Recording
from proof.rig_program.true_rig import TrueRig


class Effect(ABC):
    """One effect that the nominal model leaves out.

    ``kind`` is the class that a diagnosis should name, or the name of an effect in no library; ``in_library`` tells
    which. Every question has an empty answer, and an effect answers those that concern it.
    """

    kind: ClassVar[str]
    in_library: ClassVar[bool] = True

    @abstractmethod
    def parameters(self) -> dict[str, float | None]:
        """Give the true parameters under the names and in the units of the contract."""

    def also_right(self) -> tuple[str, ...]:
        """Name the classes that would be as right as its own on any recording; most have none."""
        return ()

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Give the machine with the effect in it."""
        return machine

    def on_forcing(self, forcing: Forcing, run: Run, rng: np.random.Generator) -> Forcing:
        """Give what acts on the machine, with the effect in it."""
        return forcing

    def on_voltage(
        self,
        volts: NDArray[np.float64],
        run: Run,
        rng: np.random.Generator,
    ) -> NDArray[np.float64]:
        """Give the voltage before the converter (n,) [V], with the effect in it."""
        return volts

    def on_file(self, recording: Recording, run: Run, rng: np.random.Generator) -> Recording:
        """Give the recording as it is written, with the effect in it."""
        return recording


@dataclass(frozen=True)
class Setting:
    """For which rig and plan is an effect drawn? Known to the drawing only, so that sizes begin at visible."""

    rig: TrueRig
    plan: tuple[Run, ...]


def between(low: float, high: float, *, size: float) -> float:
    """Give the value at ``size`` (0 just visible, 1 far larger than any handbook's), evenly in its logarithm."""
    return float(low * (max(high, 1.2 * low) / low) ** size)
