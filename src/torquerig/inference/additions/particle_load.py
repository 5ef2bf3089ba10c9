"""Particle load: a random torque with a mean at the last shaft, where the scenario has no random load."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.terms import Load

NAMES = ("particle_load",)

_LOG_ODDS = -14.0  # a load is what a scenario states first, and a drive's uneven speed is not in the linear model
_SHARE = 0.3  # of the largest mean torque: prior median of the mean
_RMS, _RMS_SPREAD = 0.1, 1.0  # of the mean, and of its logarithm
_DECAY_SPREAD = 1.0  # of its logarithm
_STARTS = ((0.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (-1.0, 0.0, 1.0), (-1.0, 1.0, -1.0), (0.5, -1.0, 0.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield a bed of particles at the last shaft."""
    if any(isinstance(term, Load) for term in context.rig.terms()) or not context.largest_level:
        return
    name, shaft = free_name(context.rig, "particle_load"), context.shafts[-1]
    occupied = sorted({seen.run.run.occupancy_percent or 0.0 for seen in context.data.seen})
    if len(occupied) > 1:  # one mean of all runs is no load of several occupancies
        return
    part = mechanisms.ParticleLoad(
        name=name, at=shaft.part, mean_by_occupancy_percent={occupied[0]: _SHARE * context.largest_level}, hit_rms=_RMS
    )
    yield Addition(
        mechanism="particle_load", parts=(part,), starts=_STARTS, log_odds=_LOG_ODDS,
        knobs=(Knob(name, "mean_by_occupancy_percent", DECADE, key=occupied[0]), Knob(name, "hit_rms", _RMS_SPREAD),
               Knob(name, "hit_decay", _DECAY_SPREAD)),
        label=f"a random load at {shaft.part}",
        reported=(Reported("mean_Nm", "mean_by_occupancy_percent", "N*m", key=occupied[0]),
                  Reported("hit_rms", "hit_rms", "1"), Reported("hit_decay_s", "hit_decay", "s")),
    )  # fmt: skip
