"""Where flanks may part, and the candidate that opens the gap of the last gear before the sensor."""

from __future__ import annotations

from math import pi

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flights import CLEARLY, flights_counted
from torquerig.diagnosis.looking.flights_beyond_lines import flights_beyond_lines
from torquerig.scenario.kinematics import gears_to_sensor

ARCMIN = pi / 180 / 60
GAP = "backlash"  # its mechanism
_UNLOADED = 0.003  # share of samples below zero torque beyond which flanks part


def flanks_fly(case: Case) -> bool:
    """Whether the recordings show more flights than a rig without a gap."""
    return sum(flights_beyond_lines(features) for features in case.from_zero) >= CLEARLY


def flanks_fly_for_sure(case: Case) -> bool:
    """Whether they show twice as many, and in several runs: what slips now and then does so in one."""
    shown = [flights_beyond_lines(features) for features in case.from_zero]
    return sum(shown) >= 2 * CLEARLY and sum(each > 0 for each in shown) > 1


def flanks_may_part(seen: Features) -> bool:
    """Whether the torque of the run passes through zero, or near it, or rests there, and nothing slips, which strikes.

    What slips and grips again strikes as flanks do where there is little load.
    """
    if seen.observed.slipping:
        return False
    torque = seen.untoned.torque
    low = float(np.quantile(torque, _UNLOADED)) < 0.1 * float(np.abs(torque).mean())
    return low or flights_counted(seen.untoned) >= CLEARLY


def opened(case: Case, gap: float, *, within: tuple[float, float] | None = None) -> Candidate:
    """Return the gap [rad] as a candidate; ``within`` is its 95 % interval where that is known."""
    gear = gears_to_sensor(case.nominal)[-1]
    part = mechanisms.Backlash(name=GAP, gear=gear.name, gap=gap)
    return Candidate(mechanism=GAP, parts=(part,), knobs=(), within={} if within is None else {"gap": within})


def gap_of(candidate: Candidate) -> float:
    """Return the width [rad] of a gap that is a candidate."""
    (part,) = candidate.parts
    assert isinstance(part, mechanisms.Backlash)
    return part.gap
