"""Torsional mode: a further inertia on a spring at the last shaft."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.terms import Inertia

NAMES = ("torsional_mode",)

_LOG_ODDS = -5.0  # within one step of the grid of frequencies
_PER_OCTAVE = 4  # steps
_LOWEST, _HIGHEST = 8.0, 0.2  # times the lowest band, to be wider than a bin at a damping of 0.03; of the sample rate
_DAMPING, _DAMPING_SPREAD = 0.02, 0.8
_SHARE, _SHARE_SPREAD = 0.3, 1.0  # of the inertia of the shaft that carries it
_STARTS = ((0.0, 0.0, 0.0), (-1.0, -1.0, 0.0), (1.0, -1.0, 0.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield a branch at each frequency of a grid; a fit then moves it."""
    rig, shaft = context.rig, context.shafts[-1]
    top = _HIGHEST * min(seen.run.rate for seen in context.data.seen)
    node = rig.node(shaft.part)
    carried = sum(term.inertia for term in rig.terms() if isinstance(term, Inertia) and term.node == node)
    name, step = free_name(rig, "torsional_mode"), 1.0 / _PER_OCTAVE
    lowest = _LOWEST * min(seen.run.slowest for seen in context.data.seen)
    for octave in np.arange(np.log2(max(top, 2 * lowest)), np.log2(lowest), -step) if carried else ():
        part = mechanisms.TorsionalMode(
            name=name, after=shaft.part, frequency=float(2**octave), inertia=_SHARE * carried, damping_ratio=_DAMPING
        )
        yield Addition(
            mechanism="torsional_mode", parts=(part,), starts=_STARTS, log_odds=_LOG_ODDS,
            knobs=(Knob(name, "frequency", 0.25 * step), Knob(name, "inertia", _SHARE_SPREAD),
                   Knob(name, "damping_ratio", _DAMPING_SPREAD)),
            label=f"an inertia on a spring at {shaft.part}, near {2**octave:.3g} Hz",
            reported=(Reported("frequency_Hz", "frequency", "Hz"), Reported("inertia_kgm2", "inertia", "kg*m^2"),
                      Reported("damping_ratio", "damping_ratio", "1")),
        )  # fmt: skip
