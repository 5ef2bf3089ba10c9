"""Dropouts of several recordings of one rig; rounded ones are looked for together, for one alone may hold too few."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, fault_in_time
from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.moments import bridged
from torquerig.recordings.repair.rounded_dropouts import averaged, rounded_dropouts
from torquerig.recordings.repair.sharp_dropouts import Dropouts, Gap, dropouts_of, gaps, moments_lost

DROPOUTS = "dropouts"


def without_dropouts(seen: Examination) -> Examination:
    """Bridge dropouts, sharp or rounded; sharp ones of recordings that are held are not looked for."""
    recordings = seen.recordings
    sharp = [
        [] if every is not None else gaps(each.torque_values(), each.sample_rate)
        for each, every in zip(recordings, seen.renewed, strict=True)
    ]
    at_once = [[(start, stop) for start, stop, _ in own] for own in sharp]
    mended = list(map(bridged, recordings, at_once))
    rounded = common_dropouts(mended)
    more = [
        [] if own is None else own.moments(each.sample_rate, each.samples)
        for each, own in zip(recordings, rounded, strict=True)
    ]
    held = [every is not None for every in seen.renewed]
    looked_at = [
        pair for pair, by_itself in zip(zip(recordings, sharp, strict=True), held, strict=True) if not by_itself
    ]
    return replace(
        seen, dropouts=_more_of(dropouts_of(looked_at), rounded, recordings),
        recordings=tuple(map(bridged, mended, more)),
        lost=tuple([*some, *others] for some, others in zip(at_once, more, strict=True)),
    ).with_faults(*_faults(recordings, sharp, rounded))  # fmt: skip


def _faults(
    recordings: Sequence[Recording], sharp: Sequence[list[Gap]], rounded: Sequence[RoundedDropouts | None]
) -> list[Fault]:
    """Return a fault for the sharp and one for the rounded dropouts of each recording."""
    told: list[Fault] = []
    for recording, own, behind in zip(recordings, sharp, rounded, strict=True):
        unit = recording.channels[recording.torque_name()].unit
        found = dropouts_of([(recording, own)])
        if found is not None:
            told.append(_fault(recording, own[0][0], own[0][1], seen=found.sentence("the signal", unit)))
        if behind is not None:
            start, stop = behind.moments(recording.sample_rate, recording.samples)[0]
            told.append(_fault(recording, start, stop, seen=behind.sentence("the signal", unit)))
    return told


def _fault(recording: Recording, start: int, stop: int, *, seen: str) -> Fault:
    repair = "the rest was judged with these moments bridged"
    return fault_in_time(recording, DROPOUTS, start, stop, mechanism="signal_dropout", seen=seen, repair=repair)


def _more_of(
    sharp: Dropouts | None, rounded: Sequence[RoundedDropouts | None], recordings: Sequence[Recording]
) -> Dropouts | None:
    """Return the sharp or the rounded dropouts, of which there are more."""
    found = [own for own in rounded if own is not None]
    count = sum(len(own.starts) for own in found)
    if not found or (sharp is not None and sharp.count >= count):
        return sharp
    lengths = [length for own in found for length in own.lengths]
    names = tuple(each.name for each, own in zip(recordings, rounded, strict=True) if own is not None)
    seconds = sum(each.duration for each in recordings)
    return Dropouts(found[0].level, float(np.median(lengths)), count, count / seconds, names)


def common_dropouts(recordings: Sequence[Recording]) -> tuple[RoundedDropouts | None, ...]:
    """Return the rounded dropouts of each recording's torque; None in all where there are none.

    Recordings of one rate and unit are looked at one after another as one signal.

    Parameters
    ----------
    recordings : sequence of Recording
        Sharp dropouts bridged.
    """
    kinds = [(each.sample_rate, each.channels[each.torque_name()].unit) for each in recordings]
    answer: list[RoundedDropouts | None] = [None] * len(recordings)
    for kind in dict.fromkeys(kinds):
        members = [index for index, own in enumerate(kinds) if own == kind]
        signals = [averaged(recordings[index].torque_values(), kind[0]) for index in members]
        ends = np.cumsum([0, *(signal.size for signal, _ in signals)])
        rate = signals[0][1]
        found = rounded_dropouts(np.concatenate([signal for signal, _ in signals]), rate)
        if found is None:
            continue
        for index, (start, stop) in zip(members, pairwise(ends / rate), strict=True):
            own = found.within(float(start), float(stop))
            answer[index] = own if own.starts else None
    return tuple(answer)


def moments_without_signal(recording: Recording) -> list[tuple[int, int]]:
    """Return the first sample and one past the last of every moment without signal, its edges sharp or rounded."""
    sharp = moments_lost(recording)
    (rounded,) = common_dropouts([bridged(recording, sharp)])
    return sharp if rounded is None else [*sharp, *rounded.moments(recording.sample_rate, recording.samples)]
