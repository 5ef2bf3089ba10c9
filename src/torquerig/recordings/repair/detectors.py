"""The detectors of faults of samples, in their order: each works on what the ones before it have repaired."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.clipping_under_hum import flat_under_hum
from torquerig.recordings.repair.clipping_under_noise import flat_under_noise
from torquerig.recordings.repair.coarse_codes import coarse_codes
from torquerig.recordings.repair.common_dropouts import common_dropouts
from torquerig.recordings.repair.examination import Detector, Examination, recordings_to_examine
from torquerig.recordings.repair.flat_tops import flat_tops
from torquerig.recordings.repair.held_samples import on_straight_lines, renewed_every
from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.moments import bridged
from torquerig.recordings.repair.samples_at_limit import rebuilt
from torquerig.recordings.repair.sharp_dropouts import Dropouts, dropouts, moments_lost
from torquerig.recordings.repair.time_base import broken_time
from torquerig.recordings.repair.untrue_samples import (
    one_gain,
    one_level,
    without_steps_and_jumps,
    without_strikes,
    without_sweeps,
)

_FINEST = 1e-12  # [V] a code where none is known


def examined(recordings: Sequence[Recording], *, converter_step: float = 0.0, full_range: float = inf) -> Examination:
    """Return what the samples of recordings of one rig show, and the recordings repaired.

    Parameters
    ----------
    recordings : sequence of Recording
    converter_step, full_range : float
        Of the converter [V]; 0 and infinity where they are not known.
    """
    seen = recordings_to_examine(tuple(recordings), converter_step=converter_step, full_range=full_range)
    for detector in DETECTORS:
        seen = detector(seen)
    return seen


def renewed(seen: Examination) -> Examination:
    """Put straight lines between renewals of samples that are held."""
    every = tuple(renewed_every(seen.recordings))
    return replace(seen, renewed=every, recordings=tuple(map(on_straight_lines, seen.recordings, every)))


def of_codes(seen: Examination) -> Examination:
    """Find codes coarser than the converter's."""
    if not seen.converter_step:
        return seen
    return replace(seen, codes=coarse_codes(seen.recordings, converter_step=seen.converter_step))


def without_dropouts(seen: Examination) -> Examination:
    """Bridge dropouts, sharp or rounded; sharp ones of recordings that are held are not looked for."""
    recordings, held = seen.recordings, [every is not None for every in seen.renewed]
    found = dropouts([each for each, by_itself in zip(recordings, held, strict=True) if not by_itself])
    still = zip(recordings, held, strict=True)
    sharp = [[] if by_itself else moments_lost(each) for each, by_itself in still]
    mended = list(map(bridged, recordings, sharp))
    rounded = common_dropouts(mended)
    more = [
        [] if own is None else own.moments(each.sample_rate, each.samples)
        for each, own in zip(recordings, rounded, strict=True)
    ]
    return replace(
        seen, dropouts=_more_of(found, rounded, recordings), recordings=tuple(map(bridged, mended, more)),
        lost=tuple([*some, *others] for some, others in zip(sharp, more, strict=True)),
    )  # fmt: skip


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


def within_limits(seen: Examination) -> Examination:
    """Find where readings stop, and rebuild the moments at a limit where they are few."""
    full, codes = seen.full_range, seen.codes
    code = codes.step if codes else seen.converter_step or _FINEST
    flat = flat_tops(seen.recordings, full_range=full, code=code, coarse=codes is not None)
    behind = None
    if flat is None and codes is None:
        by_hum = flat_under_hum(seen.recordings, full_range=full)
        behind = by_hum or flat_under_noise(seen.recordings, full_range=full)
    own = full - 0.5 * codes.step if codes else full  # coarse codes have their last below it
    limit = own if flat is None else min(flat.limit, own)
    filled = tuple(rebuilt(recording, limit=limit) for recording in seen.recordings)
    changed = {after.name for before, after in zip(seen.recordings, filled, strict=True) if after is not before}
    cut = flat or behind
    names = () if cut is None else tuple(name for name in cut.runs if name in changed)
    return replace(seen, recordings=filled, limit=cut, behind=behind is not None, rebuilt=names)


def on_one_time_base(seen: Examination) -> Examination:
    """Bridge the seams of samples that were written twice or lost."""
    repeating = seen.clipped if seen.behind else ()
    found = broken_time(seen.recorded, renewed=seen.renewed, repeating=repeating)
    lost = tuple([*some, *more] for some, more in zip(seen.lost, found.seams, strict=True))
    return replace(seen, lost=lost, broken=found.names).with_faults(*found.told)


DETECTORS: tuple[Detector, ...] = (
    renewed,
    of_codes,
    without_dropouts,
    within_limits,
    on_one_time_base,
    without_strikes,
    one_level,
    one_gain,
    without_steps_and_jumps,
    without_sweeps,
)
