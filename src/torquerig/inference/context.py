"""What hypotheses are proposed from: the fitted model, the features of the runs, and lines that no part explains."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.diagnosis.looking.places import Place
from torquerig.inference.addition import DECADE, start_of
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Data, Fit
from torquerig.inference.likelihood import floor_density
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.shafts import Shaft, shafts_of
from torquerig.rig.assembly import Part, Rig

SHARE_OF_SIGNAL = 0.03  # [1] of the signal's standard deviation: median of the prior of an amplitude
_SAME_MULTIPLE = 2e-3  # [1] relative: so near to a whole multiple of a line another one is its harmonic
_REACHES = 0.1  # of the largest response: a run in which a torque hardly reaches the sensor says little of its size


@dataclass(frozen=True, eq=False)
class Context:
    """The fitted model and what it leaves.

    Parameters
    ----------
    fit : Fit
    data : Data
    lines : tuple of FoundLine
        That no part of the model explains.
    """

    fit: Fit
    data: Data
    lines: tuple[FoundLine, ...]

    @cached_property
    def rig(self) -> Rig:
        """The model with its parameters at their estimates."""
        return self.fit.fitted_rig

    @cached_property
    def shafts(self) -> tuple[Shaft, ...]:
        """The shafts on which a torque may act."""
        return shafts_of(self.rig)

    @cached_property
    def signal(self) -> float:
        """Standard deviation of the compared signal [N m], the largest one of the runs."""
        return max(float(np.std(seen.run.torque)) for seen in self.data.seen)

    @cached_property
    def unit(self) -> float:
        """Torque per unit of the recorded channel [N m], without sign."""
        return abs(self.data.seen[0].unit)

    @cached_property
    def largest_level(self) -> float:
        """Largest mean torque of a part of a run [N m], without sign."""
        return max(float(np.abs(seen.level).max(initial=0.0)) for seen in self.data.seen)

    def fastest(self, shaft: Shaft) -> float:
        """Return the largest speed of a shaft [rad/s]."""
        return max(float(np.abs(seen.level_speed).max(initial=0.0)) for seen in self.data.seen) * shaft.turns

    def multiples(self, place: Place, *, most: int) -> dict[int, Place]:
        """Return the found lines at whole multiples of a place, itself included, by multiple."""
        answer = {1: place}
        for line in self.lines:
            multiple = round(line.place.at / place.at) if line.place.domain == place.domain else 0
            if 2 <= multiple <= most and abs(line.place.at / (multiple * place.at) - 1) < _SAME_MULTIPLE:
                answer.setdefault(multiple, line.place)
        return dict(sorted(answer.items()))

    def size_of(self, unit: Part, place: Place) -> tuple[float, float]:
        """Return by which factor ``unit`` explains the line at ``place``, and the median of the factor's prior.

        ``unit`` is a part whose amplitude is 1. The factor is the median over the segments that show the line, which no
        single one decides. Both are 0 where the part makes no line there.
        """
        rig = self.rig + unit
        gains, ratios = list[float](), list[tuple[float, float]]()
        for row, seen in enumerate(self.data.seen):
            if place not in seen.places:
                continue
            column = seen.places.index(place)
            model = self.fit.expected[row]
            added = np.sqrt(np.maximum((expected_run(rig, seen).line_power - model.line_power)[:, column], 0.0))
            noise = floor_density(seen, model)[:, column]
            for index, segment in enumerate(seen.segments):
                if segment.line_count[column] > 0:
                    floor = segment.line_noise_bandwidth[column] * noise[index] + model.line_power[index, column]
                    size = float(np.sqrt(max(segment.line_power[column] - floor, 0.0)))
                    gains.append(float(added[index]))
                    ratios.append((float(added[index]), size))
        if not gains or max(gains) <= 0:
            return 0.0, 0.0
        found = sorted(size / gain for gain, size in ratios if gain > _REACHES * max(gains))
        return found[len(found) // 2], SHARE_OF_SIGNAL * self.signal / max(gains)


def is_multiple(place: Place, order: float, *, most: int) -> bool:
    """Return whether a line is at one of the first multiples of an order of the motor."""
    multiple = round(place.at / order)
    near = abs(place.at / (max(multiple, 1) * order) - 1) < _SAME_MULTIPLE
    return place.domain == "order" and 1 <= multiple <= most and near


@dataclass
class Harmonics:
    """Amplitudes of a series of lines: prior medians by multiple, the parameters and where a fit of them begins."""

    medians: dict[int, float] = field(default_factory=dict)
    knobs: list[Knob] = field(default_factory=list)
    start: list[float] = field(default_factory=list)

    def row(self) -> tuple[float, ...]:
        """Return the medians from the first multiple to the last one, 0 where there is no line."""
        return tuple(self.medians.get(multiple, 0.0) for multiple in range(1, max(self.medians, default=0) + 1))


def harmonics(
    context: Context, multiples: dict[int, Place], *, unit: Callable[[int], Part], knob: Callable[[int], Knob],
    median: float | None = None,
) -> Harmonics:  # fmt: skip
    """Return amplitudes for the found multiples of a line.

    Parameters
    ----------
    unit : callable
        From a multiple to the part with the amplitude 1 at it, and none elsewhere.
    knob : callable
        From a multiple to its parameter.
    median : float, optional
        Of the prior; by default the one that makes ``SHARE_OF_SIGNAL`` at the sensor.
    """
    answer = Harmonics()
    for multiple, place in multiples.items():
        value, own = context.size_of(unit(multiple), place)
        if own:
            answer.medians[multiple] = own if median is None else median
            answer.knobs.append(knob(multiple))
            answer.start.append(start_of(value, answer.medians[multiple], DECADE))
    return answer
