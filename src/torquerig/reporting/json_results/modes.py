"""The result of ``torquerig modes``: modes, margins, poles and critical speeds of a rig."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite

from torquerig.reporting.json_results.values import Missing, Quantity, known
from torquerig.simulation.twin.crossings import Crossing
from torquerig.simulation.twin.linear_twin import Twin
from torquerig.simulation.twin.margins import Margins
from torquerig.simulation.twin.modes import Mode, Pole


@dataclass(frozen=True)
class ModeResult:
    """A mode: undamped and damped frequency, damping ratio [1], and its shape in words."""

    mode: int
    undamped_Hz: float  # noqa: N815 (the unit in the key)
    damped_Hz: float | Missing  # noqa: N815
    damping_ratio: float
    shape: str


@dataclass(frozen=True)
class MarginResult:
    """The margins of one speed loop."""

    controller: str
    stable: bool
    crossovers_Hz: tuple[float, ...]  # noqa: N815 (the unit in the key)
    phase_margin_deg: float | Missing
    gain_margin: float | Missing
    modulus_margin: float


@dataclass(frozen=True)
class PoleResult:
    """A pole of the closed loop: a frequency with its damping, or a time constant."""

    what: str
    frequency_Hz: float | Missing  # noqa: N815 (the unit in the key)
    damping_ratio: float | Missing
    time_constant_s: float | Missing


@dataclass(frozen=True)
class CriticalSpeed:
    """A motor speed at which an order line has the frequency of a mode, and the amplitude at the sensor."""

    motor_speed_rpm: float
    cause: str
    motor_order: float
    mode: int
    frequency_Hz: float  # noqa: N815 (the unit in the key)
    at_sensor: Quantity
    magnification: float


@dataclass(frozen=True)
class ModesResult:
    """The linear model of a rig about its operating point."""

    title: str
    motor_speed_rpm: float
    top_speed_rpm: float
    modes: tuple[ModeResult, ...]
    margins: tuple[MarginResult, ...]
    poles: tuple[PoleResult, ...]
    critical_speeds: tuple[CriticalSpeed, ...]
    omitted: tuple[str, ...]


def modes_result(
    twin: Twin, crossings: Sequence[Crossing], *, title: str, top_speed_rpm: float, unit: str
) -> ModesResult:
    """Return the result of a linear model; without a spring torque there are no margins and critical speeds."""
    loops, poles = (twin.margins(), twin.loop_poles()) if twin.reads_a_spring else ((), ())
    return ModesResult(
        title=title,
        motor_speed_rpm=twin.motor_speed_rpm,
        top_speed_rpm=top_speed_rpm,
        modes=tuple(_mode(number, one) for number, one in enumerate(twin.modes(), start=1)),
        margins=tuple(map(_margin, loops)),
        poles=tuple(map(_pole, poles)),
        critical_speeds=tuple(_crossing(one, unit) for one in crossings),
        omitted=tuple(twin.point.left_out),
    )


def _mode(number: int, one: Mode) -> ModeResult:
    damped = Missing("the mode is overdamped") if one.is_overdamped else one.damped
    return ModeResult(number, one.undamped, damped, one.damping, one.words)


def _margin(one: Margins) -> MarginResult:
    return MarginResult(
        controller=one.controller, stable=one.stable, crossovers_Hz=one.crossovers,
        phase_margin_deg=known(one.phase_margin, "the gain never crosses 1"),
        gain_margin=known(one.gain_margin, "the phase never crosses -180 degrees"), modulus_margin=one.modulus_margin,
    )  # fmt: skip


def _pole(one: Pole) -> PoleResult:
    if one.oscillates:
        return PoleResult(one.what, one.frequency, one.damping, Missing("the pole oscillates"))
    reason = "the pole does not oscillate"
    time = one.time_constant if isfinite(one.time_constant) else Missing("it neither falls nor grows")
    return PoleResult(one.what, Missing(reason), Missing(reason), time)


def _crossing(one: Crossing, unit: str) -> CriticalSpeed:
    return CriticalSpeed(
        motor_speed_rpm=one.speed_rpm, cause=one.line.cause, motor_order=one.line.order, mode=one.mode,
        frequency_Hz=one.frequency, magnification=one.magnification,
        at_sensor=Quantity(known(one.torque, "the amplitude of the line is not known"), unit),
    )  # fmt: skip
