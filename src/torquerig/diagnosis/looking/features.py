"""What is compared of a run: its lines, its level, and the spectrum of what is left."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.bands import bands, no_bands, spectrum
from torquerig.diagnosis.looking.observed import Observed, Stretch
from torquerig.diagnosis.looking.route import Route, Routes
from torquerig.diagnosis.looking.stretch_lines import StretchLines, stretch_lines
from torquerig.diagnosis.looking.turning import Turning, turning, turns_back
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.inference.features.regression import hann_transform
from torquerig.inference.places import RESOLVED, RESOLVED_WELL, SAME_ORDER, Place, order

Floats = NDArray[np.float64]

_PARTS = 4  # of a stretch of a steady run
POINTS = 9  # speeds kept of each stretch
_KEPT = 256  # sets of lines whose routes are kept


@dataclass(frozen=True, kw_only=True, eq=False)
class Features:
    """Numbers of one run, the same for a recording and for a simulation.

    Parameters
    ----------
    held : bool or None
        Which stretches: those that fits may see (False), may not see (True), or all (None).
    stretches : tuple of Stretch
        The stretches looked at.
    places : tuple of Place
        The lines that were asked for.
    amplitude : ndarray, shape (stretches, places)
        Complex [N m]; NaN where a stretch cannot show the line (too slow, too fast, or another stands there).
    parts : tuple of Stretch
        Whose mean torque is compared: quarters of the stretches of steady runs, where a zero may settle within a
        second, else the stretches.
    level : ndarray, shape (parts,)
        Mean torque [N m], the lines' share taken out.
    speed : ndarray, shape (stretches, POINTS)
        Of the motor [rad/s], along each stretch.
    duration, acceleration : ndarray, shape (stretches,)
        [s], [rad/s^2] of the motor.
    band : ndarray, shape (bands,)
        Middle of each band [Hz].
    power : ndarray, shape (bands,)
        Mean one-sided density [(N m)^2/Hz] of what the lines leave, NaN where they leave nothing and in all bands of a
        run with rebuilt moments; empty where the speed moves.
    floor : ndarray, shape (bands,)
        The same as measured, of a run with rebuilt moments too: what its lines stand in, and what no model may exceed.
    count : ndarray, shape (bands,)
        Independent values behind each ``power``.
    width : ndarray, shape (bands,)
        Of each band [Hz].
    widening : float or ndarray, shape (stretches, places)
        Factor on the variance of the amplitudes where others stand beside them or a smeared line was gathered.
    reach : float or ndarray, shape (stretches, places)
        Bins of a stretch within which whatever stands there counts as the line.
    beneath : float or ndarray, shape (stretches, places)
        Density that a smeared line stands in, or that leaks into one of a moving run [(N m)^2/Hz]; 0 where the bands or
        the model tell it.
    unknown : tuple of Place
        Those of the places whose lines no model had when the run was looked at.
    turning : Turning or None
        Of a run that turns back, which has this and none of the others.
    """

    observed: Observed
    held: bool | None
    stretches: tuple[Stretch, ...]
    parts: tuple[Stretch, ...]
    places: tuple[Place, ...]
    amplitude: NDArray[np.complex128]
    level: Floats
    speed: Floats
    duration: Floats
    acceleration: Floats
    band: Floats
    power: Floats
    floor: Floats
    count: Floats
    width: Floats
    turning: Turning | None = None
    widening: float | Floats = 1.0
    reach: float | Floats = RESOLVED
    beneath: float | Floats = 0.0
    unknown: tuple[Place, ...] = ()
    _routes: dict[Place, Route] = field(default_factory=dict, repr=False, compare=False)
    _of_orders: dict[float, Route] = field(default_factory=dict, repr=False, compare=False)
    _together: dict[bytes, Routes] = field(default_factory=dict, repr=False, compare=False)

    @cached_property
    def line_frequency(self) -> Floats:
        """Where each place stands along each stretch [Hz], shape (stretches, places, POINTS)."""
        turning = np.array([place.domain == "order" for place in self.places], dtype=bool)
        at = np.array([place.at for place in self.places])
        revolutions = np.abs(self.speed)[:, None, :] / (2 * pi)
        return np.asarray(np.where(turning[None, :, None], at[None, :, None] * revolutions, at[None, :, None]))

    @cached_property
    def band_edges(self) -> tuple[Floats, Floats]:
        """Lower and upper edge of each band [Hz], of which ``band`` is the geometric mean."""
        low = np.sqrt(0.25 * self.width**2 + self.band**2) - 0.5 * self.width
        return low, low + self.width

    @cached_property
    def untoned(self) -> Observed:
        """The run, its lines of fixed frequency taken out."""
        return without_tones(self.observed, self.places)

    def without(self, places: Sequence[Place]) -> Features:
        """Return the same features, the lines at ``places`` not shown."""
        amplitude = self.amplitude.copy()
        amplitude[:, [index for index, place in enumerate(self.places) if place in places]] = np.nan
        return replace(self, amplitude=amplitude, _routes={}, _of_orders={}, _together={})

    def route(self, place: Place) -> Route:
        """Return where a line shows: in which place of each stretch, else in which band."""
        if place not in self._routes:
            self._routes[place] = self._routed(place)
        return self._routes[place]

    def routes(self, orders: Floats) -> Routes:
        """Return where lines at orders of the motor show, shape (lines,)."""
        key = orders.tobytes()
        if key not in self._together:
            if len(self._together) >= _KEPT:
                self._together.clear()
            self._together[key] = Routes.of([self._of_order(at) for at in orders.tolist()])
        return self._together[key]

    def _of_order(self, at: float) -> Route:
        if at not in self._of_orders:
            self._of_orders[at] = self.route(order(at))
        return self._of_orders[at]

    def _routed(self, place: Place) -> Route:
        at = np.array([place.frequency(float(speed)) for speed in np.abs(self.speed).mean(axis=1)])
        apart = np.abs(self.line_frequency.mean(axis=2) - at[:, None]) * self.duration[:, None]
        same = [other.domain == place.domain and abs(other.at - place.at) < SAME_ORDER for other in self.places]
        apart[:, same] = 0.0
        apart[~np.isfinite(self.amplitude)] = np.inf
        column = np.argmin(apart, axis=1)
        nearest = apart[np.arange(at.size), column]
        reach = np.broadcast_to(self.reach, apart.shape)[np.arange(at.size), column]
        rows = np.flatnonzero(nearest < reach)
        alone = self.observed.steady & (reach[rows] <= RESOLVED_WELL)
        part = np.where(alone, hann_transform(nearest[rows]), 1.0)
        guest = (nearest[rows] > 0) & (nearest[rows] < RESOLVED_WELL)
        mean, band = float(at.mean()), None
        if self.power.size and self.band[0] < mean < self.band[-1]:
            band = int(np.argmin(np.abs(np.log(self.band / mean))))
        return Route(rows, column[rows], part, guest, band)


def features(
    observed: Observed, places: Sequence[Place], *, held: bool | None = False, unknown: Sequence[Place] = ()
) -> Features:
    """Return the features of the stretches that fits may see (``held`` False), may not see (True), or all (None).

    ``unknown`` are those of the places whose lines no model has yet.
    """
    if turns_back(observed):
        return _turning_features(observed, places, held=held, unknown=unknown)
    stretches = [stretch for stretch in observed.stretches if held is None or stretch.held == held]
    looks, levels, spectra = list[StretchLines](), list[float](), []
    parts = [part for stretch in stretches for part in _parts(observed, stretch)]
    for stretch in stretches:
        look = stretch_lines(observed, stretch, places)
        looks.append(look)
        own = [part for part in parts if stretch.start <= part.start < stretch.stop]
        levels += [float(look.slow[part.start - stretch.start : part.stop - stretch.start].mean()) for part in own]
        if observed.steady:
            spectra.append(spectrum(look.rest, observed.rate, look.at, smeared=observed.smearing))
    speeds = np.array([observed.speed[np.linspace(s.start, s.stop - 1, POINTS).astype(int)] for s in stretches])
    duration = np.array([(s.stop - s.start) / observed.rate for s in stretches])
    floor = bands(spectra, observed.rate, observed.notches) if spectra else no_bands(observed.rate)
    power = np.full_like(floor.power, np.nan) if observed.rebuilt else floor.power
    return Features(
        observed=observed, held=held, stretches=tuple(stretches), parts=tuple(parts), places=tuple(places),
        amplitude=np.array([look.amplitude for look in looks]), widening=np.array([look.widening for look in looks]),
        reach=np.array([look.reach for look in looks]), beneath=np.array([look.beneath for look in looks]),
        level=np.array(levels), unknown=tuple(unknown),
        speed=speeds, duration=duration, acceleration=(speeds[:, -1] - speeds[:, 0]) / duration,
        band=floor.middle, power=power, floor=floor.power, count=floor.count, width=floor.width,
    )  # fmt: skip


def _turning_features(
    observed: Observed, places: Sequence[Place], *, held: bool | None, unknown: Sequence[Place]
) -> Features:
    floor = no_bands(observed.rate)
    return Features(
        observed=observed, held=held, stretches=(), parts=(), places=tuple(places),
        amplitude=np.zeros((0, len(places)), dtype=complex), level=np.zeros(0), speed=np.zeros((0, POINTS)),
        duration=np.zeros(0), acceleration=np.zeros(0), band=floor.middle, power=floor.power, floor=floor.power,
        count=floor.count, width=floor.width, unknown=tuple(unknown),
        turning=turning(without_tones(observed, places), places, held=held, unknown=unknown),
    )  # fmt: skip


def _parts(observed: Observed, stretch: Stretch) -> list[Stretch]:
    if not observed.steady:
        return [stretch]
    edges = np.linspace(stretch.start, stretch.stop, _PARTS + 1).astype(int).tolist()
    return [Stretch(start, stop, stretch.held) for start, stop in pairwise(edges)]
