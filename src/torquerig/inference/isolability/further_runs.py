"""Runs that nobody made: what another speed, load, a run-up or a reversal would show of two models."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.features.segment import Segment
from torquerig.inference.likelihood import FEWEST
from torquerig.mechanisms import ParticleLoad
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_FACTORS = (0.5, 0.63, 0.8, 1.25, 1.6, 2.0)  # of the speed of a recorded run; thirds of an octave
_FASTER = 1.3  # times the fastest recorded speed: more may be beyond the rig
_STEPS = 8  # speeds of a run-up, each with one block
_HIGHEST = 0.4  # of the sample rate


@dataclass(frozen=True, eq=False)
class FurtherRun:
    """A run with its features as yet empty, in words, and how much it takes to make it."""

    seen: RunFeatures
    words: str
    cost: int


def further_runs(seen: Sequence[RunFeatures], rig: Rig) -> Iterator[FurtherRun]:
    """Yield runs of the length of the longest recorded one, the cheapest first."""
    template = max(seen, key=lambda one: (one.run.is_steady, one.level_duration.sum()))
    run = template.run.run
    fastest = max(float(np.abs(one.level_speed).max(initial=0.0)) for one in seen)
    base = float(np.abs(template.speed).max(initial=0.0)) or fastest
    for speed in sorted({factor * base for factor in _FACTORS}):
        if speed <= _FASTER * fastest:
            yield FurtherRun(_steady(template, speed), f"a steady run at {speed * 30 / pi:.0f} rpm", 1)
    done = {one.run.run.occupancy_percent for one in seen}
    stated = {percent for load in rig.parts_of(ParticleLoad) for percent in load.mean_by_occupancy_percent}
    for percent in sorted(stated - done):
        made = _steady(template, base, occupancy=percent)
        yield FurtherRun(made, f"a steady run at {base * 30 / pi:.0f} rpm and {percent:g} % occupancy", 1)
    if all(one.run.run.profile != "ramp" for one in seen):
        yield FurtherRun(_changing(template, np.linspace(0.1, 1.0, _STEPS) * fastest, "ramp"),
                         f"a run-up to {fastest * 30 / pi:.0f} rpm", 2)  # fmt: skip
    if all(one.run.run.profile != "reversal" for one in seen):
        course = fastest * np.sin(np.linspace(0.1, 2 * pi - 0.1, _STEPS))
        yield FurtherRun(_changing(template, course, "reversal"),
                         f"a reversal between plus and minus {fastest * 30 / pi:.0f} rpm"
                         + (" without load" if run.occupancy_percent else ""), 3)  # fmt: skip


def _steady(template: RunFeatures, speed: float, *, occupancy: float | None = None) -> RunFeatures:
    segment = max(template.segments, key=lambda one: len(one.blocks))
    levels = np.full_like(template.level_speed, speed)
    return _made(template, [_at(template, segment, speed, count=None)], levels, "steady", occupancy)


def _changing(template: RunFeatures, speeds: Floats, profile: str) -> RunFeatures:
    segment = max(template.segments, key=lambda one: len(one.blocks))
    rows = [_at(template, segment, float(speed), count=1.0) for speed in speeds if abs(speed) > 0]
    count, points = template.level_speed.shape
    course = np.interp(np.linspace(0, 1, count * points), np.linspace(0, 1, speeds.size), speeds)
    return _made(template, rows, course.reshape(count, points), profile, 0.0 if profile == "reversal" else None)


def _made(
    template: RunFeatures, segments: Sequence[Segment], levels: Floats, profile: str, occupancy: float | None
) -> RunFeatures:
    run = template.run
    conditions = replace(run.run, profile=profile, speed=float(np.abs(levels).max()))  # type: ignore[arg-type]
    if occupancy is not None and run.run.occupancy_percent is not None:
        conditions = replace(conditions, occupancy_percent=occupancy)
    made = replace(run, recording=replace(run.recording, run=conditions))
    return replace(
        template, run=made, segments=tuple(segments), level_speed=levels, level_acceleration=np.zeros_like(levels)
    )


def _at(template: RunFeatures, segment: Segment, speed: float, *, count: float | None) -> Segment:
    """Return a segment at another speed; it shows all lines in the recorded range, in ``count`` blocks."""
    at = np.array([place.frequency(speed) for place in template.places])
    blocks = float(len(segment.blocks)) if count is None else count
    width = 1.0 / template.duration_of(segment)
    bands = segment.bands
    share = 1.0 if count is None else count / len(segment.blocks)
    return replace(
        segment, speed=speed, line_count=np.where((at > 2 * width) & (at < _HIGHEST * template.run.rate), blocks, 0.0),
        line_power=np.ones(at.size),
        line_noise_bandwidth=np.full(at.size, _of_shown(segment.line_noise_bandwidth, 4 * width)),
        line_half_width=np.full(at.size, _of_shown(segment.line_half_width, 2 * width)),
        bands=replace(bands, power=np.ones(bands.low.size), count=np.maximum(share * bands.count, FEWEST)),
    )  # fmt: skip


def _of_shown(values: Floats, otherwise: float) -> float:
    shown = values[np.isfinite(values)]
    return float(np.median(shown)) if shown.size else float(otherwise)
