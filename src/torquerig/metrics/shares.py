"""Shares of load, cogging, electrical and mechanical ripple in the sensor's reading."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.simulation.simulator import SAMPLE_RATE, simulate

SENSED = ("true_sensor_torque_Nm", "true_sensor_force_N")
DISTURBANCES = ("cogging", "electrical", "mechanical")


@dataclass(frozen=True, kw_only=True)
class Shares:
    """Rms of each share of the torque in the sensor [N m], and the mean [N m].

    Each share is the difference to a run without that group of effects, under the same random load. The squares need
    not add up, because speed loop and losses couple the groups slightly.
    """

    mean: float
    load: float
    cogging: float
    electrical: float
    mechanical: float

    @property
    def disturbance(self) -> float:
        """Rms of the three disturbances [N m], the groups taken as independent."""
        return float(np.sqrt(sum(getattr(self, group) ** 2 for group in DISTURBANCES)))

    def percent(self) -> dict[str, float]:
        """Return each share of the fluctuation's power [%]: load and the three disturbances, 100 in all."""
        powers = {name: getattr(self, name) ** 2 for name in ("load", *DISTURBANCES)}
        whole = sum(powers.values()) or 1.0
        return {name: 100 * power / whole for name, power in powers.items()}


def reading_shares(
    rig: Rig, *, duration: float, seed: int, settling: float, wander: float = 0.0, sample_rate: float = SAMPLE_RATE
) -> Shares:  # fmt: skip
    """Return the shares of the reading over ``duration`` seconds; five runs of the rig with the same seed."""

    def torque(*left_out: str) -> NDArray[np.float64]:
        kept = replace(rig, parts=tuple(part for part in rig.parts if part.group not in left_out))
        made = simulate(
            kept, duration=duration, seed=seed, wander=wander, settling=settling, sample_rate=sample_rate
        )  # fmt: skip
        return _sensed(made)

    whole, load = torque(), torque(*DISTURBANCES)
    lost = {group: float(np.std(whole - torque(group))) for group in DISTURBANCES}
    return Shares(mean=float(whole.mean()), load=float(load.std()), **lost)


def disturbance_rms(rig: Rig, reading: Recording, *, seed: int, wander: float = 0.0, settling: float) -> float:
    """Return the rms of all that the three groups add to a simulated ``reading`` of the rig [N m]; one more run.

    ``seed``, ``wander`` and ``settling`` must be those of the reading, so that the load is the same.
    """
    quiet = replace(rig, parts=tuple(part for part in rig.parts if part.group not in DISTURBANCES))
    load = simulate(
        quiet, duration=reading.duration, seed=seed, wander=wander, settling=settling, sample_rate=reading.sample_rate
    )  # fmt: skip
    return float(np.std(_sensed(reading) - _sensed(load)))


def _sensed(made: Recording) -> NDArray[np.float64]:
    """Return the true effort at the first measured place [N m], in a line [N]."""
    return made.channels[next(one for one in SENSED if one in made.channels)].values
