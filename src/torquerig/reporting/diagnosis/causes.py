"""What stands at each line of a diagnosed spectrum: a part of the model, what was found missing, or nothing known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.linear.twin import Twin
from torquerig.diagnosis.outcome import Mismatch
from torquerig.diagnosis.showing.comparison import Compared
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.sensor_stages.tone import Tone, folded

KNOWN, FOUND, OPEN = "#52606d", "#b42318", "#8a5a00"
_NEAR = 0.004  # orders nearer than this share of themselves get one label
_NARROW = 0.02  # of its own place: a mismatch in frequency wider than this is a band, not a line
_WEAK = 0.02  # of the strongest line that a finding adds: less is not labelled


@dataclass(frozen=True)
class Cause:
    """A line to label: order of the output shaft [1/rev], what causes it, and the colour of what is known of it."""

    order: float
    text: str
    colour: str


@dataclass(frozen=True)
class _Line:
    """A line of a rig in one run: order of the output shaft, its owner, its size in the reading [N m]."""

    order: float
    owner: str
    size: float


def causes(outcome: Outcome, shown: Compared) -> tuple[Cause, ...]:
    """Return the labels of the lines in one run, by rising order, one at each place; what was found goes first."""
    rig, ratio = outcome.before.model.rig, kinematics_of(outcome.completed).ratio
    had = list(_lines(rig, shown, ratio))
    listed: list[Cause] = []
    for candidate in outcome.after.accepted:
        fitted = tuple(outcome.completed.part(part.name) for part in candidate.parts)
        for part in fitted:
            rig = rig + part
        rest = _lines(rig, shown, ratio)
        new = [line for line in rest if not _near(line.order, [one.order for one in had if one.size >= line.size])]
        least = _WEAK * max((line.size for line in new), default=0.0)
        said = candidate.mechanism.replace("_", " ")
        listed += [Cause(line.order, said, FOUND) for line in new if line.size > least]
    listed += [Cause(order, "unexplained", OPEN) for order in _open(outcome.left, shown, ratio)]
    listed += [Cause(line.order, line.owner.replace("_", " "), KNOWN) for line in had]
    kept: list[Cause] = []
    for cause in listed:
        if not _near(cause.order, [other.order for other in kept]):
            kept.append(cause)
    return tuple(sorted(kept, key=lambda cause: cause.order))


def is_line(mismatch: Mismatch) -> bool:
    """Whether a mismatch is one line, not a band."""
    return mismatch.domain == "order" or (mismatch.domain == "frequency" and mismatch.width < _NARROW * mismatch.at)


def _near(order: float, others: Sequence[float]) -> bool:
    return any(abs(order - other) <= _NEAR * other for other in others)


def _per_order(shown: Compared, ratio: float) -> float:
    """Return the frequency of one order of the output shaft [Hz]."""
    return abs(shown.held.observed.mean_speed) / (2 * pi * ratio)


def _lines(rig: Rig, shown: Compared, ratio: float) -> Iterator[_Line]:
    placed, turns = rig.at(shown.held.observed.run), _per_order(shown, ratio)
    for line in Twin(placed).lines():
        passed = float(np.abs(line.transfer(np.array([max(line.order * ratio * turns, 0.05)])))[0])
        yield _Line(line.order * ratio, line.owner, line.amplitude * passed)
    for stage in placed.stages():
        if isinstance(stage, Tone) and turns > 0:
            for harmonic, volts in enumerate(stage.amplitudes, start=1):
                at = folded(harmonic * stage.frequency, shown.held.observed.rate)
                if volts > 0 and at > 0:
                    yield _Line(at / turns, stage.source, volts)


def _open(left: Sequence[Mismatch], shown: Compared, ratio: float) -> Iterator[float]:
    turns = _per_order(shown, ratio)
    for each in left:
        if is_line(each) and each.domain == "order":
            yield each.at * (ratio if each.axis == "motor_shaft" else 1.0)
        elif is_line(each) and turns > 0:
            yield each.at / turns
