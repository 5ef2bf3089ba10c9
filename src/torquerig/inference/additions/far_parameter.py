"""A number of the scenario that is far off: each one, one at a time, with a wide prior instead of the stated one."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.inference.addition import Addition
from torquerig.inference.context import Context

_LOG_ODDS = -5.0  # 0.7 % of the numbers of a scenario are slips of pen, unit or data sheet
_FAR = 2.0  # [standard deviations] nearer than this it is not far off
_SPREAD = 1.4  # of the logarithm: a factor of 4


def propose(context: Context) -> Iterator[Addition]:
    """Yield each number that the stated uncertainty holds back."""
    own = {part.name for part in context.fit.nominal.parts}
    for knob, position in zip(context.fit.knobs, context.fit.positions.tolist(), strict=True):
        if knob.part in own and knob.factor and abs(position) > _FAR and knob.spread < _SPREAD:
            yield Addition(
                kind="parameter", knobs=(Knob(knob.part, knob.field, _SPREAD, key=knob.key),),
                starts=((position * knob.spread / _SPREAD,),), log_odds=_LOG_ODDS,
                label=f"{knob.name} is far from its stated value",
            )  # fmt: skip
