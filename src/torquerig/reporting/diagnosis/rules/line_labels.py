"""Labels of spectral lines: a part of the nominal model, a finding, or unexplained."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.showing.comparison import Compared
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.sensor_stages.tone import Tone, folded

KNOWN, FOUND, UNEXPLAINED = "#52606d", "#b42318", "#8a5a00"
_NEAR = 0.004  # [1] orders with a smaller relative distance get one label
_NARROW = 0.02  # [1] width over frequency: a wider mismatch is a band, not a line
_WEAK = 0.02  # [1] share of the strongest line of a finding: a smaller line is not labelled


@dataclass(frozen=True)
class LineLabel:
    """A label: order of the output shaft [1/rev], cause of the line, and the colour for known, found or unexplained."""

    order: float
    text: str
    colour: str


@dataclass(frozen=True)
class _Line:
    """A line of a rig in one run: order of the output shaft [1/rev], part that causes it, amplitude read [N m]."""

    order: float
    source: str
    amplitude: float


def line_labels(outcome: Outcome, shown: Compared) -> tuple[LineLabel, ...]:
    """Return the labels of the lines in one run, by rising order; at one order a finding replaces a known line."""
    rig, ratio = outcome.before.model.rig, kinematics_of(outcome.completed).ratio
    known = list(_lines(rig, shown, ratio))
    listed: list[LineLabel] = []
    for candidate in outcome.after.accepted:
        fitted = tuple(outcome.completed.part(part.name) for part in candidate.parts)
        for part in fitted:
            rig = rig + part
        lines = _lines(rig, shown, ratio)
        new = [
            line for line in lines
            if not _near(line.order, [one.order for one in known if one.amplitude >= line.amplitude])
        ]  # fmt: skip
        least = _WEAK * max((line.amplitude for line in new), default=0.0)
        text = candidate.mechanism.replace("_", " ")
        listed += [LineLabel(line.order, text, FOUND) for line in new if line.amplitude > least]
    listed += [LineLabel(order, "unexplained", UNEXPLAINED) for order in _unexplained(outcome.left, shown, ratio)]
    listed += [LineLabel(line.order, line.source.replace("_", " "), KNOWN) for line in known]
    kept: list[LineLabel] = []
    for label in listed:
        if not _near(label.order, [other.order for other in kept]):
            kept.append(label)
    return tuple(sorted(kept, key=lambda label: label.order))


def is_line(mismatch: Mismatch) -> bool:
    """Return whether a mismatch is one spectral line, not a band."""
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


def _unexplained(left: Sequence[Mismatch], shown: Compared, ratio: float) -> Iterator[float]:
    turns = _per_order(shown, ratio)
    for each in left:
        if is_line(each) and each.domain == "order":
            yield each.at * (ratio if each.axis == "motor_shaft" else 1.0)
        elif is_line(each) and turns > 0:
            yield each.at / turns
