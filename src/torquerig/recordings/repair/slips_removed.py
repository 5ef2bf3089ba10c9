"""What slips and grips again, taken out of the recordings and told: its blows would drown all else."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time, in_words
from torquerig.recordings.repair.moments import Moments, bridged
from torquerig.recordings.repair.slips import Slips, slips

_ENDS = 0.02  # [s] whose mean a bridge joins: single samples hold noise and lines

Struck = Sequence[Slips | None]


def without_strikes(seen: Examination) -> Examination:
    """Bridge the blows of what slips under load and grips again."""
    struck = slips(seen.recordings)
    recordings, lost = without_slips(seen.recordings, seen.lost, struck)
    found = replace(seen, recordings=tuple(recordings), lost=tuple(lost), struck=moments_of_slips(struck))
    return found.with_faults(*slips_told(recordings, struck))


def without_slips(
    recordings: Sequence[Recording], lost: Sequence[Moments], struck: Struck
) -> tuple[list[Recording], list[Moments]]:
    """Return the recordings with straight lines over their blows, and what is ``lost`` with those moments too."""
    moments = moments_of_slips(struck)
    bridges = [
        bridged(recording, own, ends=max(round(_ENDS * recording.sample_rate), 1))
        for recording, own in zip(recordings, moments, strict=True)
    ]
    return bridges, [[*some, *more] for some, more in zip(lost, moments, strict=True)]


def moments_of_slips(struck: Struck) -> tuple[Moments, ...]:
    """Return the moments that blows took of each recording."""
    return tuple(() if own is None else own.moments for own in struck)


def slips_told(recordings: Sequence[Recording], struck: Struck) -> list[Fault]:
    """Return a sentence and the first place for each recording that has blows."""
    return [_told(each, own) for each, own in zip(recordings, struck, strict=True) if own is not None]


def _told(recording: Recording, own: Slips) -> Fault:
    start, stop = own.moments[0]
    times = in_words([at / recording.sample_rate for at, _ in own.moments])
    return fault_in_time(
        recording, "slips", start, stop, excess=20 * float(np.log10(own.spreads)),
        seen=f"at {times} the torque swings to and fro, by up to {amount(recording, own.furthest)} or "
        f"{own.spreads:.0f} times its usual standard deviation, and is quiet before and after; what slips and grips "
        "again does that under load",
        repair="nothing in the library does that: the rest was judged with these moments bridged",
    )  # fmt: skip
