"""Faults of the samples as candidates: they are seen before any model, and mended before any fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.outcome import Mismatch
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.clipping_under_hum import flat_under_hum
from torquerig.recordings.repair.clipping_under_noise import flat_under_noise
from torquerig.recordings.repair.coarse_codes import coarse_codes
from torquerig.recordings.repair.common_dropouts import common_dropouts
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.flat_tops import FlatTops, flat_tops
from torquerig.recordings.repair.held_samples import on_straight_lines, renewed_every
from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.moments import Moments, bridged
from torquerig.recordings.repair.samples_at_limit import rebuilt
from torquerig.recordings.repair.sharp_dropouts import Dropouts, dropouts, moments_lost
from torquerig.recordings.repair.time_base import broken_time
from torquerig.recordings.repair.untrue_samples import without_untrue
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import TorqueSensor

Untrue = tuple[str, Mismatch]  # a sentence, and where it is


@dataclass(frozen=True)
class SampleFindings:
    """What the samples show, the recordings mended as far as they can be, and which are spoilt beyond that.

    ``clipped`` are the runs that stand at a limit, ``rebuilt`` those of them that do so seldom enough to be put right;
    ``lost`` are the moments without signal of each recording, and those of steps on their way, first sample and one
    past the last; ``untrue`` tells what recordings hold that no rig of the library does, in a sentence and as a
    place; ``stepping`` is whether their mean torque steps, ``swept`` over which frequencies [Hz] a line swept
    that was taken out; ``to_the_other`` leads each recording to the other level of its telegraph noise [V]; ``broken``
    are the recordings whose samples were written twice or lost; ``struck`` are the moments of each that what slips and
    grips again took.
    """

    candidates: tuple[Candidate, ...]
    recordings: tuple[Recording, ...]
    clipped: tuple[str, ...]
    rebuilt: tuple[str, ...]
    unnamed: tuple[str, ...]
    lost: tuple[Moments, ...]
    untrue: tuple[Untrue, ...] = ()
    stepping: bool = False
    swept: tuple[tuple[float, float], ...] = ()
    to_the_other: tuple[float, ...] = ()
    broken: tuple[str, ...] = ()
    struck: tuple[Moments, ...] = ()

    def at_other_level(self) -> SampleFindings | None:
        """Return the same with all telegraph noise at its other level, None where there is none."""
        if not any(self.to_the_other):
            return None
        moved = [
            each.with_values(each.torque_name(), each.torque_values() + volts)
            for each, volts in zip(self.recordings, self.to_the_other, strict=True)
        ]
        return replace(self, recordings=tuple(moved), to_the_other=tuple(-volts for volts in self.to_the_other))

    def added_to(self, rig: Rig) -> Rig:
        """Return the rig with these faults, but for coarse codes: models are fitted with them in it."""
        for candidate in self.candidates:
            rig = rig if candidate.mechanism == "quantization" else candidate.added_to(rig)
        return rig

    def removed_from(self, rig: Rig) -> Rig:
        """Return the rig without them."""
        for candidate in self.candidates:
            rig = candidate.removed_from(rig)
        return rig


def sample_findings(recordings: Sequence[Recording], rig: Rig) -> SampleFindings:
    """Return coarse codes, flat tops and dropouts that ``rig`` does not have; ``unnamed`` are those without a class."""
    sensor = rig.part(rig.measured)
    step, full = 0.0, float("inf")
    if isinstance(sensor, TorqueSensor):
        full = sensor.converter_range
        step = 2 * full / 2**sensor.converter_bits
    candidates: list[Candidate] = []
    unnamed: list[str] = []
    present = {part.kind for part in rig.parts}
    recorded, renewed = recordings, renewed_every(recordings)
    recordings = tuple(map(on_straight_lines, recorded, renewed))

    def add(kind: str, class_name: str, **values: float | str) -> None:
        if kind in present:
            return
        made = getattr(mechanisms, class_name, None)
        if made is None:
            unnamed.append(kind)
        else:
            candidates.append(Candidate(mechanism=kind, parts=(made(name=kind, **values),), knobs=()))

    codes = coarse_codes(recordings, converter_step=step) if step else None
    if codes is not None:
        add("quantization", "Quantization", step=codes.step)
    held = [every is not None for every in renewed]  # such a run stands still by itself
    lost, lost_of_each, mended = _without_dropouts(recordings, held)
    if lost is not None:
        add("signal_dropout", "SignalDropout", duration=lost.duration, rate=lost.rate, level=lost.level)
    code = codes.step if codes else step or 1e-12
    flat = flat_tops(mended, full_range=full, code=code, coarse=codes is not None)
    behind = None if flat is not None or codes is not None else _cut_before_noise(mended, full_range=full)
    if flat is not None:
        add("clipping", "Clipping", limit=flat.limit)
    elif behind is not None:
        add("clipping", "Clipping", limit=behind.limit, where="amplifier")
    own = full - 0.5 * codes.step if codes else full  # coarse codes have their last below it
    limit = own if flat is None else min(flat.limit, own)
    cut = flat or behind
    clipped = () if cut is None else cut.runs
    standing = clipped if codes is None else [recording.name for recording in recordings]
    filled = tuple(rebuilt(recording, limit=limit) for recording in mended)
    changed = [after.name for before, after in zip(mended, filled, strict=True) if after is not before]
    put_right = tuple(name for name in clipped if name in changed)
    resolution = 0.5 * (codes.step if codes else step)
    time = broken_time(recorded, renewed=renewed, repeating=() if behind is None else behind.runs)
    lost_of_each = tuple([*some, *more] for some, more in zip(lost_of_each, time.seams, strict=True))
    true = without_untrue(filled, lost_of_each, standing=standing, resolution=resolution)
    untrue = tuple(map(_located, (*time.told, *true.told)))
    return SampleFindings(
        tuple(candidates), true.recordings, clipped, put_right, tuple(unnamed), true.lost, untrue,
        true.stepping, true.swept, true.to_the_other, time.names, true.struck,
    )  # fmt: skip


def _cut_before_noise(recordings: Sequence[Recording], *, full_range: float) -> FlatTops | None:
    """Return the flat tops on which a hum, an alias or noise rides, None where there are none."""
    by_hum = flat_under_hum(recordings, full_range=full_range)
    return by_hum or flat_under_noise(recordings, full_range=full_range)


def _located(fault: Fault) -> Untrue:
    """Return a fault's sentence and its place as a diagnosis lists it."""
    place = fault.place
    return fault.sentence, Mismatch(
        domain=place.domain, axis="s" if place.domain == "time" else "Hz", at=place.at, width=place.width,
        recordings=(fault.recording,), excess_dB=place.excess, share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip


def _without_dropouts(
    recordings: Sequence[Recording], held: Sequence[bool]
) -> tuple[Dropouts | None, tuple[Moments, ...], tuple[Recording, ...]]:
    """Return the dropouts, sharp or rounded, the moments of each recording, and the recordings with these bridged.

    Sharp ones are not looked for in recordings that are ``held``, for they stand still by themselves.
    """
    found = dropouts([each for each, by_itself in zip(recordings, held, strict=True) if not by_itself])
    still = zip(recordings, held, strict=True)
    sharp = [[] if by_itself else moments_lost(each) for each, by_itself in still]
    mended = list(map(bridged, recordings, sharp))
    rounded = common_dropouts(mended)
    more = [
        [] if own is None else own.moments(each.sample_rate, each.samples)
        for each, own in zip(recordings, rounded, strict=True)
    ]
    lost: tuple[Moments, ...] = tuple([*some, *others] for some, others in zip(sharp, more, strict=True))
    return _more_of(found, rounded, recordings), lost, tuple(map(bridged, mended, more))


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
