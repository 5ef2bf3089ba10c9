"""Clipping: where readings stop, exactly or under a hum, an alias or noise, and the moments at the limit rebuilt."""

from __future__ import annotations

from dataclasses import replace

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.clipping_under_hum import flat_under_hum
from torquerig.recordings.repair.clipping_under_noise import flat_under_noise
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time
from torquerig.recordings.repair.flat_tops import FlatTops, flat_tops
from torquerig.recordings.repair.samples_at_limit import rebuilt

CLIPPING = "clipping"


def within_limits(seen: Examination) -> Examination:
    """Find where readings stop, and rebuild the moments at a limit where they are few."""
    full, coarse = seen.full_range, seen.coarse_code is not None
    flat = flat_tops(seen.recordings, full_range=full, code=seen.code, coarse=coarse)
    behind = None
    if flat is None and not coarse:
        by_hum = flat_under_hum(seen.recordings, full_range=full)
        behind = by_hum or flat_under_noise(seen.recordings, full_range=full)
    own = full - 0.5 * (seen.coarse_code or 0.0)  # coarse codes have their last below it
    limit = own if flat is None else min(flat.limit, own)
    filled = tuple(rebuilt(recording, limit=limit) for recording in seen.recordings)
    changed = {after.name for before, after in zip(seen.recordings, filled, strict=True) if after is not before}
    cut = flat or behind
    names = () if cut is None else tuple(name for name in cut.runs if name in changed)
    found = replace(seen, recordings=filled, limit=cut, behind=behind is not None, rebuilt=names)
    if cut is None:
        return found
    told = (_fault(each, cut, behind=flat is None) for each in seen.recordings if each.name in cut.runs)
    return found.with_faults(*told)


def _fault(recording: Recording, cut: FlatTops, *, behind: bool) -> Fault:
    level = amount(recording, cut.limit)
    where = f"the signal stops at {level} either way"
    behind_it = f"{where}, and what is added behind this limit, noise or a hum, rides on it"
    return fault_in_time(
        recording, CLIPPING, 0, recording.samples, mechanism="clipping",
        seen=behind_it if behind else f"{where}, with up to {100 * cut.share:.2g} % of the samples on the limit",
        repair="moments at the limit were rebuilt where they are few",
    )  # fmt: skip
