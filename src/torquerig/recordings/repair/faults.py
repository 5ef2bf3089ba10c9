"""Faults of samples: what one shows in a sentence, what was done about it, and where it is in time or frequency."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from torquerig.recordings.recording import Recording

_NAMED = 4  # moments of a recording that a sentence names


@dataclass(frozen=True, kw_only=True)
class FaultPlace:
    """Where a fault is: about ``at``, ``width`` wide, in [s] or [Hz], ``excess`` [dB] above what is usual there."""

    domain: Literal["time", "frequency"]
    at: float
    width: float
    excess: float


@dataclass(frozen=True, kw_only=True)
class Fault:
    """A fault of a recording's samples.

    Parameters
    ----------
    kind : str
        Name of the fault, for example ``telegraph noise``.
    recording, channel : str
        Names of the recording and of the channel that shows it.
    seen : str
        What the samples show since when: one plain sentence, true for every reader of the recording.
    repair : str
        What a diagnosis did about it.
    place : FaultPlace
    mechanism : str or None
        The library's mechanism that makes such samples; None where it has none.
    """

    kind: str
    recording: str
    channel: str
    seen: str
    repair: str
    place: FaultPlace
    mechanism: str | None = None

    @property
    def sentence(self) -> str:
        """What a diagnosis prints: the recording, what it shows and what was done about it."""
        return f"{self.recording}: {self.seen}; {self.repair}"

    @property
    def of_channel(self) -> str:
        """What every other command prints: the channel and what it shows."""
        return self.seen if self.channel in self.seen else f"{self.channel}: {self.seen}"


def in_words(starts: Sequence[float]) -> str:
    """Return the first of the moments [s], and whether there are more."""
    return f"{', '.join(f'{start:.4g}' for start in starts[:_NAMED])} s{' and later' if len(starts) > _NAMED else ''}"


def amount(recording: Recording, value: float) -> str:
    """Return a size of the torque channel with the channel's unit: a scale that nobody stated is not guessed."""
    return f"{value:.3g} {recording.channels[recording.torque_name()].unit}".rstrip()


def fault_in_time(
    recording: Recording, kind: str, start: int, stop: int, *, seen: str, repair: str, excess: float = 0.0,
    channel: str | None = None, mechanism: str | None = None,
) -> Fault:  # fmt: skip
    """Return the fault from one sample to before another, which exceeds what is usual by ``excess`` [dB]."""
    rate = recording.sample_rate
    place = FaultPlace(domain="time", at=start / rate, width=(stop - start) / rate, excess=excess)
    return Fault(
        kind=kind, recording=recording.name, channel=channel or recording.torque_name(), seen=seen, repair=repair,
        place=place, mechanism=mechanism,
    )  # fmt: skip


def fault_in_frequency(
    recording: Recording, kind: str, at: float, *, seen: str, repair: str, width: float, excess: float = 0.0
) -> Fault:
    """Return the fault about a frequency [Hz], ``width`` [Hz] wide, which exceeds the rest by ``excess`` [dB]."""
    place = FaultPlace(domain="frequency", at=at, width=width, excess=excess)
    return Fault(
        kind=kind, recording=recording.name, channel=recording.torque_name(), seen=seen, repair=repair, place=place
    )
