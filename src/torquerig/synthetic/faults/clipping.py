"""A reading that stops at a limit, with the noise of what comes behind the limiter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault


@dataclass(frozen=True, kw_only=True)
class Clipping(DrawnFault):
    """The largest values, up and down alike, stop at the level that a share of the samples exceeds.

    ``noise`` is added to all samples behind the limit; the mark shows those at the limit.
    """

    type: Literal["clipping"] = "clipping"
    share: Annotated[float, Parameter("1", "share of the samples that exceed the limit", low=0, high=0.5)] = 0.03
    noise: Annotated[float, Parameter("N*m", "rms of the noise behind the limiter", low=0)] = 0.0

    zero: ClassVar[dict[str, Any]] = {"share": 0.0, "noise": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "looks clipped|stops? at"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with its reading clipped, and the samples at the limit."""
        name = recording.torque_name()
        channel = recording.channels[name]
        limit = float(np.quantile(np.abs(channel.values), 1 - self.share))
        values = np.clip(channel.values, -limit, limit)
        affected = values != channel.values
        if self.noise:
            values += self.noise / abs(channel.si_per_unit) * rng.standard_normal(values.size)
        return Disturbed(recording=recording.with_values(name, values), affected=affected)
