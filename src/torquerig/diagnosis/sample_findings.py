"""Faults of the samples as candidates: they are seen before any model, and mended before any fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.detectors import examined
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.moments import Moments
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig

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
    if isinstance(sensor, AmplifiedTorqueSensor):
        full = sensor.converter_range
        step = 2 * full / 2**sensor.converter_bits
    seen = examined(recordings, converter_step=step, full_range=full)
    candidates: list[Candidate] = []
    unnamed: list[str] = []
    present = {part.kind for part in rig.parts}

    def add(kind: str, class_name: str, **values: float | str) -> None:
        if kind in present:
            return
        made = getattr(mechanisms, class_name, None)
        if made is None:
            unnamed.append(kind)
        else:
            candidates.append(Candidate(mechanism=kind, parts=(made(name=kind, **values),), knobs=()))

    if seen.coarse_code is not None:
        add("quantization", "Quantization", step=seen.coarse_code)
    lost, cut = seen.dropouts, seen.limit
    if lost is not None:
        add("signal_dropout", "SignalDropout", duration=lost.duration, rate=lost.rate, level=lost.level)
    if cut is not None and seen.behind:
        add("clipping", "Clipping", limit=cut.limit, where="amplifier")
    elif cut is not None:
        add("clipping", "Clipping", limit=cut.limit)
    untrue = tuple(_located(fault) for fault in seen.faults if fault.mechanism is None)
    return SampleFindings(
        tuple(candidates), seen.recordings, seen.clipped, seen.rebuilt, tuple(unnamed), seen.lost,
        untrue, seen.stepping, seen.swept, seen.to_the_other, seen.broken, seen.struck,
    )  # fmt: skip


def _located(fault: Fault) -> Untrue:
    """Return a fault's sentence and its place as a diagnosis lists it."""
    place = fault.place
    return fault.sentence, Mismatch(
        domain=place.domain, axis="s" if place.domain == "time" else "Hz", at=place.at, width=place.width,
        recordings=(fault.recording,), excess_dB=place.excess, share_of_misfit=0.0, p_value=0.0,
    )  # fmt: skip
