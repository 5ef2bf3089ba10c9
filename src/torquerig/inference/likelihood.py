"""Log-likelihood of the features of a run under a model: standardised residuals and their standard deviations.

A power ``X`` that a model expects to be ``M`` has the residual ``ln X - ln M``; levels have that of their difference,
made independent by their covariance. Sampling errors follow from how many values a mean holds. Beside them stands what
a right model may be wrong by (``Discrepancy``), whose sizes are estimated together with the model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular
from scipy.special import digamma, polygamma

from torquerig.inference.features.common_changes import common_changes
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]

FEWEST = 1.2  # [1] independent values behind a band: the logarithm of a single one is far from normal
DEGREES_OF_FREEDOM = 8.0  # of Student's distribution: one odd feature in a hundred does not decide
_LARGE_COUNT = 1e12  # of a line without noise
_NOTHING = 1e-300  # keeps logarithms finite
_SINGULAR = 1e-12  # of the square of the largest level: no mean of samples is known to better
_WITHIN = 12**-0.5  # of a range: standard deviation of where in it something is
_SWEPT = 0.5  # of how a line varies over a segment: a response lags behind a sweep, and speeds have unequal shares
_MOST_EXCESS = 60.0  # [1] of the logarithm of a power; nothing measured is 26 orders of magnitude off


@dataclass(frozen=True)
class Discrepancy:
    """How far a right model may be off, beyond sampling errors.

    Parameters
    ----------
    line, band : float
        Standard deviation of the logarithm of a line's amplitude, and of a band's density [1].
    mode : float
        Relative standard deviation of the frequencies of the modes in a run [1]: contacts and belts are stiffer under
        load, and no rig is linear.
    modulation : float
        Amplitude of side lines relative to their line [1]: whatever a linear model leaves out, such as contacts and
        angles that sway, modulates each line by all that moves.
    level : float
        Relative standard deviation of a level [1].
    level_floor : float
        Standard deviation of any level, relative to the largest one of the run [1]: the zero from run to run, and what
        no law of friction says near standstill.
    """

    line: float = 0.05
    band: float = 0.08
    mode: float = 0.01
    modulation: float = 0.003
    level: float = 0.01
    level_floor: float = 0.002


@dataclass(frozen=True)
class Residuals:
    """Features of one run against a model.

    Parameters
    ----------
    value, sd : ndarray, shape (features,)
        Residual and its standard deviation: of lines and bands of the logarithm of the power [1], of levels of the
        whitened torque, relative to the largest level of the run [1].
    kind : ndarray of int, shape (features,)
        ``LINE``, ``BAND``, ``LEVEL`` or ``COMMON`` (what all lines have in common from block to block).
    at : ndarray, shape (features,)
        Index of place, band, part or contrast of blocks.
    segment : ndarray, shape (features,)
        Index of the segment; -1 for levels.
    """

    value: Floats
    sd: Floats
    kind: NDArray[np.int8]
    at: NDArray[np.intp]
    segment: NDArray[np.intp]

    @property
    def standardised(self) -> Floats:
        """Residuals over their standard deviations [1]."""
        return np.asarray(self.value / self.sd)


LINE, BAND, LEVEL, COMMON = 0, 1, 2, 3
KINDS_OF_SIZES = {
    "line": (LINE,), "band": (BAND,), "mode": (LINE, BAND), "modulation": (LINE, BAND), "level": (LEVEL,),
    "level_floor": (LEVEL,),
}  # fmt: skip


def residuals(seen: RunFeatures, model: ExpectedRun, off: Discrepancy) -> Residuals:
    """Return the residuals of a run; features that the run does not show are left out."""
    return _joined([residuals_of(seen, model, off, kind) for kind in _OF_KIND])


def residuals_of(seen: RunFeatures, model: ExpectedRun, off: Discrepancy, kind: int) -> Residuals:
    """Return the residuals of one kind of features."""
    return _OF_KIND[kind](seen, model, off)


def log_density(each: Residuals) -> float:
    """Return the log-likelihood of a run [nats]: Student's distribution of each standardised residual."""
    return log_density_of(each.standardised, each.sd)


