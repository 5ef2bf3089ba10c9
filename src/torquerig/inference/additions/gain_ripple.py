"""A nameless line and its multiples in proportion to the torque: of the reading, or at a motor, whatever its cause."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import log

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import floor_density
from torquerig.inference.places import Place
from torquerig.inference.undecided_lines import column_of
from torquerig.rig.assembly import Part
from torquerig.rig.parts import Motor

_LOG_ODDS = -10.0  # anywhere on the search grid, as of a line of constant torque, and one of three grows with the load
_LOG_ODDS_KNOWN = -3.0  # the same of a line that the model has already, of which a part may grow with the load
_MEDIAN = 0.03  # of the torque: prior median of the depth, as of a ripple in proportion to the torque of a motor
_HARMONICS = 6
_CLEAREST = 8  # lines; others follow when these are explained
_VARIES = 1.2  # [1] ratio of two mean torques; where they are nearer, the line has one size
_NAME = "unnamed_gain"

Made = Callable[[tuple[float, ...]], Part]


def propose(context: Context) -> Iterator[Addition]:
    """Yield ripples for each found line, where the expected mean torques differ."""
    levels = np.concatenate([np.zeros(0), *(np.abs(each.level) for each in context.fit.expected)])
    if levels.max(initial=0.0) > _VARIES * levels.min(initial=np.inf):
        for line in context.lines[:_CLEAREST]:
            made = dict(_parts(context, line.place))
            odds = (_LOG_ODDS_KNOWN if _is_known(context, line.place) else _LOG_ODDS) - log(len(made))
            for acts, one in made.items():
                yield from _ripple(context, line.place, one, acts, odds=odds)


def _is_known(context: Context, place: Place) -> bool:
    """Return whether the model has a line at a place that exceeds the noise somewhere."""
    for seen, model in zip(context.data.seen, context.fit.expected, strict=True):
        at = column_of(seen, place)
        noise = seen.lines.noise_bandwidth[:, at] * floor_density(seen, model)[:, at]
        if ((model.line_power[:, at] > noise) & (seen.lines.count[:, at] > 0)).any():
            return True
    return False


def _parts(context: Context, place: Place) -> Iterator[tuple[str, Made]]:
    """Yield where a ripple may act, and the part with given depths there; only a torque shakes the shafts."""
    name, turning = free_name(context.rig, _NAME), place.domain == "order"
    order, frequency = (place.at, 0.0) if turning else (0.0, place.at)

    def gain(depths: tuple[float, ...]) -> Part:
        return mechanisms.GainRipple(name=name, order_motor=order, frequency=frequency, depths=depths)

    def torque(at: str, depths: tuple[float, ...]) -> Part:
        return mechanisms.CommutationRipple(
            name=name, at=at, order_motor=order, depth=depths[0], harmonics=depths[1:]
        )  # fmt: skip

    yield "", gain
    if turning and hasattr(mechanisms, "CommutationRipple"):
        yield from ((motor.name, partial(torque, motor.name)) for motor in context.rig.parts_of(Motor))


def _ripple(context: Context, place: Place, made: Made, acts: str, *, odds: float) -> Iterator[Addition]:
    name, multiples = free_name(context.rig, _NAME), context.multiples(place, most=_HARMONICS)

    def knob(multiple: int) -> Knob:
        if not acts:
            return Knob(name, "depths", DECADE, key=multiple - 1)
        return Knob(name, "depth", DECADE) if multiple == 1 else Knob(name, "harmonics", DECADE, key=multiple - 2)

    found = harmonics(
        context, multiples, unit=lambda multiple: made((*(0.0,) * (multiple - 1), 1.0)), median=_MEDIAN, knob=knob
    )
    if 1 in found.medians:
        turning = place.domain == "order"
        where = f"order {place.at:.6g} of the motor" if turning else f"{place.at:.5g} Hz"
        yield Addition(
            kind="line_family" if turning else "tone", variant="by_load", parts=(made(found.row()),),
            knobs=tuple(found.knobs), starts=(tuple(found.start),), places=tuple(multiples.values()), log_odds=odds,
            label=f"a {'torque' if acts else 'line'} at {where}, in proportion to the torque",
        )  # fmt: skip
