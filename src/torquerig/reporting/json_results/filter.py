"""The result of ``torquerig filter``: the effect of each filter chain, and its evaluation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import FilterEffect
from torquerig.metrics.filter_evaluation import FilterEvaluation
from torquerig.reporting.json_results.values import Missing, Quantity, known


@dataclass(frozen=True)
class LineLevels:
    """The amplitude of the lines of one cause before and after the filter (root of the summed squares)."""

    cause: str
    before: Quantity
    after: Quantity


@dataclass(frozen=True)
class ChainEffect:
    """The effect of one filter chain on the recording."""

    chain: str
    std: Quantity
    mean: Quantity
    std_cut_percent: float
    variance_cut_percent: float
    mean_change_percent: float
    energy_change_percent: float | Missing
    error_to_true_load: Quantity
    lines: tuple[LineLevels, ...]
    not_removed: tuple[str, ...]


@dataclass(frozen=True)
class ChainEvaluation:
    """The evaluation of one chain: placebo test, step response, error to the true load.

    ``placebo_cut`` is the share of the variance that the chain removes, ``placebo_median`` that of the same bands at
    orders without lines [1].
    """

    chain: str
    placebo_cut: float | Missing
    placebo_median: float | Missing
    placebo_p_value: float | Missing
    rise_s: float | Missing
    delay_s: float | Missing
    overshoot: float | Missing
    pre_ringing: float | Missing
    hit_peak: float | Missing
    error_before: Quantity
    error_after: Quantity
    error_of_perfect_line_removal: Quantity


@dataclass(frozen=True)
class FilterResult:
    """The effect of filter chains on a recording.

    Parameters
    ----------
    recording : str
    samples : int
    std, mean : Quantity
        Of the recording as it is.
    speed_origin : str
        Source of the speed for energy and lines.
    chains : tuple of ChainEffect
    evaluations : tuple of ChainEvaluation
        With ``--evaluate``.
    notes : tuple of str
        What was assumed.
    written : tuple of str
    """

    recording: str
    samples: int
    std: Quantity
    mean: Quantity
    speed_origin: str
    chains: tuple[ChainEffect, ...]
    evaluations: tuple[ChainEvaluation, ...]
    notes: tuple[str, ...]
    written: tuple[str, ...]


def chain_effects(
    chains: Sequence[Chain], effects: Sequence[FilterEffect], errors: Sequence[float] | None, *, unit: str
) -> tuple[ChainEffect, ...]:
    """Return the effect of each chain; ``errors`` are those to the true load where it is known."""
    found: Sequence[float | None] = [None] * len(effects) if errors is None else errors
    return tuple(
        ChainEffect(
            chain=chain.name,
            std=Quantity(effect.std_after, unit),
            mean=Quantity(effect.mean_after, unit),
            std_cut_percent=effect.std_reduction_percent,
            variance_cut_percent=effect.variance_reduction_percent,
            mean_change_percent=effect.mean_change_percent,
            energy_change_percent=known(effect.energy_change_percent, "no speed is known"),
            error_to_true_load=Quantity(known(error, "the true load is not known"), unit),
            lines=_levels(effect.family_levels(), unit),
            not_removed=tuple(chain.left_out),
        )
        for chain, effect, error in zip(chains, effects, found, strict=True)
    )


def _levels(levels: Mapping[str, tuple[float, float]], unit: str) -> tuple[LineLevels, ...]:
    return tuple(LineLevels(cause, Quantity(was, unit), Quantity(now, unit)) for cause, (was, now) in levels.items())


def chain_evaluation(made: FilterEvaluation) -> ChainEvaluation:
    """Return the evaluation of a chain."""
    placebo, step, unit = made.placebo, made.step, made.before.torque_unit()
    no_placebo, no_step = "the chain removes no lines", "the torque is constant or the recording too short"
    errors = (made.error_before, made.error_after, made.error_perfect)
    before, after, perfect = (
        Quantity(Missing("the true load is not known") if one is None else one.rms, unit) for one in errors
    )
    return ChainEvaluation(
        chain=made.chain,
        placebo_cut=known(placebo.cut if placebo else None, no_placebo),
        placebo_median=known(placebo.median if placebo else None, no_placebo),
        placebo_p_value=known(placebo.p_value if placebo else None, no_placebo),
        rise_s=known(step.rise if step else None, no_step),
        delay_s=known(step.late if step else None, no_step),
        overshoot=known(step.overshoot if step else None, no_step),
        pre_ringing=known(step.pre_ringing if step else None, no_step),
        hit_peak=known(step.hit_peak if step else None, no_step),
        error_before=before, error_after=after, error_of_perfect_line_removal=perfect,
    )  # fmt: skip
