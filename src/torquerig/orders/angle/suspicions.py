"""What is suspicious in the samples of a recording, in the same sentences everywhere."""

from __future__ import annotations

from math import pi

from torquerig.orders.angle.speed_contradictions import speed_contradictions
from torquerig.recordings.inspection.recording_info import RecordingInfo
from torquerig.recordings.inspection.stretch_faults import sound_stretch, stretch_faults
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.angle_jumps import angle_jumps


def suspicions_in(info: RecordingInfo, head: Recording) -> tuple[list[str], str | None]:
    """Return what is suspicious in a recording, and where it was sought if that is not all of it.

    Parameters
    ----------
    info : RecordingInfo
        Of the whole recording.
    head : Recording
        Its first samples, or all.
    """
    stretch = stretch_faults(head, samples=info.samples)
    contradictions = speed_contradictions(sound_stretch(head)[1])
    return [
        *choice_sentences(head),
        *contradictions,
        *info.suspicions(stretch),
    ], None if stretch is None else stretch.where()


def angle_sentences(recording: Recording, *, ratio: float | None = None) -> list[str]:
    """Return what is suspicious in the angle and speed channels alone, jumps too.

    ``ratio`` [1] is that of the gears, by default that of the run.
    """
    sound = sound_stretch(recording)[1]
    found = list(speed_contradictions(sound, ratio=ratio))
    jumps = angle_jumps(sound)
    if jumps:
        first, furthest = jumps[0], max(abs(one.turn) for one in jumps) / (2 * pi)
        found.append(
            f"{first.channel} jumps {len(jumps)} times, first at {first.start / sound.sample_rate:.6g} s, by up to "
            f"{furthest:.2g} turns from one sample to the next: counts or samples were lost or written twice"
        )
    return found


def choice_sentences(recording: Recording) -> list[str]:
    """Return a sentence where several channels may be the measured torque, and the sidecar does not say which."""
    for quantity in ("torque", "force"):
        named = {
            name: one.role for name, one in recording.channels.items()
            if one.quantity == quantity and one.role in (None, "compared") and not one.truth
        }  # fmt: skip
        if len(named) > 1 and "compared" not in named.values():
            remedy = "write role: compared into the sidecar for the one that counts, or name it with --channel"
            return [f"several channels are a {quantity}: {', '.join(named)}; {remedy}"]
        if named:
            return []
    return []
