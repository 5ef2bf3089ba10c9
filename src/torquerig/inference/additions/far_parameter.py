"""A number of the scenario that is far off: each one, one at a time, with a wide prior instead of the stated one.

Not only those that the fit has moved: of two numbers that explain the same features the one with the wider prior moves,
and the other may be the wrong one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context
from torquerig.inference.one_number import FAR, without_priors

_LOG_ODDS = -5.0  # 0.7 % of the numbers of a scenario are slips of pen, unit or data sheet
_FARTHEST = 3.0  # [standard deviations] of the wide prior: from there a fit begins where the linear step is longer
_SPREAD = 1.4  # of the logarithm: a factor of 4
_STATED = 0.5  # of that: a number that may be off by a factor of 2 anyhow was never stated
_OF_RANGE = 0.5  # of the largest torque: standard deviation of a zero that nobody set


def propose(context: Context) -> Iterator[Addition]:
    """Yield each number that the stated uncertainty holds back."""
    own = {part.name for part in context.fit.nominal.parts}
    free, _ = without_priors(context.fit)
    for knob, position in zip(context.fit.knobs, free.tolist(), strict=True):
        wide = _SPREAD if knob.factor else _OF_RANGE * max(context.largest_level, context.signal)
        if knob.part in own and knob.field != "phases" and abs(position) > FAR and knob.spread < _STATED * wide:
            start = float(np.clip(position * knob.spread / wide, -_FARTHEST, _FARTHEST))
            yield Addition(
                kind="parameter", knobs=(replace(knob, spread=wide),), starts=((start,),),
                log_odds=_LOG_ODDS, label=f"{knob.name} is far from its stated value",
            )  # fmt: skip
