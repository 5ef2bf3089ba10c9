"""Whether what completes a model of a moved rig is told: not where much stays wrong, and it hardly foretells better."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.motion.fitted import FittedMotion, at_their_ends
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.places import mismatches
from torquerig.diagnosis.motion.told import relative_error
from torquerig.diagnosis.motion.tried import Refused, Step

_LEAST_FALL = 0.3  # of the held-out error: what is there takes away more, if something else is missing as well
_HARDLY = "it hardly improves the prediction of the held-out data, and significant differences remain"


def believed(
    before: FittedMotion, steps: tuple[Step, ...], refused: tuple[Refused, ...], runs: Sequence[Moved]
) -> tuple[tuple[Step, ...], tuple[Refused, ...]]:
    """Return the steps that are told, and what is not, with the reason: all of the steps or none.

    Presliding beside play in a nut takes up an eighth of what the play makes and leaves the rest: its name would be
    wrong. A model that stays wrong beside an effect that is there has lost most of its error to it.
    """
    if not steps:
        return steps, refused
    after = steps[-1].kept.model
    right = not (mismatches(after, runs, before=before) or at_their_ends(after, of=before.knobs))
    if right or relative_error(after, runs) < (1 - _LEAST_FALL) * relative_error(before, runs):
        return steps, refused
    return (), (*(Refused(step.kept, _HARDLY) for step in steps), *refused)
