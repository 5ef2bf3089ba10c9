"""The results of ``torquerig duty`` and ``torquerig size``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isinf
from statistics import median
from typing import Any

from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS, Sizing
from torquerig.reporting.json_results.figures import figure_result
from torquerig.reporting.json_results.values import Interval, Missing, known
from torquerig.reporting.sizing.sizing_text import verdict_text
from torquerig.study.candidate import Candidate
from torquerig.thermal.duty_temperatures import DutyTemperatures, Span
from torquerig.thermal.duty_text import verdict_sentence
from torquerig.thermal.motor_variants import ThermalVariants


@dataclass(frozen=True)
class SizedFigure:
    """A figure of a drive with its interval; ``limit`` is holds, exceeds, unsure or unknown, empty without a limit."""

    value: float | Missing
    low: float | Missing
    high: float | Missing
    unit: str
    limit: str
    decided_by: str


@dataclass(frozen=True)
class SizedDriveResult:
    """One drive: its verdict, and its figures by name; no figures where it is out of reach."""

    drive: str
    verdict: str
    sentence: str
    figures: Mapping[str, SizedFigure]


@dataclass(frozen=True)
class SizeResult:
    """The sizing of one drive or of all drives of a study.

    Parameters
    ----------
    ambient_C : float
    drives : tuple of SizedDriveResult
    disturbance : mapping of str to Interval
        At the sensor, by filter (``before``: without one): median, lowest and highest rms of the Monte Carlo samples.
    notes : tuple of str
        What is flagged.
    """

    ambient_C: float  # noqa: N815 (the unit in the key)
    drives: tuple[SizedDriveResult, ...]
    disturbance: Mapping[str, Interval]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class DutyResult:
    """Torque, speed and temperatures of a motor over a duty cycle; ``verdict`` is safe, too hot or unsure."""

    title: str
    ambient_C: float  # noqa: N815 (the unit in the key)
    verdict: str
    sentence: str
    figures: Mapping[str, Interval]
    flagged: tuple[str, ...]
    not_used: tuple[str, ...]
    assumed: Mapping[str, str]


_DUTY_UNITS: Mapping[str, str] = {
    "winding": "C", "lowest": "C", "housing": "C", "once": "C", "margin": "K", "use": "1", "until": "s",
    "rms_torque": "N*m", "peak_torque": "N*m", "rms_current": "A",
}  # fmt: skip
_DUTY_NAMES: Mapping[str, str] = {
    "winding": "winding_highest", "lowest": "winding_lowest", "housing": "housing_highest",
    "once": "winding_highest_first_cycle", "margin": "margin_to_limit", "use": "rise_over_allowed_rise",
    "until": "time_to_limit",
}  # fmt: skip


def sized_drive_result(name: str, sized: Sizing | str) -> SizedDriveResult:
    """Return the result of one drive; a text is the reason why it is out of reach."""
    if isinstance(sized, str):
        return SizedDriveResult(name, "out of reach", sized, {})
    figures = {}
    for key, figure in sized.figures.items():
        made = figure_result(figure)
        figures[key] = SizedFigure(
            made.value, made.low, made.high, SIZING_UNITS[key], sized.word(key), figure.missing
        )  # fmt: skip
    return SizedDriveResult(name, sized.verdict, verdict_text(sized), figures)


def all_sized(sized: Mapping[Candidate, Sizing | str]) -> tuple[SizedDriveResult, ...]:
    """Return the results of all drives of a study."""
    return tuple(sized_drive_result(one.name, made) for one, made in sized.items())


def disturbance_result(
    before: Sequence[float], after: Mapping[str, Sequence[float]], *, unit: str
) -> dict[str, Interval]:
    """Return median, lowest and highest disturbance without a filter and with each."""
    every = {"before": before, **after} if before else {}
    return {name: Interval(median(one), min(one), max(one), unit) for name, one in every.items()}


def duty_result(
    judged: DutyTemperatures, variants: ThermalVariants, *, title: str, ambient: float, **notes: Any
) -> DutyResult:
    """Return the result of a duty; ``notes`` are ``flagged`` and ``not_used``."""
    figures = {}
    for key, unit in _DUTY_UNITS.items():
        found = getattr(judged, key)
        span = found if isinstance(found, Span) else Span(value=found, low=found, high=found)
        value, low, high = (_end(one, key) for one in (span.value, span.low, span.high))
        figures[_DUTY_NAMES.get(key, key)] = Interval(value, low, high, unit)
    return DutyResult(
        title=title, ambient_C=ambient, verdict=judged.word, sentence=verdict_sentence(judged, variants),
        figures=figures, assumed=dict(variants.assumed), **notes,
    )  # fmt: skip


def _end(value: float, key: str) -> float | Missing:
    if isinf(value):
        return Missing("the limit is never reached" if key == "until" else "the temperature grows without end")
    return known(value, "no torque constant is known")
