"""Recordings whose time base is broken: samples written twice, lost or held, as they or a measured angle tell."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.angle_jumps import AngleJump, angle_jumps
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, fault_in_frequency, fault_in_time, in_words
from torquerig.recordings.repair.moments import Moments, seams
from torquerig.recordings.repair.repeated_samples import Copied, copied


@dataclass(frozen=True)
class BrokenTime:
    """The names of such recordings, what was told of them, and the moments about the seams of each recording."""

    names: tuple[str, ...]
    told: tuple[Fault, ...]
    seams: tuple[Moments, ...]


def on_one_time_base(seen: Examination) -> Examination:
    """Bridge the seams of samples that were written twice or lost."""
    repeating = seen.clipped if seen.behind else ()
    found = broken_time(seen.recorded, renewed=seen.renewed, repeating=repeating)
    lost = tuple([*some, *more] for some, more in zip(seen.lost, found.seams, strict=True))
    return replace(seen, lost=lost, broken=found.names).with_faults(*found.told)


def broken_time(
    recordings: Sequence[Recording], *, renewed: Sequence[float | None], repeating: Collection[str] = ()
) -> BrokenTime:
    """Return where samples were written twice, lost or held; copies are not looked for in ``repeating`` recordings.

    Parameters
    ----------
    recordings : sequence of Recording
        As they were read.
    renewed : sequence of float or None
        After how many samples each is renewed, where it is held in between.
    repeating : collection of str
        Names of those whose samples repeat by themselves, as the tones at a limit do.
    """
    names: list[str] = []
    copies, jumps, about = list[Fault](), list[Fault](), list[Moments]()
    held = [(each, every) for each, every in zip(recordings, renewed, strict=True) if every is not None]
    for recording in recordings:
        twice = () if recording.name in repeating else copied(recording)
        turned = angle_jumps(recording)
        if twice:
            copies.append(_copied(recording, twice))
        if turned:
            jumps.append(_jumping(recording, turned))
        if twice or turned:
            names.append(recording.name)
        ends = (at for each in twice for at in (each.start, each.stop))
        about.append(seams([*ends, *(each.start + 1 for each in turned)], recording))
    names += [each.name for each, _ in held if each.name not in names]
    return BrokenTime(tuple(names), (*copies, *jumps, *(_held(*each) for each in held)), tuple(about))


def _copied(recording: Recording, found: Sequence[Copied]) -> Fault:
    rate = recording.sample_rate
    length = max(each.stop - each.start for each in found) / rate
    return fault_in_time(
        recording, "repeated samples", found[0].start, found[0].stop,
        seen=f"at {in_words([each.start / rate for each in found])} samples repeat earlier ones exactly, for up to "
        f"{1e3 * length:.3g} ms; the logger wrote them twice, so the time base cannot be trusted",
        repair="the seams were bridged",
    )  # fmt: skip


def _jumping(recording: Recording, found: Sequence[AngleJump]) -> Fault:
    rate, furthest = recording.sample_rate, max(abs(each.turn) for each in found) / (2 * np.pi)
    name = found[0].channel
    return fault_in_time(
        recording, "angle jumps", found[0].start, found[0].start + 1, channel=name,
        seen=f"at {in_words([each.start / rate for each in found])} the channel {name} jumps by up to {furthest:.2g} "
        "turns from one sample to the next, and no shaft does; samples or counts were lost or written twice, so the "
        "time base cannot be trusted",
        repair="the seams were bridged",
    )  # fmt: skip


def _held(recording: Recording, every: float) -> Fault:
    rate = recording.sample_rate / every
    return fault_in_frequency(
        recording, "held samples", rate, width=1 / recording.duration,
        seen=f"the torque is renewed only every {every:.4g} samples, at {rate:.4g} Hz, and held in between; what is "
        f"faster than {0.5 * rate:.4g} Hz is folded below that",
        repair="no mechanism of the library does that: the rest was judged with straight lines between the renewals",
    )  # fmt: skip
