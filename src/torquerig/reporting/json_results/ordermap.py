"""The result of ``torquerig ordermap``: spectral lines of a recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.orders.analysis.frequency_lines import FrequencyLine
from torquerig.orders.analysis.line_detection import DetectedLine
from torquerig.reporting.json_results.values import Missing, Quantity

_NO_ORDER = "found over frequency, not over order"
_NO_FREQUENCY = "found over order, not over frequency"


@dataclass(frozen=True)
class FoundLine:
    """A spectral line: what stays constant when the speed changes, where it is, its amplitude (zero to peak)."""

    constant: str
    output_order: float | Missing
    frequency_Hz: float | Missing  # noqa: N815 (the unit in the key)
    amplitude: Quantity
    above_floor_dB: float  # noqa: N815 (decibel is written dB)
    cause: str


@dataclass(frozen=True)
class KnownOrder:
    """An order with a known cause: its amplitude (zero to peak), and its level above the noise floor."""

    output_order: float
    motor_order: float
    amplitude: Quantity
    above_floor_dB: float  # noqa: N815 (decibel is written dB)
    cause: str


@dataclass(frozen=True)
class OrdermapResult:
    """The lines of a recording.

    Parameters
    ----------
    speed_rpm : tuple of two float or None
        1 % and 99 % quantile of the speed of the input shaft; None where the angle is not known.
    output_turns : float or None
    angle_origin : str
        Source of the angle; empty where there is none.
    known : tuple
        Every order with a known cause, whether or not it exceeds the noise floor.
    lines : tuple
        Lines that exceed the noise floor.
    """

    recording: str
    duration_s: float
    speed_rpm: tuple[float, float] | Missing
    output_turns: float | Missing
    angle_origin: str
    known: tuple[KnownOrder, ...]
    lines: tuple[FoundLine, ...]
    notes: tuple[str, ...]
    suspicions: tuple[str, ...]


def found_lines(found: Sequence[DetectedLine], *, unit: str) -> tuple[FoundLine, ...]:
    """Return the lines that were tested on both axes."""
    return tuple(
        FoundLine(
            constant="undecided" if one.axis == "either" else one.axis,
            output_order=one.place if one.detected_over == "order" else Missing(_NO_ORDER),
            frequency_Hz=one.place if one.detected_over == "frequency" else Missing(_NO_FREQUENCY),
            amplitude=Quantity(one.amplitude, unit), above_floor_dB=one.above_dB, cause=one.label,
        )
        for one in found
    )  # fmt: skip


def lines_over_frequency(found: Sequence[FrequencyLine], *, unit: str) -> tuple[FoundLine, ...]:
    """Return the lines of a recording whose angle is not known."""
    return tuple(
        FoundLine(
            constant="undecided", output_order=Missing(_NO_ORDER), frequency_Hz=one.frequency,
            amplitude=Quantity(one.amplitude, unit), above_floor_dB=one.above_dB,
            cause=f"{one.mains_multiple} x mains" if one.mains_multiple else "",
        )
        for one in found
    )  # fmt: skip
