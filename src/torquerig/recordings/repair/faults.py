"""Faults of samples: what one says in a sentence, and where it is in time or frequency."""

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
    recording : str
        Name of the recording.
    sentence : str
        What is wrong, since when, and what was done about it.
    place : FaultPlace
    """

    recording: str
    sentence: str
    place: FaultPlace


def in_words(starts: Sequence[float]) -> str:
    """Return the first of the moments [s], and whether there are more."""
    return f"{', '.join(f'{start:.4g}' for start in starts[:_NAMED])} s{' and later' if len(starts) > _NAMED else ''}"


def fault_in_time(recording: Recording, sentence: str, start: int, stop: int, *, excess: float) -> Fault:
    """Return the fault from one sample to before another, which exceeds what is usual by ``excess`` [dB]."""
    rate = recording.sample_rate
    place = FaultPlace(domain="time", at=start / rate, width=(stop - start) / rate, excess=excess)
    return Fault(recording=recording.name, sentence=sentence, place=place)


def fault_in_frequency(recording: Recording, sentence: str, at: float, *, width: float, excess: float = 0.0) -> Fault:
    """Return the fault about a frequency [Hz], ``width`` [Hz] wide, which exceeds the rest by ``excess`` [dB]."""
    place = FaultPlace(domain="frequency", at=at, width=width, excess=excess)
    return Fault(recording=recording.name, sentence=sentence, place=place)
