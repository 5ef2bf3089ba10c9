"""Shares of load, cogging, electrical and mechanical ripple in the sensor's reading."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.metrics.truth_error import true_load

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording
    from torquerig.rig.assembly import Rig

SENSED = ("true_sensor_torque_Nm", "true_sensor_force_N")
DISTURBANCES = ("cogging", "electrical", "mechanical")


@dataclass(frozen=True, kw_only=True)
class Shares:
    """Rms of each share of the torque in the sensor [N m], and the mean [N m].

    Each share is the difference to a run without that group of effects, under the same random load. The squares need
    not add up, because speed loop and losses couple the groups slightly. ``true_load`` is the rms of the load, referred
    to the measured shaft; ``load`` is what the shafts make of it at the sensor, which depends on inertias, ratio and
    speed loop.
    """

    mean: float
    load: float
    cogging: float
    electrical: float
    mechanical: float
    true_load: float | None = None

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
    rig: Rig, *, duration: float, seed: int, settling: float, wander: float = 0.0, sample_rate: float | None = None
) -> Shares:
    """Return the shares of the reading over ``duration`` seconds; five runs of the rig with the same seed.

    ``sample_rate`` [Hz] is that of the simulator where it is not given.
    """
    from torquerig.simulation.sampling import SAMPLE_RATE
    from torquerig.simulation.simulator import simulate

    rate = SAMPLE_RATE if sample_rate is None else sample_rate

    def run(*left_out: str) -> Recording:
        kept = replace(rig, parts=tuple(part for part in rig.parts if part.group not in left_out))
        return simulate(kept, duration=duration, seed=seed, wander=wander, settling=settling, sample_rate=rate)

    return shares_of(run(), run(*DISTURBANCES), without={group: run(group) for group in DISTURBANCES})


def shares_of(whole: Recording, quiet: Recording, *, without: Mapping[str, Recording]) -> Shares:
    """Return the shares from runs under the same load.

    Parameters
    ----------
    whole, quiet : Recording
        Of the whole rig, and without any of its disturbances.
    without : mapping of str to Recording
        Without one of ``DISTURBANCES`` each.
    """
    torque, load = sensed(whole), sensed(quiet)
    lost = {group: float(np.std(torque - sensed(without[group]))) for group in DISTURBANCES}
    at_part = true_load(quiet)
    return Shares(
        mean=float(torque.mean()), load=float(load.std()),
        true_load=None if at_part is None else float(at_part.std()), **lost,
    )  # fmt: skip


def sensed(made: Recording) -> NDArray[np.float64]:
    """Return the true effort at the first measured place [N m], in a line [N], shape (samples,)."""
    return made.channels[next(one for one in SENSED if one in made.channels)].values
