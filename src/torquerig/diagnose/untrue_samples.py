"""Samples that are no reading of the torque, told in words and as places: written twice, or at another gain."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.looking.copied import copied
from torquerig.diagnose.looking.gain_moments import GainMoment
from torquerig.signals.recording import Recording

Untrue = tuple[str, Mismatch]

_TOLD = 4  # moments of a recording that are told


def repeated(recordings: Sequence[Recording]) -> Iterator[Untrue]:
    """Yield a sentence and a place for each recording that holds samples twice."""
    for recording in recordings:
        found, rate = copied(recording), recording.sample_rate
        if not found:
            continue
        length = max(each.stop - each.start for each in found) / rate
        sentence = (
            f"{recording.name}: at {_moments([each.start / rate for each in found])} samples repeat earlier ones "
            f"exactly, for up to {1e3 * length:.3g} ms; the logger wrote them twice, so its time base cannot be trusted"
        )
        yield sentence, _place(recording, found[0].start, found[0].stop, excess=0.0)


def gain_changes(recordings: Sequence[Recording], gains: Sequence[Sequence[GainMoment]]) -> Iterator[Untrue]:
    """Yield a sentence and a place for each recording that has another gain in moments."""
    for recording, moments in zip(recordings, gains, strict=True):
        if not moments:
            continue
        rate, factor = recording.sample_rate, float(np.median([each.factor for each in moments]))
        length = max(each.stop - each.start for each in moments) / rate
        sentence = (
            f"{recording.name}: at {_moments([each.start / rate for each in moments])} all of the signal, noise too, "
            f"is {factor:.3g} times as large, for up to {length:.3g} s; that is a gain which changes, and no mechanism "
            "of the library does that: the rest was judged with these moments scaled back"
        )
        yield sentence, _place(recording, moments[0].start, moments[0].stop, excess=20 * float(np.log10(factor)))


def _moments(starts: Sequence[float]) -> str:
    return f"{', '.join(f'{start:.4g}' for start in starts[:_TOLD])} s{' and later' if len(starts) > _TOLD else ''}"


def _place(recording: Recording, start: int, stop: int, *, excess: float) -> Mismatch:
    return Mismatch(
        domain="time", axis="s", at=start / recording.sample_rate, width=(stop - start) / recording.sample_rate,
        recordings=(recording.name,), excess_dB=excess, share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip
