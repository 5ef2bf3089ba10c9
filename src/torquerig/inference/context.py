"""What hypotheses are proposed from: the fitted model, the features of the runs, and lines that no part explains."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import inf, pi

import numpy as np

from torquerig.inference.addition import DECADE, start_of
from torquerig.inference.blocks import STANDSTILL
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.likelihood import BAND, floor_density
from torquerig.inference.one_number import stated_again
from torquerig.inference.places import Place
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_line_power, expected_run
from torquerig.inference.prediction.skirts import Skirts, skirts_of, smears
from torquerig.inference.shafts import Shaft, shafts_of, whole_order
from torquerig.inference.undecided_lines import column_of
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Part, Rig

SHARE_OF_SIGNAL = 0.03  # [1] of the signal's standard deviation: median of the prior of an amplitude
SAME_MULTIPLE = 2e-3  # [1] relative: so near to a whole multiple of a line another one is its harmonic
_UNMEASURED = 6e-3  # [1] relative error of a found order where no angle was measured: half of what smears a line
_SAME_ORDER = 4e-3  # [1/rev] so near to an order of a shaft a line is taken to be at it
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
    moved : frozenset of Place
        Lines of the rig whose stated size has moved far to explain them. They are among ``lines`` too.
    """

    fit: Fit
    data: Data
    lines: tuple[FoundLine, ...]
    moved: frozenset[Place] = frozenset()

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
        return max(seen.largest_level for seen in self.data.seen)

    @cached_property
    def resolution(self) -> float:
        """Half a bin of the longest recording [Hz]: to so much the frequency of a tone is determined."""
        return 0.5 / max(seen.run.recording.duration for seen in self.data.seen)

    @cached_property
    def order_error(self) -> float:
        """Relative error of the orders of found lines [1]."""
        measured = all(seen.run.has_encoder for seen in self.data.seen)
        return SAME_MULTIPLE if measured else _UNMEASURED

    @cached_property
    def order_step(self) -> float:
        """A quarter of the distance at which the longest block separates two orders of the motor [1/rev]."""
        turned = [
            abs(segment.speed) * seen.duration_of(segment) / (2 * pi)
            for seen in self.data.seen for segment in seen.segments
        ]  # fmt: skip
        return 0.25 / max([1.0, *turned])

    def whole(self, place: Place, turns: float = 1.0) -> int | None:
        """Return the whole order that a found line is at on a shaft of so many turns per turn of the motor, or None."""
        return whole_order(place.at / turns, within=self.order_error) if place.domain == "order" else None

    @cached_property
    def turns_both_ways(self) -> bool:
        """Whether the motor turns forward in some and backward in other parts of the runs."""
        speeds = [seen.level_speed for seen in self.data.seen if seen.level_speed.size]
        least = STANDSTILL * max((float(np.abs(each).max()) for each in speeds), default=0.0)
        return any(each.max() > least for each in speeds) and any(each.min() < -least for each in speeds)

    def fastest(self, shaft: Shaft) -> float:
        """Return the largest speed of a shaft [rad/s]."""
        return max(float(np.abs(seen.level_speed).max(initial=0.0)) for seen in self.data.seen) * shaft.turns

    def bands_above(self) -> list[float]:
        """Return the middles of the bands [Hz], those first that exceed the model most in the sum over the runs."""
        excess: dict[float, float] = {}
        residual = all_residuals(self.data, self.fit.expected, self.fit.gains, self.fit.off)
        for seen, run in zip(self.data.seen, residual, strict=True):
            rows = np.flatnonzero(run.kind == BAND)
            middle = np.round(seen.bands.middle[run.at[rows]], 3)
            for at, value in zip(middle.tolist(), run.standardised[rows].tolist(), strict=True):
                excess[at] = excess.get(at, 0.0) + value
        return sorted((at for at, value in excess.items() if value > 0), key=lambda at: -excess[at])

    def top_residual(self, bands: int) -> float:
        """Return the mean standardised residual of the highest bands of all runs [1]."""
        values = list[float]()
        for run in all_residuals(self.data, self.fit.expected, self.fit.gains, self.fit.off):
            own = run.at[run.kind == BAND]
            if own.size:
                values += run.standardised[run.kind == BAND][own > own.max() - bands].tolist()
        return float(np.mean(values)) if values else 0.0

    def multiples(self, place: Place, *, most: int) -> dict[int, Place]:
        """Return the found lines at whole multiples of a place, itself included, by multiple."""
        answer = {1: place}
        for line in self.lines:
            multiple = round(line.place.at / place.at) if line.place.domain == place.domain else 0
            within = self.order_error if place.domain == "order" else SAME_MULTIPLE
            if 2 <= multiple <= most and abs(line.place.at / (multiple * place.at) - 1) < within:
                answer.setdefault(multiple, line.place)
        return dict(sorted(answer.items()))

    def at_orders(self, turns: float, orders: Iterable[float]) -> dict[float, Place]:
        """Return the found lines at orders [1/rev] of a shaft that turns ``turns`` times per turn of the motor."""
        answer: dict[float, Place] = {}
        for order in orders:
            within = max(self.order_error * order, self.order_step / turns, _SAME_ORDER)
            near = (
                (abs(line.place.at / turns - order), line.place) for line in self.lines if line.place.domain == "order"
            )
            apart, place = min(near, default=(inf, None), key=lambda one: one[0])
            if place is not None and apart < within:
                answer[order] = place
        return answer

    @cached_property
    def _skirts(self) -> list[tuple[Skirts | None, RunFeatures]]:
        """How the motor sways about the angle that is known, in each run."""
        return [(skirts_of(Twin(self.rig.at(seen.run.run)), seen.run, ""), seen) for seen in self.data.seen]

    def smeared(self, orders: Iterable[float]) -> list[float]:
        """Return the orders of the motor whose lines the sway spreads in some run so far that no search finds them.

        In the other runs they may be too weak. Those at which the rig has a line are left out.
        """
        known = [line.order for line in Twin(self.rig.at(self.data.seen[0].run.run)).lines()]
        return [
            order for order in orders
            if all(abs(order - other) > self.order_error * order for other in known)
            and any(smears(skirts, seen, order) for skirts, seen in self._skirts)
        ]  # fmt: skip

    def on_known_lines(self, orders: Iterable[float]) -> dict[float, Place]:
        """Return the places of lines of the rig that are at orders of the motor, by these."""
        found = {line.place for line in self.lines}
        known = {place for seen in self.data.seen for place in seen.places if place.domain == "order"} - found
        return {order: each for order in orders for each in known if abs(each.at / order - 1) < self.order_error}

    @cached_property
    def _stated(self) -> list[ExpectedRun]:
        """What the rig is expected to show with the numbers at their stated values that have moved far."""
        rig = turned(self.fit.rig, self.fit.knobs, stated_again(self.fit))
        return [expected_run(rig, seen) for seen in self.data.seen]

    def size_of(self, unit: Part, place: Place | None) -> tuple[float, float]:
        """Return by which factor ``unit`` explains the line at ``place``, and the median of the factor's prior.

        ``unit`` is a part whose amplitude is 1. The factor is the median over the segments that show the line, which no
        single one decides. Both are 0 where the part makes no line there. Without a place they follow from the bands.
        """
        rig = self.rig + unit
        if place is None:
            return self._size_in_bands(rig)
        gains, ratios = list[float](), list[tuple[float, float]]()
        for row, seen in enumerate(self.data.seen):
            if place not in seen.places:
                continue
            column = column_of(seen, place)
            model = self.fit.expected[row]
            without = self._stated[row] if place in self.moved else model
            added = np.sqrt(np.maximum((expected_line_power(rig, seen) - model.line_power)[:, column], 0.0))
            noise = floor_density(seen, model)[:, column]
            for index, segment in enumerate(seen.segments):
                if segment.line_count[column] > 0:
                    floor = segment.line_noise_bandwidth[column] * noise[index] + without.line_power[index, column]
                    size = float(np.sqrt(max(segment.line_power[column] - floor, 0.0)))
                    gains.append(float(added[index]))
                    ratios.append((float(added[index]), size))
        if not gains:
            return self._size_in_levels(rig)
        if max(gains) <= 0:
            return 0.0, 0.0
        found = sorted(size / gain for gain, size in ratios if gain > _REACHES * max(gains))
        return found[len(found) // 2], SHARE_OF_SIGNAL * self.signal / max(gains)

    def _size_in_levels(self, rig: Rig) -> tuple[float, float]:
        """Return the same of a line that no block shows, by the mean square of what mean torques lack."""
        found = list[tuple[float, float]]()
        for seen, model in zip(self.data.seen, self.fit.expected, strict=True):
            added = np.diag(expected_run(rig, seen).level_covariance - model.level_covariance)
            lacking = np.square(seen.level - model.level) - np.diag(model.level_covariance)
            found.append((float(added.sum()), float(lacking.sum())))
        if (largest := max(found)[0]) <= 0:
            return 0.0, 0.0
        ratios = sorted(lacks / added for added, lacks in found if added > _REACHES**2 * largest)
        mean = largest / max(seen.level.size for seen in self.data.seen)
        return float(np.sqrt(max(ratios[len(ratios) // 2], 0.0))), SHARE_OF_SIGNAL * self.signal / (2 * mean) ** 0.5

    def _size_in_bands(self, rig: Rig) -> tuple[float, float]:
        """Return the same of a line that is spread over bands, by all power there that the model lacks."""
        powers = list[tuple[float, float]]()  # what the part adds to each segment, and what lacks where it adds most
        for seen, model in zip(self.data.seen, self.fit.expected, strict=True):
            if not seen.segments:
                continue
            shown = np.isfinite(seen.band_power) * (seen.bands.high - seen.bands.low)
            added = (expected_run(rig, seen).density - model.density) * shown
            lacking = np.nan_to_num(seen.band_power - model.density) * shown
            raised = added > _REACHES * added.max(axis=1, keepdims=True)
            powers += zip((added * raised).sum(axis=1).tolist(), (lacking * raised).sum(axis=1).tolist(), strict=True)
        largest = max((added for added, _ in powers), default=0.0)
        if largest <= 0:
            return 0.0, 0.0
        ratios = sorted(lacks / added for added, lacks in powers if added > _REACHES**2 * largest)
        return float(np.sqrt(max(ratios[len(ratios) // 2], 0.0))), SHARE_OF_SIGNAL * self.signal / (2 * largest) ** 0.5


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
    context: Context, multiples: Mapping[int, Place | None], *, unit: Callable[[int], Part],
    knob: Callable[[int], Knob], median: float | None = None,
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
