"""The effort that a rig needs for a measured motion, by the simulator (inverse dynamics along the motion)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import SimulationError
from torquerig.inference.motion.imposed_run import BAND, ImposedRun
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

_MOST_STEPS = 2000  # of a sample: a stiffer rig is not stepped within minutes


@dataclass(frozen=True, kw_only=True)
class GivenMotion(ImposedMotion):
    """An imposed motion that is given directly, not by a file."""

    given: terms.Motion

    def terms(self, rig: Rig) -> tuple[terms.Term, ...]:
        """Return the motion."""
        return (terms.ImposedMotion(name=self.name, on=rig.node(self.at), motion=self.given),)


def needed_effort(rig: Rig, run: ImposedRun, *, zero: float = 0.0) -> Floats | None:
    """Return the effort of a rig along the motion of a run, low-passed as the motion, shape (samples,) [N m] or [N].

    None where the rig does not stay finite or is too stiff to be stepped. ``zero`` is added to the position.
    """
    part = imposed_part(rig)
    assert part is not None
    given = GivenMotion(name=part.name, at=part.at, given=replace(run.motion, zero=zero))
    imposed = _without_noise(rig).changed(given).at(run.recording.run)
    settling = 0.0 if rig.measured == part.name else SETTLING  # a spring is loaded when the recording starts
    span = Span.of(duration=run.recording.samples / run.rate, settling=settling, rate=run.rate, seed=0, wander=0.0)
    prepared = ready(imposed, span, scenario="", substeps=None)
    if prepared.steps > _MOST_STEPS:
        return None
    try:
        return low_passed(np.asarray(stepped(prepared).torque()), BAND)
    except SimulationError:
        return None


def _without_noise(rig: Rig) -> Rig:
    """Return the rig with the compared place alone, its sensor without noise."""
    sensor = rig.part(rig.measured)
    if getattr(sensor, "noise_rms", 0.0):
        rig = rig.changed(replace(sensor, noise_rms=0.0))  # type: ignore[call-arg]
    return replace(rig, also_measured=())
