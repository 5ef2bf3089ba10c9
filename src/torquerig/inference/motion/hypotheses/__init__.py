"""What may complete a rig under measured motion.

friction      dry friction of the imposed or the last part        gap       play in a gear or link
cogging       orders of slots and magnets                         plain     drag, drift, mains, a further inertia
waves         nameless lines over angle, place or time            smooth    nameless functions of place, speed, time
zeros         the zero of an incremental scale in each run         delay     time between motion and effort
clipping      a limit of the reading
"""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypotheses import clipping, cogging, delay, friction, gap, plain, smooth, waves, zeros
from torquerig.inference.motion.hypothesis import Hypothesis


def proposals(fit: Fit) -> Iterator[Hypothesis]:
    """Yield all hypotheses for a fitted model."""
    for family in (friction, gap, cogging, plain, waves, smooth, zeros, delay, clipping):
        yield from family.propose(fit)
