"""Another sample rate, other counts of the encoder, other set-points: where all speeds are off by one factor."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import pi

import numpy as np

from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.readings.reading import SetupFault
from torquerig.inference.readings.sensor_scale import slip
from torquerig.rig.assembly import Rig

_SPEED_ERROR, _SLIP = 0.03, 0.15  # [1] of the set-point: more is no error of a drive, and none of an induction motor
_ALIKE = 0.02  # [1] within which the factors of all runs are one


def speed_factor(runs: Sequence[MeasuredRun], rig: Rig) -> float | None:
    """Return the common factor of real speed and set-point where no drive is so far off; else None."""
    factors = np.array([run.speed_factor for run in runs])
    middle = float(np.median(factors))
    permitted = _SLIP if rig.of_kind("induction_drive") else _SPEED_ERROR
    one = bool(np.abs(factors / middle - 1).max() < _ALIKE) if middle else False
    if not one or middle <= 0 or abs(middle - 1) <= permitted:
        return None
    return slip(middle) if abs(np.log(slip(middle) / middle)) < permitted else middle


def rescaled(runs: Sequence[MeasuredRun], factor: float) -> Iterator[tuple[tuple[MeasuredRun, ...], SetupFault]]:
    """Yield the runs with another sample rate and, where the angle was measured, with other counts per turn."""
    rate = runs[0].rate / factor
    yield (
        tuple(_at_rate(run, run.rate / factor) for run in runs),
        SetupFault(
            kind="sample_rate", of="recordings", stated=runs[0].rate, estimated=rate, unit="Hz", equivalent_to=(),
            explanation=f"The samples were taken at {rate:.5g} Hz where {runs[0].rate:.5g} Hz are stated: the speeds "
            "and the frequencies of the rig then agree with the scenario.",
        ),
    )  # fmt: skip
    counts = _counts(runs[0])
    if counts and all(run.has_encoder for run in runs):
        yield (
            tuple(_at_counts(run, factor) for run in runs),
            SetupFault(
                kind="counts_per_rev", of="encoder", stated=counts, estimated=counts * factor, unit="1/rev",
                equivalent_to=(),
                explanation=f"A turn of the encoder has {counts * factor:.5g} counts, not {counts:.5g}: the speeds and "
                "the orders of the lines then agree with the scenario.",
            ),
        )  # fmt: skip


def _counts(run: MeasuredRun) -> float | None:
    """Return the stated counts per turn of the encoder; None where no channel counts."""
    counted = (channel for channel in run.recording.channels.values() if channel.unit == "count")
    return next((2 * pi / abs(channel.si_per_unit) for channel in counted if channel.si_per_unit), None)


def _at_rate(run: MeasuredRun, rate: float) -> MeasuredRun:
    faster = rate / run.rate
    held = _with_speed(run, run.speed_factor * faster)
    return replace(held, recording=replace(held.recording, sample_rate=rate), speed=run.speed * faster)


def _at_counts(run: MeasuredRun, factor: float) -> MeasuredRun:
    held = _with_speed(run, run.speed_factor / factor)
    return replace(held, angle=run.angle / factor, speed=run.speed / factor)


def _with_speed(run: MeasuredRun, factor: float) -> MeasuredRun:
    """Return the run with another factor of real speed and set-point."""
    stated = run.run.speed
    conditions = replace(run.run, speed=None if stated is None else stated / run.speed_factor * factor)
    return replace(run, speed_factor=factor, recording=replace(run.recording, run=conditions))


def set_point(runs: Sequence[MeasuredRun], factor: float) -> SetupFault:
    """Return the fault of set-points that are off by a factor."""
    return SetupFault(
        kind="speed_scale", of="recordings", stated=1.0, estimated=factor, unit="1", equivalent_to=(),
        explanation=f"The motor turned {factor:.5g} times as fast as the sidecars state.",
    )  # fmt: skip
