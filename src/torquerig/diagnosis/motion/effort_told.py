"""What is told of an effort's samples beside a fitted model: whether a limit is the reading's, whether codes matter."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.choosing.confidence import SEEN_IN_SAMPLES
from torquerig.diagnosis.motion.effort_samples import EffortFaults, code_of
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion, residuals_of
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.outcome import Finding, Stated
from torquerig.rig.assembly import Part

_BEYOND = 2.0  # times what the model leaves elsewhere, by which the motion asks for more than the limit
_OF_THE_NOISE = 0.5  # of the median square that the model leaves of the samples as they were recorded
_OF_THE_EFFORT = 0.04  # of its rms: finer codes are any converter's


class Told(NamedTuple):
    """A fault as a finding, in the units of the effort's channel, and as a part, in SI."""

    finding: Finding
    part: Part


def limit_is_the_readings(faults: EffortFaults, after: FittedMotion, runs: Sequence[Moved]) -> bool:
    """Whether the motion asked for more than the limit where the effort stood at it.

    A drive that gives no more than its limit moves the rig with just that: the model takes it for the motion, too.
    """
    pairs = list(zip(runs, after.residuals, faults.standing, strict=True))
    asked = np.concatenate([(-np.sign(run.effort) * left)[at] for run, left, at in pairs])
    away = root_mean_square([left[run.seen | run.held] for run, left, _ in pairs])
    return asked.size > 0 and float(asked.mean()) > _BEYOND * away


def effort_told(
    faults: EffortFaults, after: FittedMotion, runs: Sequence[Moved], *, code: float | None
) -> Iterator[Told]:
    """Yield the faults that the library can state and the scenario does not; ``code`` comes of ``with_codes``."""
    channel = runs[0].channel
    unit, scale = channel.unit, abs(channel.si_per_unit)
    stated = {part.kind for part in after.rig.parts}
    if faults.limit is not None and "clipping" not in stated and hasattr(mechanisms, "Clipping"):
        limit = faults.limit
        said = f"clipping of the reading at {limit.limit:.4g} {unit}, below what the motion requires"
        yield Told(_finding("clipping", said, {"limit_V": (limit.limit, 2e-4, unit)}),
                   mechanisms.Clipping(name="clipping", limit=limit.limit * scale))  # fmt: skip
    if faults.lost is not None and "signal_dropout" not in stated and hasattr(mechanisms, "SignalDropout"):
        lost = faults.lost
        said = f"signal dropouts of {1e3 * lost.duration:.2g} ms, {60 * lost.rate:.1f} per minute"
        numbers = {"duration_ms": (1e3 * lost.duration, 0.03, "ms"), "rate_per_minute": (60 * lost.rate, 0.2, "1/min")}
        part = mechanisms.SignalDropout(
            name="signal_dropout", duration=lost.duration, rate=lost.rate, level=lost.level * scale
        )
        yield Told(_finding("signal_dropout", said, numbers), part)
    if code is not None:
        said = f"quantization with a step of {code:.3g} {unit}, which causes most of the noise"
        yield Told(_finding("quantization", said, {"step_V": (code, 1e-4, unit)}),
                   mechanisms.Quantization(name="quantization", step=code * scale))  # fmt: skip


def _finding(name: str, said: str, stated: Mapping[str, tuple[float, float, str]]) -> Finding:
    return Finding(
        mechanism=name, variant="", explanation=f"The model lacks {said}.", confidence=SEEN_IN_SAMPLES, gain=0.0,
        parameters={
            key: Stated(value=value, low=value * (1 - spread), high=value * (1 + spread), unit=unit)
            for key, (value, spread, unit) in stated.items()
        },
    )  # fmt: skip


def with_codes(after: FittedMotion, runs: Sequence[Moved]) -> tuple[FittedMotion, float | None]:
    """Return the model, in codes where that comes nearer, and the distance of those that make most of the noise.

    Codes put every sample somewhere within half a step of the effort (Widrow & Kollar), a quarter of a step away in
    the median, in the channel's unit. Where little else dithers them that noise is no white one: its lines and levels
    are in the compared band, and only a model with the same codes has them.
    """
    codes = [code_of(run.channel.values) for run in runs]
    if any(code is None for code in codes) or not hasattr(mechanisms, "Quantization"):
        return after, None
    code = float(np.median([code for code in codes if code is not None]))
    step = code * abs(runs[0].channel.si_per_unit)
    left = [
        (run.channel.in_si() - run.effort + residual)[run.seen | run.held]
        for run, residual in zip(runs, after.residuals, strict=True)
    ]
    if (
        (step / 4) ** 2 < _OF_THE_NOISE * float(np.median(np.abs(np.concatenate(left)))) ** 2
        or step < _OF_THE_EFFORT * root_mean_square([run.effort for run in runs])
        or after.rig.of_kind("quantization")
    ):
        return after, None
    coded = residuals_of(after.rig + mechanisms.Quantization(name="quantization", step=step), runs, zero=after.zero)
    nearer = replace(after, residuals=coded)
    return nearer if root_mean_square(nearer.of(runs)) < root_mean_square(after.of(runs)) else after, code