def log_density_of(standardised: Floats, sd: Floats) -> float:
    """Return the same of standardised residuals and their standard deviations [nats]."""
    nu = DEGREES_OF_FREEDOM
    return float(np.sum(-0.5 * (nu + 1) * np.log1p(standardised**2 / nu) - np.log(sd)))


def weights(standardised: Floats) -> Floats:
    """Return the weights by which least squares follow the likelihood (iteratively reweighted) [1]."""
    nu = DEGREES_OF_FREEDOM
    return np.asarray((nu + 1) / (nu + standardised**2))


def deviance_moments() -> tuple[float, float]:
    """Return mean and variance of the deviance ``(nu + 1) ln(1 + z^2 / nu)`` of one standardised residual [1]."""
    nu = DEGREES_OF_FREEDOM
    mean = (nu + 1) * float(digamma(0.5 * (nu + 1)) - digamma(0.5 * nu))
    return mean, (nu + 1) ** 2 * float(polygamma(1, 0.5 * nu) - polygamma(1, 0.5 * (nu + 1)))


def floor_density(seen: RunFeatures, model: ExpectedRun) -> Floats:
    """Return the density below each line [(N m)^2/Hz], shape (segments, places): measured, else the model's."""
    bands = seen.bands
    power = np.log(np.maximum(np.where(np.isfinite(seen.band_power), seen.band_power, model.density), _NOTHING))
    at, middle = np.log(np.maximum(seen.line_frequency, bands.low[0])), np.log(bands.middle)
    return np.asarray(np.exp([np.interp(one, middle, own) for one, own in zip(at, power, strict=True)]))


def _lines(seen: RunFeatures, model: ExpectedRun, off: Discrepancy) -> Residuals:
    table = seen.lines
    shown = table.count > 0
    noise = (table.noise_bandwidth * floor_density(seen, model))[shown]
    power, count = model.line_power[shown], table.count[shown]
    total = np.maximum(power + noise, _NOTHING)
    scatter, lower = _of_logarithm(count * total**2 / np.maximum(2 * power * noise + noise**2, _NOTHING))
    modulated = np.log1p(off.modulation**2 * model.near_lines[shown] / total)
    bent = np.hypot(np.hypot(2 * off.line, off.mode * model.line_slope[shown]), _SWEPT * model.line_range[shown])
    simulated = _shown(model.line_error, shown)
    own = (bent**2 + model.line_beat[shown] + simulated**2) * (power / total) ** 2
    sd = np.sqrt(scatter + own + modulated**2)
    value = np.log(np.maximum(table.power[shown], _NOTHING) / total) + lower
    return _of(value, sd, LINE, shown)


def _bands(seen: RunFeatures, model: ExpectedRun, off: Discrepancy) -> Residuals:
    shown = np.isfinite(seen.band_power) & (seen.band_count >= FEWEST)
    density = np.log(np.maximum(model.density, _NOTHING))
    slope = np.gradient(density, np.log(seen.bands.middle), axis=1)[shown]
    scatter, lower = seen.kept.get("bands by chance", None, lambda: _of_logarithm(seen.band_count[shown]))
    modulated = np.log1p(off.modulation**2 * model.near_bands[shown] / np.maximum(model.density[shown], _NOTHING))
    simulated = _shown(model.density_error, shown)
    sd = np.sqrt(scatter + off.band**2 + (off.mode * slope) ** 2 + modulated**2 + simulated**2)
    value = np.log(np.maximum(seen.band_power[shown], _NOTHING)) - density[shown] + lower
    louder = np.sqrt(model.load_clumping / seen.segment_time)[:, None] * model.load_share
    return _of(*_with_common_factor(value, sd, louder, shown), BAND, shown)


