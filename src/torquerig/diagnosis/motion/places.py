"""What still stands out when a model is as good as it gets: lines, speeds and places at which the level is wrong."""

from __future__ import annotations

from collections.abc import Sequence
from math import erfc, log10, pi, sqrt

from torquerig.diagnosis.motion.course import course_left
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.level import BINS, level_off
from torquerig.diagnosis.motion.lines import Line, in_a_line, lines_in, moving
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.steps import step_in
from torquerig.inference.answer.mismatch import Mismatch

_TRACE = 0.005  # of what a model leaves: lines that have less of it are the detail of something else
_LITTLE = 0.007  # of the rms effort: what nobody models
_DETAIL = 0.05  # of a line that stood there before: no model of it is right to better


def mismatches(
    model: FittedMotion, runs: Sequence[Moved], *, before: FittedMotion | None = None
) -> tuple[Mismatch, ...]:
    """Return the places where the model is significantly wrong, largest share of what it leaves first.

    What is left of a line that ``before`` had there is passed over where it is the detail of what explains the rest.
    """
    least = _LITTLE * root_mean_square([run.effort[run.seen] for run in runs if run.seen.any()])
    had = () if before is None or before is model else lines_in(before.residuals, runs)
    lines = [line for line in lines_in(model.residuals, runs) if line.amplitude > least and not _detail(line, had)]
    found = [_of_line(line, model, runs) for line in lines]
    found = [one for one in found if one.share_of_misfit > _TRACE]
    found += [*_of_speed(model, runs), *_of_course(model, runs), *_of_time(model, runs)]
    return tuple(sorted(found, key=lambda one: -one.share_of_misfit))


def _detail(line: Line, had: Sequence[Line]) -> bool:
    """Whether a line is what is left of a far larger one at its place."""
    there = [one for one in had if one.domain == line.domain and abs(one.at - line.at) <= one.width]
    return any(line.amplitude < _DETAIL * one.amplitude for one in there)


def _of_line(line: Line, model: FittedMotion, runs: Sequence[Moved]) -> Mismatch:
    left = model.of(runs)
    total = sum(float(each @ each) for each in left)
    count = sum(int((run.seen & moving(run)).sum()) for run in runs)
    axis = "Hz" if line.domain == "frequency" else "cycles/m" if in_a_line(runs) else "motor_shaft"
    return Mismatch(
        domain=line.domain, axis=axis, at=line.at, width=line.width, recordings=_names(runs), excess_dB=line.excess_db,
        share_of_misfit=min(1.0, 0.5 * line.amplitude**2 * count / total), p_value=line.p_value,
    )  # fmt: skip


def _of_speed(model: FittedMotion, runs: Sequence[Moved]) -> list[Mismatch]:
    off = level_off(model, runs)
    if off is None:
        return []
    unit = 1.0 if in_a_line(runs) else 30 / pi
    return [Mismatch(
        domain="speed", axis="m/s" if in_a_line(runs) else "rpm", at=off.at * unit, width=off.width * unit,
        recordings=_names(runs), excess_dB=20 * log10(off.deviations), share_of_misfit=off.share,
        p_value=min(1.0, BINS * erfc(off.deviations / sqrt(2))),
    )]  # fmt: skip


def _of_course(model: FittedMotion, runs: Sequence[Moved]) -> list[Mismatch]:
    left = course_left(model, runs)
    if left is None:
        return []
    return [Mismatch(
        domain="level", axis="m" if in_a_line(runs) else "rad", at=left.at, width=left.width, recordings=left.runs,
        excess_dB=left.excess_db, share_of_misfit=min(1.0, left.share), p_value=left.p_value,
    )]  # fmt: skip


def _of_time(model: FittedMotion, runs: Sequence[Moved]) -> list[Mismatch]:
    step = step_in(model, runs)
    if step is None:
        return []
    return [Mismatch(
        domain="time", axis="s", at=step.at, width=step.width, recordings=(step.run,), excess_dB=step.excess_db,
        share_of_misfit=step.share, p_value=step.p_value,
    )]  # fmt: skip


def _names(runs: Sequence[Moved]) -> tuple[str, ...]:
    return tuple(run.name for run in runs if run.seen.any())
