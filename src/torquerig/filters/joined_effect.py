"""The effect of a filter chain on a long recording, from its effects on the blocks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.filters.filter_effect import FilterEffect, LineLevel


def joined_effect(effects: Sequence[FilterEffect], samples: Sequence[int]) -> FilterEffect:
    """Return the effect over all blocks: exact for mean, standard deviation and energy; rms for the lines.

    Parameters
    ----------
    effects : sequence of FilterEffect
        Effects of one chain, block by block.
    samples : sequence of int
        Number of samples of each block.
    """
    weights = np.array(samples, dtype=np.float64) / sum(samples)
    first = effects[0]
    mean_before, std_before = _joined([(one.mean_before, one.std_before) for one in effects], weights)
    mean_after, std_after = _joined([(one.mean_after, one.std_after) for one in effects], weights)
    return replace(
        first,
        mean_before=mean_before,
        mean_after=mean_after,
        std_before=std_before,
        std_after=std_after,
        energy_before=_sum([one.energy_before for one in effects]),
        energy_after=_sum([one.energy_after for one in effects]),
        levels=_levels(effects, weights),
        motor_turns=_sum([one.motor_turns for one in effects]),
        change_rms=float(np.sqrt(weights @ np.array([one.change_rms for one in effects]) ** 2)),
    )


def _joined(each: Sequence[tuple[float, float]], weights: NDArray[np.float64]) -> tuple[float, float]:
    """Return mean and standard deviation of the whole from those of its parts."""
    means, deviations = np.array(each).T
    mean = float(weights @ means)
    return mean, float(np.sqrt(weights @ (deviations**2 + (means - mean) ** 2)))


def _sum(each: Sequence[float | None]) -> float | None:
    known = [one for one in each if one is not None]
    return sum(known) if len(known) == len(each) else None


def _levels(effects: Sequence[FilterEffect], weights: NDArray[np.float64]) -> tuple[LineLevel, ...]:
    if any(len(one.levels) != len(effects[0].levels) for one in effects):
        return ()
    figures = np.array(
        [[(level.frequency, level.before**2, level.after**2) for level in one.levels] for one in effects]
    )
    if figures.size == 0:
        return ()
    frequency, before, after = np.einsum("b,blf->fl", weights, figures)
    return tuple(
        LineLevel(line=level.line, frequency=float(f), before=float(np.sqrt(b)), after=float(np.sqrt(a)))
        for level, f, b, a in zip(effects[0].levels, frequency, before, after, strict=True)
    )
