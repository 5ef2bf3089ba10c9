"""What a filter chain leaves of the disturbance: the same reading with and without it, both through the chain."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from torquerig.filters.chains.filter_chain import Chain
from torquerig.metrics.shares import DISTURBANCES
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation.simulator import simulate


@dataclass(frozen=True)
class WithAndWithout:
    """One reading, and the reading of the same load on the same rig without its disturbances."""

    reading: Recording
    quiet: Recording

    def left_by(self, chain: Chain) -> float:
        """Return the rms of what of the disturbance is left behind a chain [N m]; an empty chain leaves all.

        Exact for a chain that is linear; where it finds its lines in the reading itself, it sees them in one of the two
        only.
        """
        return float(np.std(chain.apply(self.reading).torque() - chain.apply(self.quiet).torque()))

    @property
    def before(self) -> float:
        """The rms of the disturbance in the reading as it is [N m]."""
        return float(np.std(self.reading.torque() - self.quiet.torque()))


def with_and_without(rig: Rig, *, duration: float, seed: int, settling: float, wander: float = 0.0) -> WithAndWithout:
    """Simulate a rig twice under the same random load: as it is, and without cogging, electrical, mechanical lines."""
    quiet = replace(rig, parts=tuple(part for part in rig.parts if part.group not in DISTURBANCES))
    reading, load = (
        simulate(one, duration=duration, seed=seed, wander=wander, settling=settling) for one in (rig, quiet)
    )
    return WithAndWithout(reading, load)
