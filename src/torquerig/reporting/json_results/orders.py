"""The result of ``torquerig orders``: lines of a drive at one speed."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from torquerig.orders.kinematics.order_report import OrdersReport
from torquerig.orders.kinematics.order_report_text import name_of, orders_sentences


@dataclass(frozen=True)
class OrderOfDrive:
    """A line: its name, orders per turn of motor and output shaft, and frequency at the speed."""

    name: str
    harmonic: int
    frequency_Hz: float  # noqa: N815 (the unit in the key)
    motor_order: float
    output_order: float
    cancelled: bool
    cause: str
    source: str


@dataclass(frozen=True)
class ShaftOfDrive:
    """A shaft: turns of the input shaft per turn of this one, its speed, and the parts on it."""

    name: str
    input_turns_per_turn: float
    speed_rpm: float
    parts: tuple[str, ...]


@dataclass(frozen=True)
class OrdersResult:
    """The lines of a drive by rising frequency, and what coincides, in sentences."""

    title: str
    motor_speed_rpm: float
    ratio: float
    shafts: tuple[ShaftOfDrive, ...]
    lines: tuple[OrderOfDrive, ...]
    notes: tuple[str, ...]


def orders_result(report: OrdersReport, *, title: str) -> OrdersResult:
    """Return the result of an order report."""
    speed = abs(report.motor_speed)
    return OrdersResult(
        title=title,
        motor_speed_rpm=report.motor_speed * 30 / pi,
        ratio=report.kinematics.ratio,
        shafts=tuple(
            ShaftOfDrive(one.name, one.ratio, speed / one.ratio * 30 / pi, one.parts)
            for one in report.kinematics.shafts
        ),
        lines=tuple(
            OrderOfDrive(
                name=name_of(one), harmonic=one.harmonic, frequency_Hz=one.frequency(speed),
                motor_order=one.motor_order, output_order=one.output_order, cancelled=one.cancelled, cause=one.cause,
                source=one.source,
            )
            for one in report.lines
        ),
        notes=orders_sentences(report),
    )  # fmt: skip
