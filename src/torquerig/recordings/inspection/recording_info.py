"""Figures of a recording, and suspicious findings: gaps, clipping, stuck and missing samples, spikes, dropouts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.blocks import Block, Blocking, uneven_times
from torquerig.recordings.files.gaps import FEWEST_SAMPLES, Gap, gaps_in
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.files.timebase import EVENLY
from torquerig.recordings.files.timing import CHANGES
from torquerig.recordings.inspection.channel_info import POSITIONS, ChannelInfo, channel_info
from torquerig.recordings.inspection.channel_summary import LONGEST_DROPOUT, ChannelSummary, joined_summaries, summarise
from torquerig.recordings.inspection.outliers import MARGIN
from torquerig.recordings.inspection.pauses import Pauses, pauses_of, time_span
from torquerig.recordings.inspection.runs import Run as SampleRun
from torquerig.recordings.inspection.stretch_faults import StretchFaults
from torquerig.recordings.quantities import OTHER
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.clipping import CLIPPING
from torquerig.recordings.repair.common_dropouts import DROPOUTS
from torquerig.recordings.repair.dropout_search import DropoutSearch
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.recording_faults import MEASURED
from torquerig.recordings.run import Run

_NAMED = 5  # most places that are named in a sentence


@dataclass(frozen=True, kw_only=True)
class RecordingInfo:
    """Figures of a recording; ``info["torque_V"]`` are those of one channel. Rate in [Hz], duration in [s].

    The picture is drawn from ``summaries``; ``gaps`` are the jumps of the column ``time_name``, and ``uneven`` says why
    its times are not even where no jump does.
    """

    name: str
    sample_rate: float
    samples: int
    duration: float
    run: Run
    channels: Mapping[str, ChannelInfo]
    gaps: tuple[Gap, ...] = ()
    time_name: str = "time"
    uneven: str = ""
    summaries: Mapping[str, ChannelSummary] = field(default_factory=dict)

    @property
    def pauses(self) -> Pauses | None:
        """The pauses of ten samples and more, None where there is none."""
        return pauses_of(self.gaps, rate=self.sample_rate, samples=self.samples)

    @property
    def span(self) -> float:
        """The time from the first to the last sample [s]: the duration, and what lies in pauses and lost samples."""
        return time_span(self.gaps, rate=self.sample_rate, samples=self.samples)

    def __getitem__(self, name: str) -> ChannelInfo:
        return self.channels[name]

    def as_dict(self) -> dict[str, Any]:
        """Return plain nested dicts, for JSON; without the summaries."""
        return {key: value for key, value in asdict(self).items() if key != "summaries"}

    def suspicions(self, stretch: StretchFaults | None = None) -> list[str]:
        """Return one sentence per suspicious finding, with those of a stretch; empty where there is none.

        Dropouts and clipping of the whole recording are named before the same of a stretch of it.
        """
        uneven = [f"{self.uneven}; {EVENLY}"] if self.uneven else []
        paused = self.pauses
        many = paused is not None and paused.count > _NAMED
        jumps = [gap for gap in self.gaps if not (many and gap.step * self.sample_rate >= FEWEST_SAMPLES)]
        gaps = [paused.sentence(self.time_name)] if many and paused is not None else []
        gaps += [
            f"{self.time_name} jumps by {gap.step:.6g} s instead of {1 / self.sample_rate:.6g} s after sample "
            f"{gap.sample} ({gap.time:.6g} s)"
            for gap in jumps[:_NAMED]
        ]
        more = [f"{self.time_name} jumps {len(jumps) - _NAMED} more times"] if len(jumps) > _NAMED else []
        return [
            *(uneven or [*gaps, *more]),
            *chain.from_iterable(self._of(name, one) for name, one in self.channels.items() if not one.truth),
            *(fault.of_channel for fault in (stretch.faults if stretch else ()) if self._is_new(fault)),
        ]

    def _is_new(self, fault: Fault) -> bool:
        one = self.channels[fault.channel]
        if fault.kind == DROPOUTS:
            return not one.dropouts and one.rounded_dropouts is None
        return fault.kind != CLIPPING or not (one.clipped_low or one.clipped_high)

    def _of(self, name: str, one: ChannelInfo) -> list[str]:
        found = []
        if one.not_numbers:
            count = sum(run.length for run in one.not_numbers)
            what = "sample that is not a number" if count == 1 else "samples that are not numbers"
            found.append(f"{name} has {count} {what}: {_places(one.not_numbers)}")
        if one.constant and one.quantity != OTHER:
            found.append(
                f"{name} is constant at {one.mean:.6g} {one.unit} in all its {self.samples} samples; is the sensor "
                "connected?"
            )
        for count, limit in ((one.clipped_low, one.minimum), (one.clipped_high, one.maximum)):
            if count:
                found.append(f"{name} looks clipped at {limit:.6g} {one.unit} ({count} samples)")
        if one.dropouts:
            found.append(self._dropped(name, one))
        if one.rounded_dropouts is not None:
            found.append(one.rounded_dropouts.sentence(name, one.unit))
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
            channel.values, whole, first=0, rate=recording.sample_rate, judged=channel.quantity not in POSITIONS
        )
        for name, channel in recording.channels.items()
    }
    searches = _searches(recording)
    for name, search in searches.items():
        search.add(recording.channels[name].values)
    return _info(recording, summaries, samples=recording.samples, searches=searches)


def stream_info(stream: RecordingStream) -> RecordingInfo:
    """Return the same for a recording on disk, block by block; it may have missing numbers and jumps of time."""
    summaries: dict[str, ChannelSummary] = {}
    gaps: list[Gap] = []
    samples, last_time, uneven = 0, None, ""
    recording = None
    searches: dict[str, DropoutSearch] = {}
    margin = max(MARGIN, round(LONGEST_DROPOUT * stream.sample_rate) + 8)
    for block in Blocking(samples=2**20, overlap=margin).cut(stream):
        recording = block.recording
        summaries = _joined(summaries, block)
        searches = searches or _searches(recording)
        for name, search in searches.items():
            search.add(recording.channels[name].values[block.kept])
        samples = block.first + block.kept.stop - block.kept.start
        if block.times is not None:
            found = gaps_in(
                block.times, stream.sample_rate, first=block.first, before=last_time, scatter=stream.time_scatter
            )
            gaps += found
            problem = "" if uneven else uneven_times(block.times, stream, first=block.first)
            # a jump names a gap better; a change of rate is many jumps or none
            uneven = problem if CHANGES in problem or (problem and not found and not gaps) else uneven
            last_time = float(block.times[-1])
    if recording is None:  # a stream without blocks raises before
        recording = stream.of({name: np.empty(0) for name in stream.entries})
    return _info(
        recording, summaries, samples=samples, gaps=tuple(gaps), time_name=stream.table.time_name() or "time",
        uneven=uneven, searches=searches,
    )  # fmt: skip


def _searches(recording: Recording) -> dict[str, DropoutSearch]:
    channels = recording.channels.items()
    return {
        name: DropoutSearch(recording.sample_rate)
        for name, one in channels
        if one.quantity in MEASURED and not one.truth
    }


def _joined(summaries: Mapping[str, ChannelSummary], block: Block) -> dict[str, ChannelSummary]:
    joined = {}
    for name, channel in block.recording.channels.items():
        before = summaries.get(name)
        judged = channel.quantity not in POSITIONS
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
    uneven: str = "",
    searches: Mapping[str, DropoutSearch] | None = None,
) -> RecordingInfo:
    rounded = {name: search.found() for name, search in (searches or {}).items()}
    return RecordingInfo(
        name=recording.name,
        sample_rate=recording.sample_rate,
        samples=samples,
        duration=samples / recording.sample_rate,
        run=recording.run,
        channels={
            name: channel_info(channel, summaries[name], rounded=rounded.get(name))
            for name, channel in recording.channels.items()
        },
        gaps=gaps,
        time_name=time_name,
        uneven=uneven,
        summaries=summaries,
    )


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
