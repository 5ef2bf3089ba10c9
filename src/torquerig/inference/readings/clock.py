"""Another sample rate, other counts of the encoder, other set-points: where all speeds are off by one factor."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import hypot, log, pi, sqrt

import numpy as np

from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.readings.induction_slip import slipped
from torquerig.inference.readings.reading import CLEARLY, SLIP_LOG_ODDS, Reading, SetupFault
from torquerig.inference.readings.sensor_scale import slip
from torquerig.rig.assembly import Rig

SET_POINT_ERROR = 0.01  # [1] largest error of a set-point of which nothing is stated (the form of a recording)
_TWO_SIDED = 1.96  # standard deviations of half a 95 % interval
_FOLLOWED = 0.0025  # [1] standard deviation of a speed that was found in the lines of the torque
_FAR = sqrt(2 * (CLEARLY - SLIP_LOG_ODDS))  # [standard deviations] of a factor whose prior odds cost that many nats


@dataclass(frozen=True)
class Factor:
    """Real speeds over those that the rig should have [1], common to all runs, and its standard deviation."""

    value: float
    deviation: float

    def around(self, value: float) -> tuple[float, float]:
        """Return the 95 % interval of a number that is proportional to the factor or to its inverse."""
        half = _TWO_SIDED * self.deviation * abs(value)
        return value - half, value + half


def speed_factor(reading: Reading, rig: Rig, *, set_point_error: float) -> Factor | None:
    """Return the common factor of all speeds where no drive is so far off; else None.

    A speed is expected at the set-point, within ``set_point_error`` [1], less the slip of an induction motor. The
    factor of a run whose speed changes is that to the simulated speed, which slips already.
    """
    steady = [run for run in reading.runs if run.is_steady] or list(reading.runs)
    drives = rig.of_kind("induction_drive")
    found = list[tuple[float, float]]()
    for run in steady:
        stated = None if run.run.speed is None else run.run.speed / run.speed_factor
        slips = drives and run.is_steady
        share, unsure = slipped(rig, replace(run.run, speed=stated), reading.fit.knobs) if slips else (1, 0)
        followed = 0.0 if run.has_encoder else _FOLLOWED
        found.append((run.speed_factor / share, hypot(set_point_error / sqrt(3), followed, unsure)))
    factors, deviations = np.array(found).T
    middle, deviation = float(np.median(factors)), float(np.max(deviations))
    if middle <= 0 or np.abs(np.log(np.maximum(factors, 1e-9) / middle)).max() > 2 * _FAR * deviation:
        return None
    if abs(log(middle)) <= _FAR * deviation:
        return None
    near = slip(middle)
    return Factor(near if abs(log(near / middle)) < _FAR * deviation else middle, deviation)


def rescaled(runs: Sequence[MeasuredRun], of: Factor) -> Iterator[tuple[tuple[MeasuredRun, ...], SetupFault]]:
    """Yield the runs with another sample rate and, where the angle was measured, with other counts per turn."""
    factor = of.value
    rate = runs[0].rate / factor
    yield (
        tuple(_at_rate(run, run.rate / factor) for run in runs),
        SetupFault(
            kind="sample_rate", of="recordings", stated=runs[0].rate, estimated=rate, unit="Hz", equivalent_to=(),
            interval=of.around(rate),
            explanation=f"The samples were taken at {rate:.5g} Hz where {runs[0].rate:.5g} Hz are stated: the speeds "
            "and the frequencies of the rig then agree with the scenario.",
        ),
    )  # fmt: skip
    counts = counts_of(runs[0])
    if counts and all(run.has_encoder for run in runs):
        yield (
            tuple(_atcounts_of(run, factor) for run in runs),
            SetupFault(
                kind="counts_per_rev", of="encoder", stated=counts, estimated=counts * factor, unit="1/rev",
                equivalent_to=(), interval=of.around(counts * factor),
                explanation=f"A turn of the encoder has {counts * factor:.5g} counts, not {counts:.5g}: the speeds and "
                "the orders of the lines then agree with the scenario.",
            ),
        )  # fmt: skip


def counts_of(run: MeasuredRun) -> float | None:
    """Return the stated counts per turn of the encoder; None where no channel counts."""
    counted = (channel for channel in run.recording.channels.values() if channel.unit == "count")
    return next((2 * pi / abs(channel.si_per_unit) for channel in counted if channel.si_per_unit), None)


def _at_rate(run: MeasuredRun, rate: float) -> MeasuredRun:
    faster = rate / run.rate
    held = _with_speed(run, run.speed_factor * faster)
    return replace(held, recording=replace(held.recording, sample_rate=rate), speed=run.speed * faster)


def _atcounts_of(run: MeasuredRun, factor: float) -> MeasuredRun:
    held = _with_speed(run, run.speed_factor / factor)
    return replace(held, angle=run.angle / factor, speed=run.speed / factor)


def _with_speed(run: MeasuredRun, factor: float) -> MeasuredRun:
    """Return the run with another factor of real speed and set-point."""
    stated = run.run.speed
    conditions = replace(run.run, speed=None if stated is None else stated / run.speed_factor * factor)
    return replace(run, speed_factor=factor, recording=replace(run.recording, run=conditions))


def set_point(of: Factor) -> SetupFault:
    """Return the fault of set-points that are off by a factor."""
    return SetupFault(
        kind="speed_scale", of="recordings", stated=1.0, estimated=of.value, unit="1", equivalent_to=(),
        interval=of.around(of.value),
        explanation=f"The motor turned {of.value:.5g} times as fast as the sidecars state.",
    )  # fmt: skip
