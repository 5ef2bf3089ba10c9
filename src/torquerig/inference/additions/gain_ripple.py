"""A nameless line and its multiples in proportion to the torque of each run, by an order or by a frequency."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place

_LOG_ODDS = -10.0  # anywhere on the search grid, as of a line of constant torque, and one of three grows with the load
_MEDIAN = 0.03  # of the torque: prior median of the depth, as of a ripple in proportion to the torque of a motor
_HARMONICS = 6
_CLEAREST = 8  # lines; others follow when these are explained
_VARIES = 1.2  # [1] ratio of two mean torques; where they are nearer, the line has one size


def propose(context: Context) -> Iterator[Addition]:
    """Yield a ripple of the gain for each found line, where the expected mean torques differ."""
    levels = np.concatenate([np.zeros(0), *(np.abs(each.level) for each in context.fit.expected)])
    if levels.max(initial=0.0) > _VARIES * levels.min(initial=np.inf):
        for line in context.lines[:_CLEAREST]:
            yield from _ripple(context, line.place)


def _ripple(context: Context, place: Place) -> Iterator[Addition]:
    name, turning = free_name(context.rig, "unnamed_gain"), place.domain == "order"
    multiples = context.multiples(place, most=_HARMONICS)

    def ripple(depths: tuple[float, ...]) -> mechanisms.GainRipple:
        order, frequency = (place.at, 0.0) if turning else (0.0, place.at)
        return mechanisms.GainRipple(name=name, order_motor=order, frequency=frequency, depths=depths)

    found = harmonics(
        context, multiples, unit=lambda multiple: ripple((*(0.0,) * (multiple - 1), 1.0)), median=_MEDIAN,
        knob=lambda multiple: Knob(name, "depths", DECADE, key=multiple - 1),
    )  # fmt: skip
    if 1 in found.medians:
        where = f"order {place.at:.6g} of the motor" if turning else f"{place.at:.5g} Hz"
        yield Addition(
            kind="line_family" if turning else "tone", variant="by_load", parts=(ripple(found.row()),),
            knobs=tuple(found.knobs), starts=(tuple(found.start),), places=tuple(multiples.values()),
            log_odds=_LOG_ODDS, label=f"a line at {where}, in proportion to the torque",
        )  # fmt: skip
