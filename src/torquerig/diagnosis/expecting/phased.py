"""A rig whose lines have the phases that a run shows, so that a simulation repeats the run itself."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.prediction.line_phases import Samples, with_measured_phases
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Gear


def with_phases_of(rig: Rig, observed: Observed, *, held: bool | None = None) -> Rig:
    """Return ``rig`` with the phase of every torque ripple as measured in the run.

    ``held`` is in which stretches: those that fits may see (False), may not see (True), or all (None).
    """
    samples = Samples(
        run=observed.run, rate=observed.rate, torque=observed.torque, angle=observed.angle, speed=observed.speed,
        used=observed.mask(held=held),
    )  # fmt: skip
    return with_measured_phases(rig, samples)


def phases_tell(rig: Rig) -> bool:
    """Whether more than the lines depends on their phases: flanks may part where several meet."""
    return any(part.gap > 0 for part in rig.of_kind("backlash")) or any(
        part.backlash > 0 for part in rig.parts_of(Gear)
    )


def as_in_runs(rig: Rig, seen: Sequence[Features]) -> list[Rig]:
    """Return ``rig`` for every run, with the phases that are measured where fits may see it."""
    return [with_phases_of(rig, features.observed, held=False) for features in seen]
