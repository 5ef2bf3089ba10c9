"""A number of the scenario that is far off: each one, one at a time, with a wide prior instead of the stated one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context

_LOG_ODDS = -5.0  # 0.7 % of the numbers of a scenario are slips of pen, unit or data sheet
_FAR = 2.0  # [standard deviations] nearer than this it is not far off
_SPREAD = 1.4  # of the logarithm: a factor of 4
_OF_RANGE = 0.5  # of the largest torque: standard deviation of a zero that nobody set


def propose(context: Context) -> Iterator[Addition]:
    """Yield each number that the stated uncertainty holds back."""
    own = {part.name for part in context.fit.nominal.parts}
    for knob, position in zip(context.fit.knobs, context.fit.positions.tolist(), strict=True):
        wide = _SPREAD if knob.factor else _OF_RANGE * max(context.largest_level, context.signal)
        if knob.part in own and abs(position) > _FAR and knob.spread < wide:
            yield Addition(
                kind="parameter", knobs=(replace(knob, spread=wide),), starts=((position * knob.spread / wide,),),
                log_odds=_LOG_ODDS, label=f"{knob.name} is far from its stated value",
            )  # fmt: skip
