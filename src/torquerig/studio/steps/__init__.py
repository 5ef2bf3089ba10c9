"""The steps of the studio, in the order in which a person works: one file each."""

from torquerig.studio.steps.what_if import WHAT_IF

STEPS = (WHAT_IF,)

__all__ = ["STEPS", "WHAT_IF"]
