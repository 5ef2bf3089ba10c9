"""What a model says the features of a run should be: by its linear twin, or measured on its simulations."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.added_signals import added_signals, moving_zero
from torquerig.diagnosis.expecting.rounding_noise import rounded_lines, rounding_density, rounding_tolerance
from torquerig.diagnosis.expecting.skirts import skirts
from torquerig.diagnosis.expecting.sway import Sway
from torquerig.diagnosis.linear.winding import wound_torque
from torquerig.diagnosis.looking.features import POINTS, Features
from torquerig.diagnosis.looking.route import Routes
from torquerig.diagnosis.looking.turning import STEPS, Turning
from torquerig.inference.features.regression import HANN_NOISE
from torquerig.inference.places import frequency
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin, passed, sources
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load
from torquerig.sensor_stages.band_noise import BandNoise
from torquerig.sensor_stages.noise import WhiteNoise

Floats = NDArray[np.float64]

_ZERO_ERROR = 0.01  # [N m] no sensor's zero is known to better
_KNOWN = 0.1  # [1] of a load's power: who knows it better knows it
_LOAD_TOLERANCE = 0.05  # [1] of the slow torque: near standstill no two rigs are alike, and a load comes and goes
_MISTIMED = 0.04  # [s] a reversal that was simulated and not measured may come so much earlier or later
_FLANK = 0.1  # of the density at the resonance: below it, a mode's flanks begin
_RINGING_SHAPE = 0.6  # [1] of the density's logarithm: a mode's reading may be a displacement, a speed or between


@dataclass(frozen=True)
class Expectation:
    """Expected features of one run, shapes as in ``Features``.

    Parameters
    ----------
    power : ndarray, shape (bands,)
        Density beside the lines [(N m)^2/Hz].
    amplitude : ndarray, shape (stretches, places)
        Size of the lines [N m].
    variance : ndarray, shape (stretches, places)
        Of the real and of the imaginary part of a measured amplitude, from what is random [(N m)^2].
    level, level_variance : ndarray, shape (parts,)
        [N m], [(N m)^2].
    turning : ndarray, shape (blocks,), or None
        Torque of the blocks of a run that turns back [N m].
    load_share : ndarray, shape (bands,)
        Part of ``power`` that random loads make [1].
    load_doubt : float
        One sigma by which the logarithm of all that random loads make may be off in the run, 0 where known [1].
    power_tolerance, amplitude_tolerance : float or ndarray
        What chance in an effect beyond the twin may add: of the density's logarithm [1], of an amplitude [N m].
    turning_tolerance : float or ndarray, shape (blocks,)
        What chance in the load and what nobody knows of a contact near standstill may add [N m].
    """

    power: Floats
    amplitude: Floats
    variance: Floats
    level: Floats
    level_variance: Floats
    turning: Floats | None = None
    load_share: Floats = field(default_factory=lambda: np.zeros(0))
    load_doubt: float = 0.0
    power_tolerance: float | Floats = 0.0
    amplitude_tolerance: float | Floats = 0.0
    turning_tolerance: float | Floats = 0.0


@dataclass(frozen=True)
class _Shown:
    """Where lines show: in the density of bands, else as amplitudes, shape (stretches, places).

    ``doubt`` is by how much the phase of a guest, which nobody knows, may change an amplitude.
    """

    power: Floats
    amplitude: Floats
    doubt: Floats

    def add(self, seen: Features, routes: Routes, size: Floats) -> None:
        """Add lines to the places that show them in each stretch, as powers; where none does, to their bands.

        ``size`` is of shape (lines, stretches).
        """
        own = size[routes.line, routes.row] * routes.part
        for turn in routes.turns:
            at = routes.row[turn], routes.column[turn]
            before = self.amplitude[at]
            both = np.hypot(before, own[turn])
            self.amplitude[at] = both
            crossed = routes.guest[turn] * before * own[turn] / np.maximum(np.sqrt(2) * both, 1e-12)
            self.doubt[at] = np.hypot(self.doubt[at], crossed)
        self.power[:] += _in_bands(routes, size, seen)

    def doubt_by(self, seen: Features, orders: Floats, size: Floats, bands: Floats) -> None:
        """Put lines that may stand at orders into the doubt of the places that show them, or their density into bands.

        ``size`` is of shape (orders, stretches).
        """
        if not self.doubt.size or not orders.size:
            return
        routes = seen.routes(orders)
        squares = (size[routes.line, routes.row] * routes.part) ** 2
        at = routes.row * self.doubt.shape[1] + routes.column
        added = np.bincount(at, weights=squares, minlength=self.doubt.size).reshape(self.doubt.shape)
        self.doubt[:] = np.sqrt(self.doubt**2 + added)
        bands += _in_bands(routes, size, seen)


def _in_bands(routes: Routes, size: Floats, seen: Features) -> Floats:
    """Return the density in each band that lines which no place shows have there, shape (bands,)."""
    density = 0.5 * (size[routes.unplaced] ** 2).mean(axis=1) / seen.width[routes.band]
    return np.bincount(routes.band, weights=density, minlength=seen.band.size).astype(np.float64)


def expected(rig: Rig, seen: Features) -> Expectation:
    """Return what the linear twin of ``rig`` expects of the run of ``seen``."""
    observed = seen.observed
    placed = rig.at(observed.run)
    twin = Twin(placed)
    if seen.turning is not None:
        return _turning(twin, seen, seen.turning)
    added = added_signals(twin, seen)
    load = twin.load_power_between(*seen.band_edges)
    power = load + _noise(placed, seen) + added.power
    points = np.abs(seen.speed).mean()[None] if observed.steady else np.abs(seen.speed).ravel()
    stretches = len(seen.stretches)
    balance = quasi_static(twin, speed=seen.speed.mean(axis=1), acceleration=seen.acceleration)
    shown = _Shown(power, *(np.zeros((stretches, len(seen.places))) for _ in range(2)))
    sizes = _sizes(twin, points, balance.motor, steady=observed.steady)
    sway = Sway(twin, seen, turns=np.abs(seen.speed).mean(axis=1) / (2 * pi), motor=balance.motor)
    if sway.lines and shown.amplitude.size:
        shown.add(seen, seen.routes(sway.orders[:, 0]), sizes * sway.left)
    if added.tones and shown.amplitude.size:
        tones = Routes.of([seen.route(frequency(tone)) for tone, _ in added.tones])
        shown.add(seen, tones, np.repeat([[volts] for _, volts in added.tones], stretches, axis=1))
    sides = np.zeros(power.size)
    shown.doubt_by(seen, *sway.beside(sizes, power), sides)
    level = np.repeat(balance.sensor, len(seen.parts) // stretches) + added.level
    beside = (skirts(twin, seen) if seen.observed.steady else np.zeros(power.size)) + sides
    power = power + beside
    flank = np.where(added.ringing < _FLANK * np.max(added.ringing, initial=0.0), added.ringing, 0.0)
    shape = np.hypot(_RINGING_SHAPE * flank / power, np.log1p(added.carried / power))
    tolerance = np.hypot(beside / power, shape)
    doubtful = np.hypot(added.impacts, shown.doubt)
    for step in added.codes:
        doubtful = np.hypot(doubtful, rounded_lines(step, dither=float(np.sqrt(np.trapezoid(power, seen.band)))))
        rounding, doubt = _rounded(step, seen, power, shown.amplitude)
        power, tolerance = power + rounding, np.hypot(tolerance, doubt)
    return Expectation(
        power=power,
        load_share=load / power,
        load_doubt=_load_doubt(twin),
        power_tolerance=tolerance,
        amplitude_tolerance=doubtful,
        amplitude=shown.amplitude,
        variance=amplitude_variance(seen, floor_of(seen, power)),
        level=level,
        level_variance=_level_variance(twin, seen, shown.amplitude),
    )


def _load_doubt(twin: Twin) -> float:
    """Return how far the power that random loads make may be off as a whole [1]: much where the rig runs idle.

    They are stated as parts of their mean, which is known no better than the sensor's zero, and what shakes an idle rig
    need not be what shakes a loaded one. Power goes with the square.
    """
    mean = sum(abs(term.process.mean) for term in twin.terms if isinstance(term, Load))
    doubt = 2 * _ZERO_ERROR / mean if mean else 0.0
    return doubt if doubt > _KNOWN else 0.0


def _rounded(step: float, seen: Features, power: Floats, amplitude: Floats) -> tuple[Floats, Floats]:
    """Return the density that coarse codes add, and how far the logarithm of the sum may be off."""
    sizes, at = amplitude.mean(axis=0), seen.line_frequency.mean(axis=(0, 2))
    rate = seen.observed.rate
    added = rounding_density(step, rate=rate, frequency=seen.band, power=power, lines=at, sizes=sizes)
    spread = np.sqrt(np.trapezoid(power, seen.band) + 0.5 * float((sizes**2).sum()))
    return added, rounding_tolerance(step, added, power + added, spread=float(spread))


def _turning(twin: Twin, seen: Features, blocks: Turning) -> Expectation:
    """Return the slow torque of each block and its zero: the shafts' own ringing dies out within one."""
    step = blocks.size / STEPS / seen.observed.rate
    gained = np.gradient(blocks.course, step)
    wound = wound_torque(twin, speed=blocks.course, acceleration=gained, step=step, start=blocks.first)
    torque = blocks.mean_of(wound.torque)
    tolerance = np.hypot(blocks.mean_of(wound.tolerance), _LOAD_TOLERANCE * torque)
    if not seen.observed.angle_measured:
        tolerance = np.hypot(tolerance, blocks.mean_of(np.abs(np.gradient(wound.torque, step))) * _MISTIMED)
    torque = torque + moving_zero(twin, seen.observed, blocks.start, blocks.start + blocks.length)
    none = np.zeros((0, len(seen.places)))
    return Expectation(
        np.zeros(0), none, none, np.zeros(0), np.zeros(0), turning=torque, turning_tolerance=tolerance
    )  # fmt: skip


