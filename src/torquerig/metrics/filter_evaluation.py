"""Evaluation of a filter chain on one recording: against the true load, if known, and against a placebo."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.delay import DECAYS, Delay, delay_behind
from torquerig.filters.evaluation.load_scale import WEAR_PART, LoadScale
from torquerig.filters.evaluation.placebo import Placebo, placebo
from torquerig.filters.evaluation.step_response import StepResponse, step_response
from torquerig.filters.filter_effect import FilterEffect, chain_effect
from torquerig.metrics.load_error import LoadError, load_error
from torquerig.metrics.load_shares import LoadShares, load_shares
from torquerig.metrics.truth_error import true_load
from torquerig.simulation.true_lines import true_lines

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class FilterEvaluation:
    """Effect of a filter chain on one recording, and its error against the true load.

    Parameters
    ----------
    chain : str
        Its name.
    before, after : Recording
    effect : FilterEffect
        Standard deviation, mean and energy before and after.
    placebo : Placebo or None
        None for a chain without lines that could be moved.
    step : StepResponse or None
        None where the torque is constant or too short.
    delay : Delay or None
        Of the filtered reading against the raw one; None where one of them is constant.
    error_before, error_after : LoadError or None
        Against the true load; None where it is not known.
    error_perfect : LoadError or None
        Of the reading minus the simulated lines; None where these are not known.
    load_shares : LoadShares or None
        How much of what the chain keeps, and of what it removes, is load; None where the load is not known.
    """

    chain: str
    before: Recording
    after: Recording
    effect: FilterEffect
    placebo: Placebo | None
    step: StepResponse | None
    delay: Delay | None
    error_before: LoadError | None
    error_after: LoadError | None
    error_perfect: LoadError | None = None
    load_shares: LoadShares | None = None


def evaluate_filter(
    chain: Chain,
    recording: Recording,
    *,
    ratio: float,
    known: Sequence[KinematicLine] = (),
    scale: LoadScale = WEAR_PART,
) -> FilterEvaluation:
    """Return the evaluation of ``chain`` on ``recording``.

    Parameters
    ----------
    ratio : float
        Motor turns per output turn [1].
    known : sequence of KinematicLine
        All lines of the drive; the placebo is placed between them.
    scale : LoadScale
        Decay time of the load's hits, and the frequency bands.
    """
    after = chain.apply(recording)
    has_truth = true_load(recording) is not None
    return FilterEvaluation(
        chain=chain.name,
        before=recording,
        after=after,
        effect=chain_effect(recording, after, ratio=ratio, lines=chain.lines),
        placebo=placebo(chain, recording, known=known),
        step=_step(chain, recording, scale),
        delay=delay_behind(
            after.torque(), recording.torque(), rate=recording.sample_rate, longest=DECAYS * scale.hit_decay
        )
        if recording.samples >= 8
        else None,
        error_before=load_error(recording, recording, scale=scale) if has_truth else None,
        error_after=load_error(after, recording, scale=scale) if has_truth else None,
        error_perfect=_perfect(recording, scale) if has_truth else None,
        load_shares=load_shares(recording, after, longest=DECAYS * scale.hit_decay),
    )


def _perfect(recording: Recording, scale: LoadScale) -> LoadError | None:
    """Return the error of perfect line removal, or None where the lines are not known."""
    lines = true_lines(recording)
    if lines is None:
        return None
    name = recording.torque_name()
    unit = recording.channels[name].si_per_unit
    cleaned = recording.with_values(name, (recording.torque() - lines.in_si()) / unit)
    return load_error(cleaned, recording, scale=scale)


def _step(chain: Chain, recording: Recording, scale: LoadScale) -> StepResponse | None:
    try:
        return step_response(chain, recording, decay=scale.hit_decay)
    except RecordingError:
        return None
