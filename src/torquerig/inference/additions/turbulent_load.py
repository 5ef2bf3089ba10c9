"""Turbulent load: a resistance by the square of the speed that varies at random, at the last shaft."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.terms import Load

NAMES = ("turbulent_load",)

_LOG_ODDS = -14.0  # a load is what a scenario states first, and a drive's uneven speed is not in the linear model
_SHARE = 0.3  # of the largest mean torque, at the largest speed: prior median
_RMS, _RMS_SPREAD = 0.05, 1.0  # of the mean, and of its logarithm
_CUTOFF, _CUTOFF_SPREAD = 0.2, 1.0  # times a turn of the shaft: eddies of an impeller (Strouhal); and of its logarithm
_STARTS = ((0.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (-1.0, 1.0, 1.0), (0.5, -1.0, 0.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield a flow at the last shaft, where the scenario has no random load."""
    shaft = context.shafts[-1]
    fastest = context.fastest(shaft)
    if any(isinstance(term, Load) for term in context.rig.terms()) or not context.largest_level or not fastest:
        return
    name = free_name(context.rig, "turbulent_load")
    part = mechanisms.TurbulentLoad(
        name=name, at=shaft.part, quadratic=_SHARE * context.largest_level / fastest**2, turbulence=_RMS,
        turbulence_cutoff=_CUTOFF * fastest / (2 * pi),
    )  # fmt: skip
    yield Addition(
        mechanism="turbulent_load", parts=(part,), starts=_STARTS, log_odds=_LOG_ODDS,
        knobs=(Knob(name, "quadratic", DECADE), Knob(name, "turbulence", _RMS_SPREAD),
               Knob(name, "turbulence_cutoff", _CUTOFF_SPREAD)),
        label=f"a turbulent flow at {shaft.part}",
        reported=(Reported("coefficient_Nms2", "quadratic", "N*m*s^2/rad^2"), Reported("turbulence", "turbulence", "1"),
                  Reported("turbulence_cutoff_Hz", "turbulence_cutoff", "Hz")),
    )  # fmt: skip
