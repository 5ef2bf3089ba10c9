"""The steps of the studio, in the order in which a person works: one file each."""

from torquerig.studio.steps.rig import RIG
from torquerig.studio.steps.what_if import WHAT_IF

STEPS = (RIG, WHAT_IF)

__all__ = ["RIG", "STEPS", "WHAT_IF"]
