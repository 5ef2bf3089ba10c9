"""A run's torque from where its sensor's zero has drifted to: flanks part where the torque itself is zero."""

from __future__ import annotations

from dataclasses import replace

from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.observed import Observed
from torquerig.mechanisms import SensorDrift
from torquerig.rig.rig import Rig
from torquerig.signals.stages.drift import Drift


def from_zero(seen: Features, rig: Rig) -> Features:
    """Return the features of a run whose samples are free of what drifts in ``rig``; its lines and bands stay."""
    return replace(seen, observed=undrifted(seen.observed, rig)) if rig.parts_of(SensorDrift) else seen


def undrifted(observed: Observed, rig: Rig) -> Observed:
    """Return a run without the drifts of ``rig``, each a shift of the torque channel that nothing else changes."""
    torque, recording = observed.torque, observed.recording
    for part in rig.parts_of(SensorDrift):
        course = Drift(span=part.span, time_constant=part.time_constant).course(recording.time(), recording.duration)
        torque = torque - observed.torque_unit * course
    return replace(observed, torque=torque)


def without_drift(rig: Rig) -> Rig:
    """Return the rig with a sensor whose zero stays."""
    for part in rig.parts_of(SensorDrift):
        rig = rig.without(part.name)
    return rig
