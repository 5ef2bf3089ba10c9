"""What a rig takes for a measured motion: the simulator's own answer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.motion.moved import Moved, low_passed
from torquerig.errors import SimulationError
from torquerig.rig import terms
from torquerig.rig.parts import ImposedMotion
from torquerig.rig.rig import Rig
from torquerig.simulate.simulate import simulate

Floats = NDArray[np.float64]

RUN_AWAY = 1e3  # times the measured effort: what a rig that does not stay finite counts as


@dataclass(frozen=True, kw_only=True)
class GivenMotion(ImposedMotion):
    """An imposed motion that is at hand, in no file."""

    given: terms.Motion

    def terms(self, rig: Rig) -> tuple[terms.Term, ...]:
        """Return the motion."""
        return (terms.ImposedMotion(name=self.name, on=rig.node(self.at), motion=self.given),)


def predicted(rig: Rig, run: Moved) -> Floats:
    """Return the effort that ``rig`` takes for the motion of a run, low-passed as the measured one [N m] or [N].

    A rig that does not stay finite answers with a value far off, so that a fit turns away from it.
    """
    part = rig.part(rig.measured)
    assert isinstance(part, ImposedMotion)
    given = GivenMotion(name=part.name, at=part.at, given=run.motion)
    moving = rig.changed(given).at(run.recording.run)
    try:
        made = simulate(moving, duration=run.recording.samples / run.rate, seed=0, sample_rate=run.rate, settling=0.0)
    except SimulationError:
        return np.full(run.effort.size, RUN_AWAY * float(np.abs(run.effort).max()))
    return low_passed(made.torque())
