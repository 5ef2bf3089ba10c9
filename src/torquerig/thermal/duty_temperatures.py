"""Figures of a duty over all variants: temperatures, margin, torque against rating, time to the limit."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np

from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import ThermalVariants
from torquerig.thermal.thermal_motor import ThermalMotor
from torquerig.thermal.warming import warming

COLD_START = np.zeros(2)


@dataclass(frozen=True, kw_only=True)
class Span:
    """A figure of the nominal variant, and its lowest and highest over all variants; infinite if never reached."""

    value: float
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class DutyTemperatures:
    """Temperatures of a motor under an endlessly repeated duty.

    Parameters
    ----------
    winding, lowest, housing : Span
        Highest and lowest winding and highest housing temperature of the settled cycle [C]; infinite in a runaway.
    once : Span
        Highest winding temperature of the first cycle from cold [C].
    margin : Span
        Limit minus highest winding temperature of the same variant [K].
    use : Span
        Highest winding rise over the rise that the limit allows [1].
    until : Span
        Time from cold until the winding is at its limit [s]; infinite if never.
    rms_torque, peak_torque, rms_current : float
        [N m], [N m], [A] of the nominal variant, NaN where no torque constant is known.
    """

    winding: Span
    lowest: Span
    housing: Span
    once: Span
    margin: Span
    use: Span
    until: Span
    rms_torque: float
    peak_torque: float
    rms_current: float

    @property
    def word(self) -> str:
        """``safe`` where every variant stays below its limit, ``too hot`` where none does, else ``unsure``."""
        if self.margin.low > 0:
            return "safe"
        return "too hot" if self.margin.high <= 0 else "unsure"


def temperatures_of_duty(duty: MotorDuty, variants: ThermalVariants, *, ambient: float) -> DutyTemperatures:
    """Return the figures of a duty at ``ambient`` [C], repeated endlessly from a cold start."""
    rows = [_figures(motor, duty, ambient) for motor in (variants.nominal, *variants.corners)]
    spans = [Span(value=column[0], low=min(column), high=max(column)) for column in zip(*rows, strict=True)]
    winding, lowest, housing, once, margin, use, until = spans
    return DutyTemperatures(
        winding=winding, lowest=lowest, housing=housing, once=once, margin=margin, use=use, until=until,
        rms_torque=duty.rms_torque, peak_torque=duty.peak_torque,
        rms_current=variants.nominal.current(duty.rms_torque),
    )  # fmt: skip


def _figures(motor: ThermalMotor, duty: MotorDuty, ambient: float) -> tuple[float, ...]:
    made = warming(motor, duty, ambient=ambient)
    settled = made.settled()
    lowest, highest, housing = (inf, inf, inf) if settled is None else made.extremes(settled)
    until = made.time_to(motor.limit, COLD_START)
    return (
        highest, lowest, housing, made.extremes(COLD_START)[1], motor.limit - highest,
        (highest - ambient) / (motor.limit - ambient), inf if until is None else until,
    )  # fmt: skip
