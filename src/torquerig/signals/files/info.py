"""What stands in a recording, and what looks suspicious: clipping, a constant signal, samples that repeat."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from math import log
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.signals.recording import Channel, Recording
from torquerig.signals.run import Run

# these may rest on their highest or lowest value without being clipped
_POSITIONS = ("motor_angle", "angle", "position", "tacho")


@dataclass(frozen=True, kw_only=True)
class ChannelInfo:
    """One channel in figures, in its own unit.

    ``clipped_low`` and ``clipped_high`` count the samples on the lowest and highest value where that looks like
    clipping, else 0. ``longest_repeat`` is the longest run of one value, from sample ``repeat_from`` on; ``stuck`` says
    that it is far longer than chance makes it.
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


@dataclass(frozen=True, kw_only=True)
class RecordingInfo:
    """A recording in figures; ``info["torque_V"]`` is one channel's. Rate in [Hz], duration in [s]."""

    name: str
    sample_rate: float
    samples: int
    duration: float
    run: Run
    channels: Mapping[str, ChannelInfo]

    def __getitem__(self, name: str) -> ChannelInfo:
        return self.channels[name]

    def as_dict(self) -> dict[str, Any]:
        """Return plain nested dicts, for JSON."""
        return asdict(self)

    def suspicions(self) -> list[str]:
        """Return one sentence on each thing that looks wrong; empty where nothing does."""
        found = []
        for name, one in self.channels.items():
            if one.constant:
                found.append(f"{name} is constant at {one.mean:.6g} {one.unit}; is the sensor connected?")
            for count, limit in ((one.clipped_low, one.minimum), (one.clipped_high, one.maximum)):
                if count:
                    found.append(f"{name} looks clipped at {limit:.6g} {one.unit} ({count} samples)")
            if one.stuck and not one.constant:
                start, length = one.repeat_from / self.sample_rate, one.longest_repeat / self.sample_rate
                found.append(
                    f"{name} holds one value for {one.longest_repeat} samples ({length:.3g} s) from sample "
                    f"{one.repeat_from} ({start:.6g} s) on"
                )
        return found


def recording_info(recording: Recording) -> RecordingInfo:
    """Return rate, length, and for each channel the level and what looks suspicious."""
    return RecordingInfo(
        name=recording.name,
        sample_rate=recording.sample_rate,
        samples=recording.samples,
        duration=recording.duration,
        run=recording.run,
        channels={name: channel_info(channel) for name, channel in recording.channels.items()},
    )


def channel_info(channel: Channel) -> ChannelInfo:
    """Return the level of one channel and what looks suspicious in it.

    Clipping: the extreme value comes three times in a row or more, and more than twice as often as the next value
    inside it (an honest converter's counts fall off towards the extremes). Stuck: the longest run of one value is over
    three times as long as independent repeats of that frequency make it, and over 8 samples. Both are suspicions: a
    square wave looks clipped, and a resting rig stuck. Angles, positions and tachos are judged for neither.
    """
    values = channel.values
    low, high = float(values.min()), float(values.max())
    length, start = longest_run(values)
    judged = channel.quantity not in _POSITIONS and low < high
    return ChannelInfo(
        quantity=channel.quantity,
        unit=channel.unit,
        si_per_unit=channel.si_per_unit,
        truth=channel.truth,
        minimum=low,
        mean=float(values.mean()),
        maximum=high,
        std=float(values.std()),
        constant=low == high,
        clipped_low=_clipped(values, low, -np.inf) if judged else 0,
        clipped_high=_clipped(values, high, np.inf) if judged else 0,
        longest_repeat=length,
        repeat_from=start,
        stuck=judged and length > max(8.0, 3 * _run_by_chance(values)),
    )


def longest_run(values: NDArray[np.float64]) -> tuple[int, int]:
    """Return the length of the longest run of one value and the sample it starts at."""
    starts = np.concatenate([[0], np.flatnonzero(np.diff(values)) + 1])
    lengths = np.diff(np.append(starts, values.size))
    longest = int(np.argmax(lengths))
    return int(lengths[longest]), int(starts[longest])


def _run_by_chance(values: NDArray[np.float64]) -> float:
    repeats = float(np.count_nonzero(np.diff(values) == 0)) / max(values.size - 1, 1)
    return 1.0 + (log(values.size * (1 - repeats) + 1) / -log(repeats) if 0 < repeats < 1 else 0.0)


def _clipped(values: NDArray[np.float64], extreme: float, beyond: float) -> int:
    on_it = values == extreme
    count = int(np.count_nonzero(on_it))
    inside = values[~on_it]
    neighbour = float(inside.max() if beyond > 0 else inside.min())
    # runs of True are the runs on the extreme
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on_it.view(np.int8), [0]])))
    longest = int((edges[1::2] - edges[::2]).max())
    return count if longest >= 3 and count > 2 * int(np.count_nonzero(values == neighbour)) else 0
