"""Low-pass of the logger: the noise of the sensor falls above its cutoff as well as the torque."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob

NAMES = ("logger_low_pass",)

_LOG_ODDS = -5.0  # of one order
_ORDERS = (2, 4, 8)
_MEDIAN, _SPREAD = 0.2, 0.8  # of the sample rate, and of the logarithm
_STARTS = ((-2.2,), (-1.5,), (-0.7,), (0.0,), (0.7,))
_LESS = -1.0  # [standard deviations] mean residual of the highest bands below which something is missing there
_HIGHEST = 3  # bands of each run
_FAR = 2.0  # [standard deviations] of a number of the noise, which then stands in for a low-pass


def propose(context: Context) -> Iterator[Addition]:
    """Yield a low-pass of each usual order, where noise or the highest bands are not as a model without one expects."""
    name, rate = "logger_low_pass", min(seen.run.rate for seen in context.data.seen)
    noise = (
        abs(position) for knob, position in zip(context.fit.knobs, context.fit.positions, strict=True)
        if knob.field.startswith("noise")
    )  # fmt: skip
    less = context.top_residual(_HIGHEST) < _LESS or max(noise, default=0.0) > _FAR
    wanted = less and not context.rig.of_kind(name)
    for order in _ORDERS if wanted else ():
        part = mechanisms.LoggerLowPass(name=free_name(context.rig, name), cutoff=_MEDIAN * rate, order=order)
        yield Addition(
            mechanism="logger_low_pass", knobs=(Knob(part.name, "cutoff", _SPREAD),), starts=_STARTS, parts=(part,),
            log_odds=_LOG_ODDS, label=f"a low-pass of order {order} in the logger",
            fixed={"order": (float(order), 0.0, "1")}, reported=(Reported("cutoff_Hz", "cutoff", "Hz"),),
        )  # fmt: skip
