"""Whether what a hypothesis gains speaks for its mechanism, and not for something that it stands in for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion import friction
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.level import level_is_off
from torquerig.diagnosis.motion.lines import lines_in, waves
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.places import mismatches
from torquerig.diagnosis.motion.steps import step_in

Floats = NDArray[np.float64]

_OF_THE_LEVEL = ("quadratic_drag", "sensor_drift")
_DRY = 0.03  # of the rms effort: less dry friction beside more viscous friction is no dry friction
_SWINGS = 0.5  # of the rms residual that a mode lowers beside all lines
_LEAST_DAMPING, _MOST_DAMPING = 0.001, 0.2  # steel in one piece rings no longer; what hardly rings is a damper


def doubt_in(candidate: Candidate, made: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> str:
    """Return why a hypothesis that was fitted in ``made`` is not what ``model`` lacks; empty where it may be.

    A drag or a drift must leave a level that is right at all speeds and times: else it bends the level the right way
    and stands for something else. Friction must be dry, and hold more than it slides where a peak was fitted. A mode
    must ring, and answer to all that moves it: one that explains a line alone has three numbers for two, and noise of
    the measured motion, twice differentiated, looks like one (on six rigs without any it was named six times).
    """
    part: Any = made.rig.part(candidate.parts[0].name)
    if candidate.mechanism in _OF_THE_LEVEL and level_is_off(made, runs):
        return "it reduces the mean residual, but the residual still depends on the speed: another effect causes it"
    if candidate.mechanism in _OF_THE_LEVEL and step_in(made, runs) is not None:
        return "it reduces the mean residual, but the residual still has a step in time: another effect causes it"
    if candidate.mechanism == "stribeck_friction":
        return _of_friction(part, candidate, made, runs)
    if candidate.mechanism == "torsional_mode":
        return _of_a_mode(part, made, model, runs)
    return ""


def _of_friction(part: Any, candidate: Candidate, made: FittedMotion, runs: Sequence[Moved]) -> str:
    if viscous_alone(candidate, made, runs):
        return "the viscous friction fitted with it explains the residual; the dry friction is negligible"
    if candidate.variant == "lugre" and max(part.coulomb, part.coulomb_backward) > _largest(runs):
        return "its friction force is above all measured values, so it acts as a spring to the frame"
    return (
        ""
        if friction.possible(part, candidate.variant)
        else "its static friction would not exceed its sliding friction"
    )


def _largest(runs: Sequence[Moved]) -> float:
    """Return the largest effort that fits may see [N m] or [N]."""
    return max(float(np.abs(run.effort[run.seen]).max()) for run in runs if run.seen.any())


def _of_a_mode(part: Any, made: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> str:
    if not _LEAST_DAMPING < part.damping_ratio < _MOST_DAMPING:
        typical = f"{_LEAST_DAMPING:g} to {_MOST_DAMPING:g}"
        return f"its damping ratio would be {part.damping_ratio:.2g}; a shaft resonance has {typical}"
    before, after = (_beside_lines(one, model, runs) for one in (model, made))
    if after > (1 - _SWINGS) * before:
        return (
            f"the residual without single lines falls by {1 - after / before:.0%}, and a mode must reach {_SWINGS:.0%}"
        )
    return "significant differences remain with it" if mismatches(made, runs) else ""


def viscous_alone(candidate: Candidate, made: FittedMotion, runs: Sequence[Moved]) -> bool:
    """Whether what was fitted as dry friction is next to none beside the viscous friction that came with it."""
    part: Any = made.rig.part(candidate.parts[0].name)
    dry = max(part.coulomb, part.coulomb_backward or 0.0, part.static if candidate.variant == friction.PEAKED else 0.0)
    return bool(dry < _DRY * root_mean_square([run.effort[run.seen] for run in runs if run.seen.any()]))


def _beside_lines(one: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> float:
    """Return the rms of what a model leaves beside the lines that ``model`` leaves."""
    lines, left = lines_in(model.residuals, runs), []
    for run, residual in zip(runs, one.residuals, strict=True):
        rest = residual
        for line in lines:
            rest = rest - waves(run, line, rest, run.seen)
        left.append(rest[run.seen])
    return root_mean_square([each for each in left if each.size])