def _of_logarithm(count: Floats) -> tuple[Floats, Floats]:
    """Return the variance of the logarithm of a mean of so many powers of noise, and by how much its mean is lower.

    The mean of n exponential variates is a gamma variate of the shape n. Its logarithm has the variance ``psi'(n)``,
    and a mean that is lower by ``ln n - psi(n)`` (Johnson, Kotz & Balakrishnan 1994, 17.8).
    """
    most = np.minimum(count, _LARGE_COUNT)
    return np.asarray(polygamma(1, most)), np.asarray(np.log(most) - digamma(most))


def _with_common_factor(value: Floats, sd: Floats, common: Floats, shown: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Return residuals and standard deviations made independent where those of a segment share a random factor.

    ``common`` is its standard deviation in each residual, shape (segments, bands). With a and z the standardised factor
    and residuals of a segment, ``C = I + a a'``: z becomes ``C^-1/2 z``, and ``ln det C`` is shared among all sd.
    """
    z, a = np.zeros(shown.shape), np.zeros(shown.shape)
    z[shown], a[shown] = value / sd, common[shown] / sd
    square, count = np.square(a).sum(axis=1, keepdims=True), np.maximum(shown.sum(axis=1, keepdims=True), 1)
    along = (a * z).sum(axis=1, keepdims=True) / np.maximum(square, _NOTHING)
    white = z + a * along * (1 / np.sqrt(1 + square) - 1)
    wider = sd * np.broadcast_to(np.exp(0.5 * np.log1p(square) / count), shown.shape)[shown]
    return white[shown] * wider, wider


def level_root(seen: RunFeatures, model: ExpectedRun, off: Discrepancy) -> Floats:
    """Return the lower triangular root of the covariance of the levels [N m], shape (levels, levels)."""
    largest = seen.largest_level
    parts = (off.level_floor * largest, off.level * model.level, seen.level_time_error * model.level_rate,
             _WITHIN * model.level_range, model.level_error)  # fmt: skip
    own = np.zeros(seen.level.size) + sum(np.square(part) for part in parts)
    least = _SINGULAR * largest**2 + _NOTHING
    return np.asarray(cholesky(model.level_covariance + np.diag(own + least), lower=True))


def _levels(seen: RunFeatures, model: ExpectedRun, off: Discrepancy) -> Residuals:
    root = level_root(seen, model, off)
    white = solve_triangular(root, seen.level - model.level, lower=True)
    at, none = np.arange(seen.level.size), np.full(seen.level.size, -1)
    sd = np.diag(root) / max(seen.largest_level, _NOTHING)
    return Residuals(white * sd, sd, np.full(seen.level.size, LEVEL, dtype=np.int8), at, none)


def _common(seen: RunFeatures, model: ExpectedRun, _: Discrepancy) -> Residuals:
    """Return what the gain of the reading leaves of the changes that all lines have in common."""
    parts = [_of(np.zeros(0), np.zeros(0), COMMON, np.zeros((0, 0), dtype=np.bool_))]
    for each in seen.kept.get("common changes", None, lambda: common_changes(seen)):
        gain = each.contrasts @ model.block_gain[each.segment] if model.block_gain else 0.0
        count = each.value.size
        parts.append(Residuals(
            each.value - gain, np.full(count, each.sd), np.full(count, COMMON, dtype=np.int8), np.arange(count),
            np.full(count, each.segment),
        ))  # fmt: skip
    return _joined(parts)


def _shown(values: Floats | float, shown: NDArray[np.bool_]) -> Floats:
    return np.asarray(np.broadcast_to(values, shown.shape)[shown])


def _of(value: Floats, sd: Floats, kind: int, shown: NDArray[np.bool_]) -> Residuals:
    row, at = np.nonzero(shown)
    clipped = np.clip(value, -_MOST_EXCESS, _MOST_EXCESS)
    return Residuals(clipped, sd, np.full(value.size, kind, dtype=np.int8), at, row)


def _joined(parts: Sequence[Residuals]) -> Residuals:
    return Residuals(*(
        np.concatenate([getattr(each, name) for each in parts]) for name in ("value", "sd", "kind", "at", "segment")
    ))  # fmt: skip


_OF_KIND = {LINE: _lines, BAND: _bands, LEVEL: _levels, COMMON: _common}