def _sizes(twin: Twin, points: Floats, motor: Floats, *, steady: bool) -> Floats:
    """Amplitude of each line in each stretch; where the speed moves, as a regression over the stretch would see it."""
    lines = twin.lines()
    if not lines:
        return np.zeros((0, motor.size))
    orders = np.array([line.order for line in lines])[:, None]
    at_each = passed([line.transfer for line in lines], np.maximum(orders * points / (2 * pi), 0.05))
    gain = np.abs(at_each if steady else at_each.reshape(len(lines), -1, POINTS).mean(axis=2))
    return np.asarray(gain * sources(lines, motor))


def _noise(rig: Rig, seen: Features) -> Floats:
    """Density of what noise the measuring chain adds in each band [(N m)^2/Hz]."""
    unit = seen.observed.torque_unit
    power = np.zeros(seen.band.size)
    for stage in rig.stages():
        if isinstance(stage, WhiteNoise):
            power += unit**2 * stage.density(seen.band, seen.observed.rate)
        elif isinstance(stage, BandNoise):
            power += unit**2 * stage.density_between(*seen.band_edges)
    return power


def floor_of(seen: Features, power: Floats) -> Floats:
    """Return the density that lines stand in: as measured, or a model lacking a line would raise its noise for it."""
    if seen.floor.size != power.size:
        return power
    return np.asarray(np.where(np.isfinite(seen.floor), seen.floor, power))


