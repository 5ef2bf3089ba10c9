"""What samples hold that no rig does: how it is told, in a sentence and as a place in time or frequency."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.outcome import Mismatch
from torquerig.recordings.recording import Recording

Untrue = tuple[str, Mismatch]

_TOLD = 4  # moments of a recording that are told


def in_words(starts: Sequence[float]) -> str:
    """Return the first of the moments [s], and whether there are more."""
    return f"{', '.join(f'{start:.4g}' for start in starts[:_TOLD])} s{' and later' if len(starts) > _TOLD else ''}"


def place_in_time(recording: Recording, start: int, stop: int, *, excess: float) -> Mismatch:
    """Return the place from one sample to before another, which stands out by ``excess`` [dB]."""
    return Mismatch(
        domain="time", axis="s", at=start / recording.sample_rate, width=(stop - start) / recording.sample_rate,
        recordings=(recording.name,), excess_dB=excess, share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip


def place_in_frequency(recording: Recording, at: float, *, width: float, excess: float = 0.0) -> Mismatch:
    """Return the place about a frequency [Hz], ``width`` [Hz] wide, which stands out by ``excess`` [dB]."""
    return Mismatch(
        domain="frequency", axis="Hz", at=at, width=width, recordings=(recording.name,), excess_dB=excess,
        share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip
