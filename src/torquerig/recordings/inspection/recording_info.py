"""Figures of a recording, and suspicious findings: gaps, clipping, stuck and missing samples, spikes, dropouts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.blocks import Block, Blocking
from torquerig.recordings.files.gaps import Gap, gaps_in
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.channel_summary import LONGEST_DROPOUT, ChannelSummary, joined_summaries, summarise
from torquerig.recordings.inspection.extremes import Extreme
from torquerig.recordings.inspection.outliers import MARGIN
from torquerig.recordings.inspection.runs import Run as SampleRun
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

# these may stay at their highest or lowest value without clipping, and jump where they overflow
_POSITIONS = ("motor_angle", "angle", "position", "tacho")
_NAMED = 5  # most places that are named in a sentence


@dataclass(frozen=True, kw_only=True)
class ChannelInfo:
    """Figures of one channel, in its unit.

    ``clipped_low`` and ``clipped_high`` count the samples on the lowest and highest value where that looks like
    clipping, else 0. ``longest_repeat`` is the length of the longest run of one value, which starts at sample
    ``repeat_from``. ``stuck``: it is far longer than expected of independent repeats; ``stuck_runs`` lists all such
    runs. ``not_numbers`` are runs of NaN or infinity, ``spikes`` single outliers, ``dropouts`` stretches that jump to a
    level and back.
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


@dataclass(frozen=True, kw_only=True)
class RecordingInfo:
    """Figures of a recording; ``info["torque_V"]`` are those of one channel. Rate in [Hz], duration in [s].

    The picture is drawn from ``summaries``; ``gaps`` are the jumps of the column ``time_name``.
    """

    name: str
    sample_rate: float
    samples: int
    duration: float
    run: Run
    channels: Mapping[str, ChannelInfo]
    gaps: tuple[Gap, ...] = ()
    time_name: str = "time"
    summaries: Mapping[str, ChannelSummary] = field(default_factory=dict)

    def __getitem__(self, name: str) -> ChannelInfo:
        return self.channels[name]

    def as_dict(self) -> dict[str, Any]:
        """Return plain nested dicts, for JSON; without the summaries."""
        return {key: value for key, value in asdict(self).items() if key != "summaries"}

    def suspicions(self) -> list[str]:
        """Return one sentence per suspicious finding; empty where there is none."""
        gaps = [
            f"{self.time_name} jumps by {gap.step:.6g} s instead of {1 / self.sample_rate:.6g} s after sample "
            f"{gap.sample} ({gap.time:.6g} s)"
            for gap in self.gaps[:_NAMED]
        ]
        more = [f"{self.time_name} jumps {len(self.gaps) - _NAMED} more times"] if len(self.gaps) > _NAMED else []
        return [
            *gaps,
            *more,
            *chain.from_iterable(self._of(name, one) for name, one in self.channels.items() if not one.truth),
        ]

    def _of(self, name: str, one: ChannelInfo) -> list[str]:
        found = []
        if one.not_numbers:
            count = sum(run.length for run in one.not_numbers)
            what = "sample that is not a number" if count == 1 else "samples that are not numbers"
            found.append(f"{name} has {count} {what}: {_places(one.not_numbers)}")
        if one.constant:
            found.append(
                f"{name} is constant at {one.mean:.6g} {one.unit} in all its {self.samples} samples; is the sensor "
                "connected?"
            )
        for count, limit in ((one.clipped_low, one.minimum), (one.clipped_high, one.maximum)):
            if count:
                found.append(f"{name} looks clipped at {limit:.6g} {one.unit} ({count} samples)")
        if one.dropouts:
            found.append(self._dropped(name, one))
        if one.spikes:
            runs = [SampleRun(first=sample, length=1) for sample in one.spikes]
            found.append(f"{name} has {_counted(len(runs), 'spike')}: {_places(runs)}")
        if one.stuck and not one.constant:
            found.append(self._stuck(name, one))
        return found

    def _dropped(self, name: str, one: ChannelInfo) -> str:
        lengths = [run.length / self.sample_rate * 1e3 for run in one.dropouts]
        level = float(np.median([run.value for run in one.dropouts]))
        return (
            f"{name} drops to {level:.4g} {one.unit} and comes back {_counted(len(lengths), 'time')}, for "
            f"{min(lengths):.3g} to {max(lengths):.3g} ms: {_places(one.dropouts)}"
        )

    def _stuck(self, name: str, one: ChannelInfo) -> str:
        start, length = one.repeat_from / self.sample_rate, one.longest_repeat / self.sample_rate
        others = [run for run in one.stuck_runs if run.first != one.repeat_from]
        longest = (
            f"{name} holds one value for {one.longest_repeat} samples ({length:.3g} s) from sample "
            f"{one.repeat_from} ({start:.6g} s) on"
        )
        return f"{longest}, and in {_counted(len(others), 'more run')}: {_places(others)}" if others else longest


