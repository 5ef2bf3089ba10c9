"""How much the findings change the reading: both models simulated under the conditions of one recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.rig.assembly import Rig
from torquerig.rig.reading_place import effort_unit
from torquerig.simulation.simulator import simulate

LONGEST = 4.0
"""Length of the simulated reading [s]: some tens of turns of an output shaft at usual speeds."""


@dataclass(frozen=True)
class EffectAtSensor:
    """A change of the reading, as rms, with its unit and a sentence that says how it was determined."""

    rms: float
    unit: str
    sentence: str


def effect_at_sensor(outcome: Outcome | MotionOutcome, *, nominal: Rig, seed: int) -> EffectAtSensor | None:
    """Return how much the findings change the reading; None without a finding.

    With measured motion it is the rms that the findings take from the held-out residual. Else the calibrated and the
    completed model are simulated with the same random numbers, in the conditions of the first recording. ``nominal`` is
    the rig of the scenario.
    """
    if not outcome.diagnosis.findings:
        return None
    return _of_motion(outcome) if isinstance(outcome, MotionOutcome) else _simulated(outcome, nominal, seed)


def _of_motion(outcome: MotionOutcome) -> EffectAtSensor:
    unit = "N" if in_a_line(outcome.runs) else "N*m"
    before, after = (
        float(np.sqrt(np.mean(np.concatenate(fitted.of(outcome.runs, held=True)) ** 2)))
        for fitted in (outcome.before, outcome.after)
    )
    spoken = unit.replace("*", " ")
    taken = float(np.sqrt(max(before**2 - after**2, 0.0)))
    return EffectAtSensor(
        taken, unit, f"The held-out residual falls from {before:.3g} to {after:.3g} {spoken} rms with the findings."
    )


def _simulated(outcome: Outcome, nominal: Rig, seed: int) -> EffectAtSensor:
    recording = outcome.before.runs[0].recording
    unit = effort_unit(outcome.completed)
    length = min(recording.duration, LONGEST)
    readings = [
        simulate(rig.at(recording.run), duration=length, seed=seed, sample_rate=recording.sample_rate).torque()
        for rig in (_without_findings(outcome, nominal), outcome.completed)
    ]
    change = float(np.sqrt(np.mean((readings[1] - readings[0]) ** 2)))
    return EffectAtSensor(
        change, unit, f"The findings change the reading by {change:.3g} {unit.replace('*', ' ')} rms (simulated)."
    )


def _without_findings(outcome: Outcome, nominal: Rig) -> Rig:
    """Return the calibrated model; faults of samples, which it has during the fits, are taken out of it."""
    stated = {part.name for part in nominal.parts}
    rig = outcome.before.model.rig
    for part in outcome.before.model.rig.parts:
        rig = rig if part.name in stated else rig.without(part.name)
    return rig
