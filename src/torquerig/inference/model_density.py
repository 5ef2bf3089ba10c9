"""Spectral density that a fitted model expects without its lines, at any frequency."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit
from torquerig.inference.load_spectrum import with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun
from torquerig.inference.prediction.skirts import skirts_of
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]


def model_densities(fit: Fit, data: Data) -> list[Callable[[Floats], Floats]]:
    """Return for each run the density [(N m)^2/Hz] as a function of frequency [Hz]."""
    return [_density(fit, data, row) for row in range(len(data.seen))]


def _density(fit: Fit, data: Data, row: int) -> Callable[[Floats], Floats]:
    model = with_gains(fit.expected[row], data.shapes[row], fit.gains)
    bands = data.seen[row].bands
    at, power = np.log(bands.middle), np.log(np.maximum(model.density.max(axis=0), 1e-300))

    wide, peaks = _skirts(fit, data.seen[row], model), _peaks(fit, data.seen[row], model)

    def density(frequency: Floats) -> Floats:
        base = np.exp(np.interp(np.log(np.maximum(frequency, bands.low[0])), at, power))
        return np.asarray(np.maximum(base * peaks(frequency), wide(frequency)))

    return density


def _peaks(fit: Fit, seen: RunFeatures, model: ExpectedRun) -> Callable[[Floats], Floats]:
    """Return by what the load's density in a mode that is narrower than a band exceeds its mean in the band [1]."""
    bands, twin = seen.bands, Twin(fit.fitted_rig.at(seen.run.run))
    mean, share = twin.load_power_between(bands.low, bands.high), model.load_share.max(axis=0)

    def higher(frequency: Floats) -> Floats:
        at = np.log(np.maximum(frequency, bands.low[0]))
        level, own = (np.interp(at, np.log(bands.middle), values) for values in (mean, share))
        peak = twin.load_power(np.exp(at)) / np.maximum(level, 1e-300)
        return np.asarray(1 + own * np.maximum(peak - 1, 0.0))

    return higher


def _skirts(fit: Fit, seen: RunFeatures, model: ExpectedRun) -> Callable[[Floats], Floats]:
    """Return the density of the skirts of a run's lines, which are steeper than the bands are wide."""
    twin = Twin(fit.fitted_rig.at(seen.run.run))
    strongest = np.argmax(model.line_power, axis=0)
    lines = [
        (float(seen.line_frequency[segment, column]), place.at, 0.5 * float(model.line_power[segment, column]))
        for column, (place, segment) in enumerate(zip(seen.places, strongest.tolist(), strict=True))
        if place.domain == "order" and seen.run.is_steady and model.line_power[segment, column] > 0
    ]
    nodes = {float(f"{line.order:.6g}"): line.node for line in twin.lines()}
    skirts = {node: skirts_of(twin, seen.run, node) for node in {"", *nodes.values()}}

    def density(frequency: Floats) -> Floats:
        total = np.zeros(frequency.size)
        for at, order, power in lines:
            own = skirts[nodes.get(float(f"{order:.6g}"), "")]
            if own is not None:
                total += power * own.side_density(order, np.abs(frequency - at))
        return total

    return density