def recording_info(recording: Recording) -> RecordingInfo:
    """Return rate and length, and the figures and suspicious findings of each channel."""
    whole = slice(0, recording.samples)
    summaries = {
        name: summarise(
            channel.values, whole, first=0, rate=recording.sample_rate, judged=channel.quantity not in _POSITIONS
        )
        for name, channel in recording.channels.items()
    }
    return _info(recording, summaries, samples=recording.samples)


def stream_info(stream: RecordingStream) -> RecordingInfo:
    """Return the same for a recording on disk, block by block; it may have missing numbers and jumps of time."""
    summaries: dict[str, ChannelSummary] = {}
    gaps: list[Gap] = []
    samples, last_time = 0, None
    recording = None
    margin = max(MARGIN, round(LONGEST_DROPOUT * stream.sample_rate) + 8)
    for block in Blocking(samples=2**20, overlap=margin).cut(stream):
        recording = block.recording
        summaries = _joined(summaries, block)
        samples = block.first + block.kept.stop - block.kept.start
        if block.times is not None:
            gaps += gaps_in(block.times, stream.sample_rate, first=block.first, before=last_time)
            last_time = float(block.times[-1])
    if recording is None:  # a stream without blocks raises before
        recording = stream.of({name: np.empty(0) for name in stream.entries})
    return _info(recording, summaries, samples=samples, gaps=tuple(gaps), time_name=stream.table.time_name() or "time")


def _joined(summaries: Mapping[str, ChannelSummary], block: Block) -> dict[str, ChannelSummary]:
    joined = {}
    for name, channel in block.recording.channels.items():
        before = summaries.get(name)
        judged = channel.quantity not in _POSITIONS
        summary = summarise(
            channel.values,
            block.kept,
            first=block.first,
            rate=block.recording.sample_rate,
            judged=judged,
            before=before,
        )
        joined[name] = summary if before is None else joined_summaries(before, summary)
    return joined


def _info(
    recording: Recording,
    summaries: Mapping[str, ChannelSummary],
    *,
    samples: int,
    gaps: tuple[Gap, ...] = (),
    time_name: str = "time",
) -> RecordingInfo:
    return RecordingInfo(
        name=recording.name,
        sample_rate=recording.sample_rate,
        samples=samples,
        duration=samples / recording.sample_rate,
        run=recording.run,
        channels={name: channel_info(channel, summaries[name]) for name, channel in recording.channels.items()},
        gaps=gaps,
        time_name=time_name,
        summaries=summaries,
    )


def channel_info(channel: Channel, summary: ChannelSummary) -> ChannelInfo:
    """Return the figures and suspicious findings of one channel.

    Clipping: see :class:`Extreme`. Stuck: runs of one value longer than 8 samples and than three times the longest
    expected run of independent repeats. Spikes and dropouts: see ``inspection.outliers``. All are suspicions: a square
    wave looks clipped, and a rig at rest stuck. Angles, positions and tachos are not tested.
    """
    levels = summary.levels
    judged = channel.quantity not in _POSITIONS and levels.minimum < levels.maximum
    dropouts = summary.dropouts if judged else ()
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
    )


def _clipped(extreme: Extreme | None, sign: float, dropouts: Sequence[SampleRun]) -> int:
    """Return the number of samples at the limit, 0 where most of them belong to dropouts to that level."""
    if extreme is None:
        return 0
    lost = sum(run.length for run in dropouts if run.value == sign * extreme.value)
    return extreme.clipped if extreme.count > 2 * lost else 0


def longest_run(values: NDArray[np.float64]) -> tuple[int, int]:
    """Return the length of the longest run of one value [samples] and its first sample."""
    from torquerig.recordings.inspection.runs import repeats_of

    longest = repeats_of(values).longest
    return longest.length, longest.first


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def _places(runs: Sequence[SampleRun]) -> str:
    places = [f"{run.first}..{run.last}" if run.length > 1 else f"{run.first}" for run in runs[:_NAMED]]
    more = f" and {len(runs) - _NAMED} more" if len(runs) > _NAMED else ""
    alone = len(places) == 1 and ".." not in places[0]
    return f"sample{'s' * (not alone)} {', '.join(places)}{more}"
