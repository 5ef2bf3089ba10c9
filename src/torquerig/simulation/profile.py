"""The set-point of the motor speed over time, and the loads that a profile states."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.run import Run
from torquerig.rig.terms import AppliedTorque, Load
from torquerig.sensor_stages.coloured_noise import low_passed_noise


def set_point(
    run: Run, *, settling: int, samples: int, rate: float, wander: float, rng: np.random.Generator
) -> NDArray[np.float64]:
    """Return the set-point [rad/s] at every sample of settling and recording and one more, shape (settling+samples+1,).

    While settling, the profile stands at its first value. A steady run wanders slowly: noise through a low-pass of
    the run's ``wander_cutoff``, of relative rms ``wander``.
    """
    time = _time(settling, samples, rate)
    planned = run.speed_profile().speed(time, top=run.speed or 0.0, duration=samples / rate)
    if run.profile != "steady" or wander == 0:
        return planned
    return np.asarray(planned * (1 + wander * low_passed_noise(time.size, rate, run.wander_cutoff, rng)))


def loads_as_planned(
    run: Run, loads: Sequence[NDArray[np.float64]], terms: Sequence[Load | AppliedTorque], *, settling: int,
    samples: int, rate: float,
) -> list[NDArray[np.float64]]:  # fmt: skip
    """Return the sampled loads, scaled so that their mean follows the load of the profile where it states one.

    Hits and slow variation keep their share of the mean, and their rate stays that of the operating point.
    """
    profile = run.speed_profile()
    if profile.load(np.zeros(1)) is None:  # it states none, whatever the time
        return list(loads)
    planned = profile.load(_time(settling, samples, rate))
    assert planned is not None
    mean = sum(term.process.mean for term in terms if isinstance(term, Load))
    if not mean > 0:
        raise InputError(
            f"the profile {run.profile} states a load torque, and the rig has no load that could follow it; add a "
            "particle_load of more than 0 N*m at this occupancy, or take the torque out"
        )
    share = planned / mean
    return [one * share if isinstance(term, Load) else one for one, term in zip(loads, terms, strict=True)]


def _time(settling: int, samples: int, rate: float) -> NDArray[np.float64]:
    """Return the time since the start of the recording [s], 0 while settling."""
    return np.maximum(0, np.arange(-settling, samples + 1)) / rate
