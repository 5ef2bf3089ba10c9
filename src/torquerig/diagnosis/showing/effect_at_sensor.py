"""How much the findings change the reading: both models simulated under the conditions of one recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.recordings.recording import Recording
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
    """Return how much the findings change the reading; None without a finding, or if a model cannot be simulated.

    With measured motion it is the rms that the findings take from the held-out residual. Else the completed model is
    simulated with and without the findings, all other parameters and random numbers alike, in the conditions of each
    recording; the largest change counts. ``nominal`` is the rig of the scenario.
    """
    if not outcome.diagnosis.findings:
        return None
    if isinstance(outcome, MotionOutcome):
        return _of_motion(outcome)
    return None if outcome.diagnosis.fit.by_twin else _simulated(outcome, nominal, seed)


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
    without = without_findings(outcome, nominal)
    rms, name = max((_change(outcome.completed, without, run.recording, seed), run.name) for run in outcome.before.runs)
    unit = effort_unit(outcome.completed)
    where = f" in {name}" if len(outcome.before.runs) > 1 else ""
    return EffectAtSensor(
        rms, unit, f"The findings change the reading by {rms:.3g} {unit.replace('*', ' ')} rms{where} (simulated)."
    )


def _change(completed: Rig, without: Rig, recording: Recording, seed: int) -> float:
    """Return the rms of the difference of two rigs' readings in the conditions of a recording."""
    length = min(recording.duration, LONGEST)
    readings = [
        simulate(rig.at(recording.run), duration=length, seed=seed, sample_rate=recording.sample_rate).torque()
        for rig in (completed, without)
    ]
    return float(np.sqrt(np.mean((readings[0] - readings[1]) ** 2)))


def without_findings(outcome: Outcome, nominal: Rig) -> Rig:
    """Return the completed model without the parts of its findings; effects that have no name stay in it.

    The calibrated model does not serve: its parameters were fitted without the findings, and their shift would count as
    a change of the reading.
    """
    kept = {part.name for part in nominal.parts}
    kept |= {part.name for one in outcome.after.accepted if one.description for part in one.parts}
    rig = outcome.completed
    for part in outcome.completed.parts:
        rig = rig if part.name in kept else rig.without(part.name)
    return rig
