"""A hump of noise that stays at its frequency and size whatever the speed and the load."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.misfit import misfit
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.knobs import Knob

NAME = "noise_hump"
_WIDTHS = (0.01, 0.05, 0.2)
_LOWEST = 5.0  # [Hz]
_TRIED = 3


def propose(case: Case) -> Iterator[Candidate]:
    """Yield the hump that fits best at the band in which the runs together have most noise beyond the model's."""
    steady = [features for features in case.seen if features.power.size]
    if case.has(NAME) or not steady:
        return
    parts = [each for width in _WIDTHS for each in _humps(case, steady, width)]
    if parts:
        best = min(parts, key=lambda part: case.misfit_of(case.model.rig + part))
        knobs = (Knob(NAME, "rms", 0.8), Knob(NAME, "frequency", 0.03), Knob(NAME, "width", 0.8))
        yield Candidate(mechanism=NAME, parts=(best,), knobs=knobs, description="noise in a fixed band")


def in_words(part: mechanisms.NoiseHump) -> str:
    """Return what a fitted hump is."""
    return f"noise of {part.rms:.2g} V rms in a fixed band around {part.frequency:.4g} Hz"


def _humps(case: Case, steady: list[Features], width: float) -> Iterator[mechanisms.NoiseHump]:
    """Yield a hump at each of the bands with most excess, of the size that the run with the least excess shows."""
    grid = min((features.band for features in steady), key=lambda band: band.size)
    grid = grid[grid > _LOWEST]
    excess, significance = [], np.zeros(grid.size)
    for features in steady:
        model = expected(case.model.rig, features)
        bands = np.interp(np.log(grid), np.log(features.band), np.nan_to_num(features.power - model.power))
        excess.append(bands)
        significance += np.interp(np.log(grid), np.log(features.band), misfit(features, model).bands)
    least = np.minimum.reduce(excess)
    for at in np.argsort(significance)[::-1][:_TRIED]:
        if least[at] > 0:
            unit = steady[0].observed.torque_unit
            across = max(grid[at] * width * np.sqrt(2 * np.pi), float(np.gradient(grid)[at]))  # [Hz]
            rms = np.sqrt(least[at] * across) / unit
            yield mechanisms.NoiseHump(name=NAME, rms=float(rms), frequency=float(grid[at]), width=width)
