"""Drop of mechanical noise with rising load; the report prints 59 %."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.mechanisms import TorqueRipple
from torquerig.orders.analysis.angle_resampling import output_turns
from torquerig.orders.analysis.order_spectrum import line_amplitude
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.recordings.recording import Recording
from torquerig.study.reference_report.conditions import ReportRig

LOW, HIGH = 5.0, 21.0
"""[%] used for the report's low and high load, which it does not state."""


@dataclass(frozen=True, kw_only=True)
class MechanicalDrop:
    """Amplitude of the output shaft's first line at low and high load.

    Parameters
    ----------
    low, high : float
        In the reading, including the load [N m].
    floor : float
        Noise floor at high load: the median amplitude at neighbouring orders without lines [N m].
    by_model : float
        Drop of the line in the model [%].
    needed_high : float or None
        Occupancy to which the load must rise from ``LOW`` for the published drop [%]; None where the model has none.
    """

    low: float
    high: float
    floor: float
    by_model: float
    needed_high: float | None

    @property
    def percent(self) -> float:
        """Drop of the line in the reading [%]."""
        return 100 * (1 - self.high / self.low)


def mechanical_drop(rig: ReportRig, low: Recording, high: Recording, *, published: float) -> MechanicalDrop:
    """Return the drop of the shaft's first line between two readings, at ``LOW`` and ``HIGH``."""
    relief = max((part.relief_per_percent for part in rig.scenario.rig.parts_of(TorqueRipple)), default=0.0)
    first, last = 1 + relief * LOW, 1 + relief * HIGH
    wanted = (first / (1 - published / 100) - 1) / relief if relief else None
    amplitudes = [_amplitude(rig, one, 1.0) for one in (low, high)]
    neighbours = [_amplitude(rig, high, order) for order in (0.6, 0.7, 1.3, 1.4, 1.5, 1.6)]
    return MechanicalDrop(
        low=amplitudes[0],
        high=amplitudes[1],
        floor=float(np.median(neighbours)),
        by_model=100 * (1 - first / last),
        needed_high=wanted,
    )


def _amplitude(rig: ReportRig, reading: Recording, order: float) -> float:
    ratio = rig.kinematics.ratio
    angle = best_motor_angle(reading, rig.kinematics.lines(4), ratio=ratio)
    return line_amplitude(reading.torque(), output_turns(angle.values, ratio=ratio), order)
