"""Temperatures of a duty as text and table rows for the terminal."""

from __future__ import annotations

from math import isfinite, isinf, isnan, pi

import numpy as np

from torquerig.catalog.motor import Motor
from torquerig.thermal.duty_temperatures import DutyTemperatures, Span
from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import ThermalVariants
from torquerig.thermal.thermal_motor import ThermalMotor

DAY = 86_400.0


def duty_rows(duty: MotorDuty, motor: ThermalMotor) -> list[list[str]]:
    """Return a header and a row for each stretch; copper loss is that of the nominal variant at 20 C."""
    rows = [["from s", "lasts s", "speed rpm", "torque N*m rms", "current Arms", "copper loss W", "friction, iron W"]]
    starts = np.cumsum(duty.duration) - duty.duration
    columns = (starts, duty.duration, duty.torque_square, duty.speed, duty.speed_square)
    for start, span, square, speed, speed_square in zip(*(one.tolist() for one in columns), strict=True):
        torque = square**0.5
        current = motor.current(torque)
        rows.append([f"{start:.4g}", f"{span:.3g}", f"{speed * 30 / pi:.0f}", f"{torque:.3f}",
                     "?" if isnan(current) else f"{current:.2f}", f"{motor.copper_loss * square:.1f}",
                     f"{motor.loss_of_speed(speed, speed_square):.1f}"])  # fmt: skip
    return rows


def figure_rows(found: DutyTemperatures, entry: Motor) -> list[list[str]]:
    """Return a header and a row for each figure: nominal, lowest and highest over all variants."""
    continuous = entry.rated_torque if entry.stall_torque.unknown else entry.stall_torque
    low, high = continuous.bounds
    share = Span(value=found.rms_torque / continuous.nominal(), low=found.rms_torque / high,
                 high=found.rms_torque / low)  # fmt: skip
    current = "?" if isnan(found.rms_current) else f"{found.rms_current:.2f}"
    return [
        ["figure", "nominal", "lowest", "highest"],
        ["rms torque N*m", f"{found.rms_torque:.3f}", "", ""],
        ["largest torque N*m", f"{found.peak_torque:.3f}", "", ""],
        ["rms current Arms", current, "", ""],
        ["rms torque over continuous torque", *_cells(share, 2)],
        ["winding, highest, first cycle C", *_cells(found.once, 1)],
        ["winding, highest, settled C", *_cells(found.winding, 1)],
        ["winding, lowest, settled C", *_cells(found.lowest, 1)],
        ["housing, highest, settled C", *_cells(found.housing, 1)],
        ["margin to the winding's limit K", *_cells(found.margin, 1)],
        ["rise over allowed rise", *_cells(found.use, 2)],
        ["time to the limit, from cold", *(_time_text(one) for one in _ends(found.until))],
    ]


def verdict_sentence(found: DutyTemperatures, variants: ThermalVariants) -> str:
    """Return the verdict in sentences."""
    limits = [one.limit for one in variants.corners]
    limit = f"{min(limits):g}..{max(limits):g} C" if min(limits) < max(limits) else f"{limits[0]:g} C"
    if found.word == "safe":
        return (f"Safe: the winding stays below its limit of {limit} for all open values; the smallest margin is "
                f"{found.margin.low:.0f} K.")  # fmt: skip
    if found.word == "too hot":
        return (f"Too hot: the winding exceeds its limit of {limit} for all open values, after "
                f"{_time_text(found.until.high)} at the latest.")  # fmt: skip
    nominal = "stays below" if found.margin.value > 0 else "exceeds"
    return (f"Unsure: the nominal motor {nominal} its limit of {limit}, but not every motor within the data does; "
            "ask the maker for the values listed below.")  # fmt: skip


def _cells(span: Span, digits: int) -> list[str]:
    return [_number(one, digits) for one in _ends(span)]


def _ends(span: Span) -> tuple[float, float, float]:
    return span.value, span.low, span.high


def _number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if isfinite(value) and abs(value) < 1e4 else "runaway"


def _time_text(seconds: float) -> str:
    if isinf(seconds):
        return "never"
    if seconds < 120:
        return f"{seconds:.3g} s"
    if seconds < 2 * 3600:
        return f"{seconds / 60:.3g} min"
    return f"{seconds / 3600:.3g} h" if seconds < 2 * DAY else f"{seconds / DAY:.3g} d"
