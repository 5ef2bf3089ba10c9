"""Residual disturbance behind a filter chain: the same reading with and without disturbance, both filtered."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from torquerig.metrics.shares import DISTURBANCES, sensed
from torquerig.simulation.sampling import SAMPLE_RATE
from torquerig.simulation.simulator import simulate

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.recordings.recording import Recording
    from torquerig.rig.assembly import Rig


@dataclass(frozen=True)
class ReadingPair:
    """One reading, and the reading of the same load on the same rig without its disturbances."""

    reading: Recording
    quiet: Recording

    def residual_rms(self, chain: Chain) -> float:
        """Return the rms of the disturbance behind a filter chain [N m].

        Exact for a linear chain. A chain that estimates its lines from the reading has them in one of the two readings
        only.
        """
        return float(np.std(chain.apply(self.reading).torque() - chain.apply(self.quiet).torque()))

    @property
    def disturbance(self) -> float:
        """The rms of the disturbance in the torque at the sensor, before its amplifier and noise [N m]."""
        return float(np.std(sensed(self.reading) - sensed(self.quiet)))

    @property
    def before(self) -> float:
        """The rms of the disturbance in the unfiltered reading [N m]."""
        return float(np.std(self.reading.torque() - self.quiet.torque()))


def simulated_reading_pair(
    rig: Rig, *, duration: float, seed: int, settling: float, wander: float = 0.0, sample_rate: float = SAMPLE_RATE,
    phase_seed: int | None = None, scenario: str = "",
) -> ReadingPair:  # fmt: skip
    """Simulate a rig twice under the same random load: with and without cogging, electrical and mechanical lines.

    The arguments are those of :func:`torquerig.simulation.simulator.simulate`.
    """
    quiet = replace(rig, parts=tuple(part for part in rig.parts if part.group not in DISTURBANCES))
    reading, load = (
        simulate(one, duration=duration, seed=seed, wander=wander, settling=settling, sample_rate=sample_rate,
                 phase_seed=phase_seed, scenario=scenario)
        for one in (rig, quiet)
    )  # fmt: skip
    return ReadingPair(reading, load)
