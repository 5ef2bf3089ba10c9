"""Rounded dropouts of several recordings of one rig, looked for together: a short one alone may hold too few."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.moments import bridged
from torquerig.recordings.repair.rounded_dropouts import averaged, rounded_dropouts
from torquerig.recordings.repair.sharp_dropouts import dropouts, moments_lost


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


def lost_signal_sentences(recording: Recording) -> list[str]:
    """Return a sentence on sharp and one on rounded dropouts of the torque, as far as there are some."""
    name = recording.torque_name()
    unit, sharp = recording.channels[name].unit, dropouts([recording])
    sentences: list[str] = []
    if sharp is not None:
        sentences.append(
            f"{name} drops to {sharp.level:.4g} {unit} and comes back {sharp.count} time{'s' * (sharp.count != 1)}, "
            f"for {1e3 * sharp.duration:.3g} ms in the median"
        )
    (rounded,) = common_dropouts([bridged(recording, moments_lost(recording))])
    return sentences if rounded is None else [*sentences, rounded.sentence(name, unit)]