def amplitude_variance(seen: Features, power: Floats) -> Floats:
    """Return the spread of regressed amplitudes: density over duration, at the frequencies that each line passes."""
    at = np.log(np.maximum(seen.line_frequency, seen.band[0]))
    window = HANN_NOISE if seen.observed.steady else 1.0
    density = np.maximum(np.interp(at, np.log(seen.band), power).mean(axis=2), seen.beneath)
    return np.asarray(window * density / seen.duration[:, None] * seen.widening)


def _level_variance(twin: Twin, seen: Features, amplitude: Floats) -> Floats:
    """Spread of a part's mean: slow variation of the load, and a hundredth of the lines that turn slowly."""
    slow = sum(
        (term.process.mean * getattr(term.process, "slow_rms", 0.0)) ** 2
        for term in twin.terms
        if isinstance(term, Load)
    )
    cutoff = max((getattr(t.process, "slow_cutoff", 1.0) for t in twin.terms if isinstance(t, Load)), default=1.0)
    duration = np.array([part.stop - part.start for part in seen.parts]) / seen.observed.rate
    lines = np.repeat((0.02**2 * amplitude**2).sum(axis=1), len(seen.parts) // len(seen.stretches))
    return np.asarray(slow * np.minimum(1.0, 1 / (2.2 * cutoff * duration)) + lines)
