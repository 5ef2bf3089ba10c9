"""A judged duty in words and rows for the terminal."""

from __future__ import annotations

from math import isfinite, isinf, isnan, pi

import numpy as np

from torquerig.catalog.motor import Motor
from torquerig.thermal.copies import ThermalCopies
from torquerig.thermal.judged import JudgedDuty, Span
from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.thermal_motor import ThermalMotor

DAY = 86_400.0


def duty_rows(duty: MotorDuty, motor: ThermalMotor) -> list[list[str]]:
    """Return a header and a row for each stretch; copper loss is that of the nominal copy at 20 C."""
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


def figure_rows(judged: JudgedDuty, entry: Motor) -> list[list[str]]:
    """Return a header and a row for each figure: nominal, lowest and highest over all copies."""
    continuous = entry.rated_torque if entry.stall_torque.unknown else entry.stall_torque
    low, high = continuous.bounds
    share = Span(value=judged.rms_torque / continuous.nominal(), low=judged.rms_torque / high,
                 high=judged.rms_torque / low)  # fmt: skip
    current = "?" if isnan(judged.rms_current) else f"{judged.rms_current:.2f}"
    return [
        ["figure", "nominal", "lowest", "highest"],
        ["rms torque N*m", f"{judged.rms_torque:.3f}", "", ""],
        ["largest torque N*m", f"{judged.peak_torque:.3f}", "", ""],
        ["rms current Arms", current, "", ""],
        ["rms torque over continuous torque", *_cells(share, 2)],
        ["winding, highest, first cycle C", *_cells(judged.once, 1)],
        ["winding, highest, settled C", *_cells(judged.winding, 1)],
        ["winding, lowest, settled C", *_cells(judged.lowest, 1)],
        ["housing, highest, settled C", *_cells(judged.housing, 1)],
        ["margin to the winding's limit K", *_cells(judged.margin, 1)],
        ["rise over allowed rise", *_cells(judged.use, 2)],
        ["time to the limit, from cold", *(_spoken_time(one) for one in _ends(judged.until))],
    ]


def verdict_sentence(judged: JudgedDuty, copies: ThermalCopies) -> str:
    """Return the answer in one sentence."""
    limits = [one.limit for one in copies.corners]
    limit = f"{min(limits):g}..{max(limits):g} C" if min(limits) < max(limits) else f"{limits[0]:g} C"
    if judged.word == "safe":
        return (f"Safe: the winding stays below its limit of {limit} for all that is not known; the least margin is "
                f"{judged.margin.low:.0f} K.")  # fmt: skip
    if judged.word == "too hot":
        return (f"Too hot: whatever is not known, the winding passes its limit of {limit}, after "
                f"{_spoken_time(judged.until.high)} at the latest.")  # fmt: skip
    nominal = "stays below" if judged.margin.value > 0 else "passes"
    return (f"Unsure: the nominal motor {nominal} its limit of {limit}, but not every motor that the data allow does; "
            "ask the maker for what is listed below.")  # fmt: skip


def _cells(span: Span, digits: int) -> list[str]:
    return [_number(one, digits) for one in _ends(span)]


def _ends(span: Span) -> tuple[float, float, float]:
    return span.value, span.low, span.high


def _number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if isfinite(value) and abs(value) < 1e4 else "runaway"


def _spoken_time(seconds: float) -> str:
    if isinf(seconds):
        return "never"
    if seconds < 120:
        return f"{seconds:.3g} s"
    if seconds < 2 * 3600:
        return f"{seconds / 60:.3g} min"
    return f"{seconds / 3600:.3g} h" if seconds < 2 * DAY else f"{seconds / DAY:.3g} d"
