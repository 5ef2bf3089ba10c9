"""How far the features of a run lie from what a model expects, each in units of its own spread."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.expectation import Expectation
from torquerig.diagnosis.fitting.least_squares import robust_square
from torquerig.diagnosis.looking.bands import BANDS_PER_OCTAVE
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.turning import Turning

Floats = NDArray[np.float64]

# what a model may be wrong by before it counts [relative]: details of a real rig that nobody models
BAND_TOLERANCE, LINE_TOLERANCE, RAMP_LINE_TOLERANCE, LEVEL_TOLERANCE = 0.05, 0.04, 0.06, 0.01
# [1] of the density's logarithm: the pulses of a random load leave dips at frequencies of their own, but no peaks
DIP_TOLERANCE, WIDE_TOLERANCE = 1.0, 0.3
_TWO_OCTAVES = 2 * BANDS_PER_OCTAVE
LEVEL_FLOOR = 0.002  # [N m]
NONLINEARITY = 1.5e-4  # of the largest line: sensors are of class 0.03 at best, and what bends makes combined lines
TURNING_FLOOR = 0.015  # [N m]
# an angle that was not measured smears a line of the motor by so much of its amplitude per order [1]
_UNMEASURED_ANGLE = 0.015
_GATHERED = 0.08  # steady lines are gathered over their smeared width and lose little [1]
_ALL_STRAYED = 50.0  # logarithm [1]: nothing coherent is left
_REBUILT = 0.7  # [1] of the density's logarithm: a cubic over a hit at its limit is lower than the hit
BEND = 4.0  # residuals beyond this count by their size, no longer by their square


@dataclass(frozen=True)
class Misfit:
    """Residuals of one run in units of their spread; what cannot be seen is 0.

    Parameters
    ----------
    bands : ndarray, shape (bands,)
    lines : ndarray, shape (places,) in steady runs, (stretches, places) else
    level : ndarray, shape (parts,)
    price : ndarray, shape (parts + octaves // 2 + 1,)
        What a model pays beside: for calling its levels random (root of the logarithm of their variance over the
        floor), for a load whose spectrum is off over two octaves and more, which no dip explains, and for one that is
        off as a whole.
    turning : ndarray, shape (blocks,)
        Only of runs that turn back.
    level_spread : ndarray, shape (parts,)
        What the model calls chance in each level, and the tolerance [N m]; empty of runs that turn back.
    """

    bands: Floats
    lines: Floats
    level: Floats
    turning: Floats = field(default_factory=lambda: np.zeros(0))
    price: Floats = field(default_factory=lambda: np.zeros(0))
    level_spread: Floats = field(default_factory=lambda: np.zeros(0))

    def all(self) -> Floats:
        """Return every residual in one row, shape (features,)."""
        return np.concatenate([self.bands, self.lines.ravel(), self.level, self.turning])

    def slow(self) -> Misfit:
        """Return the residuals of the slow torque alone."""
        return replace(self, bands=np.zeros(0), lines=np.zeros(0))

    def as_sure_as(self, other: Misfit) -> Misfit:
        """Return the residuals with levels in the spreads of ``other`` where these are smaller.

        What a model misses widens what it calls chance, until little of it shows; in those of a better one it does.
        """
        if self.level_spread.size == 0 or self.level_spread.shape != other.level_spread.shape:
            return self
        return replace(self, level=self.level * np.maximum(1.0, self.level_spread / other.level_spread))

    def paid(self) -> Floats:
        """Return every residual and what the model pays beside, as a fit minimises them."""
        return np.concatenate([self.all(), self.price])

    def scaled(self, factor: float) -> Misfit:
        """Return the residuals times ``factor``."""
        if factor == 1.0:
            return self
        return replace(
            self, bands=self.bands * factor, lines=self.lines * factor, level=self.level * factor,
            turning=self.turning * factor,
        )  # fmt: skip

    @property
    def seen(self) -> int:
        """How many features there are to see."""
        return self.bands.size + int(np.count_nonzero(self.lines)) + self.level.size + self.turning.size


def misfit(seen: Features, model: Expectation) -> Misfit:
    """Return the residuals of a run against a model."""
    if seen.turning is not None and model.turning is not None:
        return _turning(seen.turning, model.turning, model.turning_tolerance)
    if seen.power.size:
        excess = _band_excess(seen, model)
        beyond = np.square(model.power_tolerance) + np.where(excess < 0, DIP_TOLERANCE * model.load_share, 0.0) ** 2
        spread = np.sqrt(1 / seen.count + BAND_TOLERANCE**2 + beyond)
        gain = _load_gain(excess, spread, model)
        bands = (excess - gain * model.load_share) / spread
        wide = np.append(_wide((excess - gain) * model.load_share), gain / model.load_doubt if gain else 0.0)
    else:
        bands, wide = np.array([]), np.array([])
    lines = _steady_lines(seen, model) if seen.observed.steady else _moving_lines(seen, model)
    least = LEVEL_FLOOR**2 + (LEVEL_TOLERANCE * model.level) ** 2
    spread = np.sqrt(model.level_variance + least)
    price = np.concatenate([np.sqrt(called_chance(model)), wide])
    return Misfit(bands, lines, (seen.level - model.level) / spread, price=price, level_spread=spread)


def called_chance(model: Expectation) -> Floats:
    """Return twice the logarithm of the spread that a model calls chance in each level, over the floor; shape (parts,).

    What a likelihood charges for a wide guess, which misses little and foretells little.
    """
    return np.asarray(np.log1p(model.level_variance / LEVEL_FLOOR**2))


def _band_excess(seen: Features, model: Expectation) -> Floats:
    """Return the logarithm of measured over expected density in each band, 0 where lines leave nothing.

    Of a run with rebuilt moments, whose ends ring through the spectrum, only what the model has too much.
    """
    if not seen.observed.rebuilt:
        return np.nan_to_num(np.log(seen.power / model.power))
    return np.minimum(np.nan_to_num(np.log(seen.floor / model.power)) + _REBUILT, 0.0)


def _load_gain(excess: Floats, spread: Floats, model: Expectation) -> float:
    """Return by how much the logarithm of all that random loads make is off, as far as that may be [1].

    Least squares over the bands, the gain itself a residual in units of ``load_doubt``.
    """
    if not model.load_doubt:
        return 0.0
    weight = model.load_share / spread
    return float(weight @ (excess / spread) / (weight @ weight + model.load_doubt**-2))


def _wide(excess: Floats) -> Floats:
    """Return the mean excess of each two octaves in units of what a load's spectrum may be off."""
    whole = excess[: excess.size // _TWO_OCTAVES * _TWO_OCTAVES]
    return np.asarray(whole.reshape(-1, _TWO_OCTAVES).mean(axis=1) / WIDE_TOLERANCE)


def robust(residuals: Floats) -> Floats:
    """Return the residuals with the large ones pulled in, so that no single one rules a fit (pseudo-Huber)."""
    return np.asarray(np.sign(residuals) * np.sqrt(robust_squares(residuals)))


def robust_squares(residuals: Floats) -> Floats:
    """Return the squares of what ``robust`` returns, which for large residuals grow by their size."""
    return np.asarray(robust_square(residuals, BEND))


def misfit_sum(misfits: Sequence[Misfit]) -> float:
    """Return the sum of squares of the robust residuals of all runs: about the number of features for a true model."""
    return float(sum(robust_squares(each.paid()).sum() for each in misfits))


def missed_alone(misfits: Sequence[Misfit]) -> float:
    """Return the same of the features alone, without what a model pays beside."""
    return float(sum(robust_squares(each.all()).sum() for each in misfits))


def _turning(seen: Turning, model: Floats, tolerance: Floats | float) -> Misfit:
    """Blocks of a run that turns back; what lines could do is taken out, neighbours are about half independent."""
    spread = np.sqrt(TURNING_FLOOR**2 + np.square(tolerance))
    none = np.zeros(0)
    return Misfit(none, none, none, seen.without_lines(seen.torque - model, spread) / np.sqrt(2))


def _steady_lines(seen: Features, model: Expectation) -> Floats:
    """All stretches together: power of the line over what chance leaves, against the expected size.

    The tolerance is of the geometric mean of both, so that too large a model is as wrong as too small a one.
    """
    shown = np.isfinite(seen.amplitude)
    count = np.maximum(shown.sum(axis=0), 1)
    power = np.where(shown, np.abs(seen.amplitude) ** 2, 0.0).sum(axis=0) / count
    # where two lines stand side by side, another place may show one of them in the next stretch
    chance, meant = (
        np.where(shown, each, 0.0).sum(axis=0) / count for each in (2 * model.variance, model.amplitude**2)
    )
    size, expected = np.sqrt(np.maximum(power - chance, 0.0)), np.sqrt(meant)
    tolerance = np.hypot(LINE_TOLERANCE, _smearing(seen))
    beyond = np.where(shown, model.amplitude_tolerance, 0.0).sum(axis=0) / count
    bent = NONLINEARITY * min(expected.max(initial=0.0), size.max(initial=0.0))
    spread = np.sqrt(chance / count + tolerance**2 * size * expected + beyond**2 + bent**2)
    return np.asarray((size - expected) / np.where(shown.any(axis=0), spread, np.inf))


def _moving_lines(seen: Features, model: Expectation) -> Floats:
    """Each stretch by itself; neighbouring ones are about half independent. Smearing only makes lines smaller."""
    shown = np.isfinite(seen.amplitude)
    size = np.abs(np.where(shown, seen.amplitude, 0.0))
    expected = np.sqrt(model.amplitude**2 + model.variance)
    bent = NONLINEARITY * np.minimum(model.amplitude.max(axis=1, initial=0.0), size.max(axis=1, initial=0.0))[:, None]
    beyond = np.square(model.amplitude_tolerance) + bent**2
    tolerated = RAMP_LINE_TOLERANCE**2 * size * expected + _strayed(seen, size, expected)
    spread = np.sqrt(model.variance + tolerated + beyond)
    return np.asarray(np.where(shown, (size - expected) / spread, 0.0) / np.sqrt(2))


def _strayed(seen: Features, size: Floats, expected: Floats) -> Floats:
    """Return what a course that was not measured takes from each line and spreads to its neighbours [(N m)^2].

    A phase that strays by sigma rad leaves exp(-sigma^2 / 2) of a line: where less is seen, the line is not so large,
    and its neighbours are not excused by what it does not hold.
    """
    strays = _smearing(seen)
    lost = np.square(strays * np.minimum(expected, size * np.exp(np.minimum(strays**2 / 2, _ALL_STRAYED))))
    if not lost.any():
        return lost
    at = seen.line_frequency.mean(axis=2) * seen.duration[:, None]
    apart = np.square(at[:, :, None] - at[:, None, :])
    return np.asarray((lost[:, None, :] / (1 + apart)).sum(axis=2))


def _smearing(seen: Features) -> Floats:
    """Relative uncertainty of each line's amplitude for want of an encoder, shape (places,)."""
    if seen.observed.angle_measured:
        return np.zeros(len(seen.places))
    if seen.observed.steady:
        return np.array([_GATHERED if place.domain == "order" else 0.0 for place in seen.places])
    return np.array([_UNMEASURED_ANGLE * place.at if place.domain == "order" else 0.0 for place in seen.places])
