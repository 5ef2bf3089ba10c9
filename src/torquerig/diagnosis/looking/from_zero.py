"""A run's torque from where its sensor's zero has drifted to: flanks part where the torque itself is zero."""

from __future__ import annotations

from dataclasses import replace

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.rig.assembly import Part, Rig
from torquerig.sensor_stages.drift import Drift


def from_zero(seen: Features, rig: Rig) -> Features:
    """Return the features of a run whose samples are free of what drifts in ``rig``; its lines and bands stay."""
    return replace(seen, observed=undrifted(seen.observed, rig)) if _drifting(rig) else seen


def undrifted(observed: Observed, rig: Rig) -> Observed:
    """Return a run without the drifts of ``rig``, each a shift of the torque channel that nothing else changes."""
    torque, recording = observed.torque, observed.recording
    for _, drift in _drifting(rig):
        torque = torque - observed.torque_unit * drift.course(recording.time(), recording.duration)
    return replace(observed, torque=torque)


def without_drift(rig: Rig) -> Rig:
    """Return the rig with a sensor whose zero stays."""
    for part, _ in _drifting(rig):
        rig = rig.without(part.name)
    return rig


def _drifting(rig: Rig) -> list[tuple[Part, Drift]]:
    """Return the parts that move the zero of the sensor, each with its course."""
    return [(part, each.stage) for part in rig.parts for each in part.stages(rig) if isinstance(each.stage, Drift)]
