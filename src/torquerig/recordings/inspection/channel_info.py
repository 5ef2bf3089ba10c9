"""Figures of one channel, and suspicious findings in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.recordings.inspection.channel_summary import ChannelSummary
from torquerig.recordings.inspection.extremes import Extreme
from torquerig.recordings.inspection.runs import Run as SampleRun
from torquerig.recordings.recording import Channel
from torquerig.recordings.repair.lost_moments import RoundedDropouts

# these may stay at their highest or lowest value without clipping, and jump where they overflow
POSITIONS = ("motor_angle", "angle", "position", "tacho")
_MOSTLY = 0.8  # of the rounded dropouts: where so many are sharp ones, those are named


@dataclass(frozen=True, kw_only=True)
class ChannelInfo:
    """Figures of one channel, in its unit.

    ``clipped_low`` and ``clipped_high`` count the samples on the lowest and highest value where that looks like
    clipping, else 0. ``longest_repeat`` is the length of the longest run of one value, which starts at sample
    ``repeat_from``. ``stuck``: it is far longer than expected of independent repeats; ``stuck_runs`` lists all such
    runs. ``not_numbers`` are runs of NaN or infinity, ``spikes`` single outliers, ``dropouts`` stretches that jump to a
    level and back, ``rounded_dropouts`` those whose edges a low-pass rounds.
    """

    quantity: str
    unit: str
    si_per_unit: float
    truth: bool
    minimum: float
    mean: float
    maximum: float
    std: float
    constant: bool
    clipped_low: int
    clipped_high: int
    longest_repeat: int
    repeat_from: int
    stuck: bool
    stuck_runs: tuple[SampleRun, ...] = ()
    not_numbers: tuple[SampleRun, ...] = ()
    spikes: tuple[int, ...] = ()
    dropouts: tuple[SampleRun, ...] = ()
    rounded_dropouts: RoundedDropouts | None = None


def channel_info(channel: Channel, summary: ChannelSummary, *, rounded: RoundedDropouts | None = None) -> ChannelInfo:
    """Return the figures and suspicious findings of one channel; ``rounded`` are dropouts behind a low-pass.

    Clipping: see :class:`Extreme`. Stuck: runs of one value longer than 8 samples and than three times the longest
    expected run of independent repeats. Spikes and dropouts: see ``inspection.outliers``. All are suspicions: a square
    wave looks clipped, and a rig at rest stuck. Angles, positions and tachos are not tested.
    """
    levels = summary.levels
    judged = channel.quantity not in POSITIONS and levels.minimum < levels.maximum
    dropouts = summary.dropouts if judged else ()
    if rounded is not None and len(dropouts) >= _MOSTLY * len(rounded.starts):
        rounded = None
    elif rounded is not None:
        dropouts = ()
    clipped_low, clipped_high = (
        _clipped(one, sign, dropouts) if judged else 0 for one, sign in ((summary.low, -1.0), (summary.high, 1.0))
    )
    limits = [limit for limit, count in ((levels.minimum, clipped_low), (levels.maximum, clipped_high)) if count]
    dropped = {run.first for run in dropouts} | {run.first - 1 for run in dropouts}
    # a run at the limit is reported as clipping, a run in a dropout as a dropout
    runs = [run for run in summary.repeats.stuck() if run.first not in dropped and run.value not in limits]
    stuck = tuple(runs) if judged else ()
    longest = max(stuck, key=lambda run: run.length, default=summary.repeats.longest)
    return ChannelInfo(
        quantity=channel.quantity,
        unit=channel.unit,
        si_per_unit=channel.si_per_unit,
        truth=channel.truth,
        minimum=levels.minimum,
        mean=levels.mean,
        maximum=levels.maximum,
        std=levels.std,
        constant=levels.count > 0 and levels.minimum == levels.maximum,
        clipped_low=clipped_low,
        clipped_high=clipped_high,
        longest_repeat=longest.length,
        repeat_from=longest.first,
        stuck=bool(stuck),
        stuck_runs=stuck,
        not_numbers=summary.gone,
        spikes=summary.spikes if judged else (),
        dropouts=dropouts,
        rounded_dropouts=rounded,
    )


def _clipped(extreme: Extreme | None, sign: float, dropouts: Sequence[SampleRun]) -> int:
    """Return the number of samples at the limit, 0 where most of them belong to dropouts to that level."""
    if extreme is None:
        return 0
    lost = sum(run.length for run in dropouts if run.value == sign * extreme.value)
    return extreme.clipped if extreme.count > 2 * lost else 0
