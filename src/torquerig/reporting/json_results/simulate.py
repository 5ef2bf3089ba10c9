"""The results of commands that write files: levels of what was simulated, and the names of the files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.reporting.json_results.values import Missing, Quantity

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

NOT_RANDOM = Missing("the command draws no random numbers")


@dataclass(frozen=True)
class ChannelLevels:
    """Mean and standard deviation of a channel."""

    channel: str
    mean: Quantity
    std: Quantity


@dataclass(frozen=True)
class SimulateResult:
    """A simulated recording: its levels, what is doubtful, assumed or not used, and the files that were written."""

    title: str
    duration_s: float
    sample_rate_Hz: float  # noqa: N815 (the unit in the key)
    levels: tuple[ChannelLevels, ...]
    warnings: tuple[str, ...]
    flagged: tuple[str, ...]
    not_used: tuple[str, ...]
    notes: tuple[str, ...]
    assumed: Mapping[str, str]
    kept: Mapping[str, str]
    written: tuple[str, ...]


@dataclass(frozen=True)
class WrittenResult:
    """The files that a command wrote, and what it reports of them."""

    written: tuple[str, ...]
    notes: tuple[str, ...] = ()
    levels: tuple[ChannelLevels, ...] = ()
    texts: Mapping[str, str] = field(default_factory=dict)
    seed: int | Missing = NOT_RANDOM


def levels_of(recording: Recording, channels: Mapping[str, str]) -> tuple[ChannelLevels, ...]:
    """Return mean and standard deviation of some channels, by name with their unit in SI."""
    found = []
    for name, unit in channels.items():
        values = recording.channels[name].in_si()
        found.append(ChannelLevels(name, Quantity(float(values.mean()), unit), Quantity(float(values.std()), unit)))
    return tuple(found)


def torque_levels(recording: Recording) -> tuple[ChannelLevels, ...]:
    """Return mean and standard deviation of the compared channel."""
    return levels_of(recording, {recording.torque_name(): recording.torque_unit()})


def named(paths: Sequence[Path | str]) -> tuple[str, ...]:
    """Return paths as texts, with / on every system."""
    return tuple(Path(one).as_posix() for one in paths)
