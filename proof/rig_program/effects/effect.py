"""Interface of an effect: it changes the machine, its inputs, the voltage or the file."""

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

    ``kind`` is the class that a diagnosis should name, or the name of an effect in no library; ``in_library`` states
    which. Each method changes nothing by default; an effect overrides those that it needs.
    """

    kind: ClassVar[str]
    in_library: ClassVar[bool] = True

    @abstractmethod
    def parameters(self) -> dict[str, float | None]:
        """Return the true parameters under the names and in the units of the contract."""

    def also_right(self) -> tuple[str, ...]:
        """Return other classes that are equally right on any recording; most effects have none."""
        return ()

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Return the machine with the effect in it."""
        return machine

    def on_forcing(self, forcing: Forcing, run: Run, rng: np.random.Generator) -> Forcing:
        """Return what acts on the machine, with the effect in it."""
        return forcing

    def on_voltage(
        self,
        volts: NDArray[np.float64],
        run: Run,
        rng: np.random.Generator,
    ) -> NDArray[np.float64]:
        """Return the voltage before the converter (n,) [V], with the effect in it."""
        return volts

    def on_file(self, recording: Recording, run: Run, rng: np.random.Generator) -> Recording:
        """Return the recording as it is written, with the effect in it."""
        return recording


@dataclass(frozen=True)
class Setting:
    """Rig and plan for which an effect is drawn, so that the smallest size is visible."""

    rig: TrueRig
    plan: tuple[Run, ...]


def between(low: float, high: float, *, size: float) -> float:
    """Return the value at ``size`` (0 just visible, 1 far larger than in handbooks), on a logarithmic scale."""
    return float(low * (max(high, 1.2 * low) / low) ** size)
