"""What a rig takes for a measured motion: the simulator's own answer."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.hum_of_a_run import hum_in, hums_of
from torquerig.diagnosis.motion.moved import BAND, Moved
from torquerig.errors import SimulationError
from torquerig.recordings.sampled_motion import low_passed
from torquerig.rig import terms
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import ImposedMotion
from torquerig.simulation.inputs import Span
from torquerig.simulation.ready import ready
from torquerig.simulation.sampling import SETTLING
from torquerig.simulation.simulator import stepped

Floats = NDArray[np.float64]

_MOST_STEPS = 2000  # of a sample
RUN_AWAY = 1e3  # times the measured effort: what a rig that does not stay finite counts as


@dataclass(frozen=True, kw_only=True)
class GivenMotion(ImposedMotion):
    """An imposed motion that is at hand, in no file."""

    given: terms.Motion

    def terms(self, rig: Rig) -> tuple[terms.Term, ...]:
        """Return the motion."""
        return (terms.ImposedMotion(name=self.name, on=rig.node(self.at), motion=self.given),)


def _noiseless(rig: Rig) -> Rig:
    """Return the rig with the compared place alone, its sensor without noise."""
    sensor = rig.part(rig.measured)
    if getattr(sensor, "noise_rms", 0.0):
        rig = rig.changed(replace(sensor, noise_rms=0.0))  # type: ignore[call-arg]
    return replace(rig, also_measured=())


def predicted(rig: Rig, run: Moved) -> Floats:
    """Return the effort that ``rig`` takes for the motion of a run, low-passed as the measured one [N m] or [N].

    A rig that does not stay finite answers with a value far off, so that a fit turns away from it; so does one that is
    too stiff to be stepped within reason.
    """
    far_off = np.full(run.effort.size, RUN_AWAY * float(np.abs(run.effort).max()))
    part = imposed_part(rig)
    assert part is not None
    given = GivenMotion(name=part.name, at=part.at, given=run.motion)
    moving, hums = _noiseless(rig).changed(given).at(run.recording.run), hums_of(rig)
    for hum in hums:
        moving = moving.without(hum.name)
    settling = 0.0 if rig.measured == part.name else SETTLING  # a spring is loaded when the recording starts
    span = Span.of(duration=run.recording.samples / run.rate, settling=settling, rate=run.rate, seed=0, wander=0.0)
    prepared = ready(moving, span, scenario="", substeps=None)
    if prepared.steps > _MOST_STEPS:
        return far_off
    try:
        made = stepped(prepared)
    except SimulationError:
        return far_off
    taken = low_passed(made.torque(), BAND)
    return taken + hum_in(hums, run, run.effort - taken) if hums else taken
