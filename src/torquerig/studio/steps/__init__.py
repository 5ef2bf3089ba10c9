"""The steps of the studio, in the order in which a person works: one file each."""

from torquerig.studio.steps.check import CHECK
from torquerig.studio.steps.compare import COMPARE
from torquerig.studio.steps.data import DATA
from torquerig.studio.steps.diagnose import DIAGNOSE
from torquerig.studio.steps.rig import RIG
from torquerig.studio.steps.what_if import WHAT_IF

STEPS = (RIG, DATA, CHECK, WHAT_IF, COMPARE, DIAGNOSE)

__all__ = ["CHECK", "COMPARE", "DATA", "DIAGNOSE", "RIG", "STEPS", "WHAT_IF"]
