"""Bearing defect: impacts at an order that is whole on no shaft, each of which rings a local mode."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import log, pi

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import SHARE_OF_SIGNAL, Context
from torquerig.inference.features.impacts import Impact, search_impacts
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.inference.shafts import Shaft

NAMES = ("bearing_defect",)
KEEPS = True

_LOG_ODDS = -4.0
_WHOLE = 0.03  # [1/rev] so near to a whole order of a shaft, or a bin of the search, load and lines beat as well
_MOST_FACTOR = 25.0  # [nats] that the beat may count: the band that rings must be explained too
_DAMPING, _DAMPING_SPREAD = 0.03, 0.7  # and of its logarithm
_FREQUENCY_SPREAD = 0.2  # of its logarithm
_SLIP, _SLIP_SPREAD = 0.005, 1.2  # [1] of the angle between impacts: balls roll with slip; and of its logarithm
_LEAST_RING = 30.0  # [Hz] races and housings ring no slower: Randall & Antoni 2011, MSSP 25(2), speak of kilohertz
_STRONGEST = 2  # bands that exceed the model most, in one of which the mode may be


def propose(context: Context) -> Iterator[Addition]:
    """Yield impacts at the last shaft where the envelope of a band beats."""
    shaft = context.shafts[-1]
    impact = search_impacts(context.data.seen, shaft.turns)
    if impact is None or context.rig.of_kind("bearing_defect"):
        return
    shares = [shaft.turns / other.turns for other in context.shafts]
    orders = [(impact.order * share, max(_WHOLE, impact.step * share)) for share in shares]
    if all(abs(order - round(order)) > near for order, near in orders):
        frequencies = dict.fromkeys((impact.frequency, *context.bands_above()[:_STRONGEST]))
        for frequency in (each for each in frequencies if each > _LEAST_RING):
            yield _impacts(context, shaft, replace(impact, frequency=frequency))


def _impacts(context: Context, shaft: Shaft, impact: Impact) -> Addition:
    name, own = free_name(context.rig, "bearing_defect"), impact.order * shaft.turns
    beat = impact.log_p_near(impact.frequency)  # a mode that impacts ring beats with them
    comb = _comb(context, own)
    own = refined(own, [place.at for place in comb if place.domain == "order"])
    impact = replace(impact, order=own / shaft.turns)
    part = mechanisms.BearingDefect(
        name=name, at=shaft.part, order_output=impact.order, ring_frequency=impact.frequency, damping=_DAMPING,
        amplitude=SHARE_OF_SIGNAL * context.signal, slip=_SLIP,
    )  # fmt: skip
    sizes = -1.5, -0.75, 0.0, 0.75, 1.5
    return Addition(
        mechanism="bearing_defect", parts=(part,), starts=tuple((size, 0.0, 0.0, 0.0) for size in sizes),
        knobs=(Knob(name, "amplitude", DECADE), Knob(name, "ring_frequency", _FREQUENCY_SPREAD),
               Knob(name, "damping", _DAMPING_SPREAD), Knob(name, "slip", _SLIP_SPREAD)),
        places=comb, log_odds=_LOG_ODDS + min(largest_factor(beat), _MOST_FACTOR),
        label=f"impacts {impact.order:.4g} times a turn of {shaft.part} that ring near {impact.frequency:.3g} Hz",
        fixed={"order_output": (impact.order, context.order_step / shaft.turns, "1/rev")},
        reported=(Reported("ring_frequency_Hz", "ring_frequency", "Hz"), Reported("amplitude_Nm", "amplitude", "N*m")),
    )  # fmt: skip


def _comb(context: Context, order: float) -> tuple[Place, ...]:
    """Return the found lines at multiples of an order of the motor, or of its frequency in one of the runs."""
    turning = [abs(segment.speed) / (2 * pi) for seen in context.data.seen for segment in seen.segments]
    answer = []
    for line in context.lines:
        place = line.place
        tones = [(place.at, order * each, context.resolution) for each in turning if each]
        near = max(context.order_error * place.at, context.order_step)
        bases = tones if place.domain == "frequency" else [(place.at, order, near)]
        if any(at > 0.5 * base and abs(at - round(at / base) * base) < within for at, base, within in bases):
            answer.append(place)
    return tuple(answer)


def refined(order: float, comb: Sequence[float]) -> float:
    """Return the order of impacts by the found lines of their comb [1/rev]: the median of what each multiple says.

    The beat of an envelope has the width of a few of its periods; a line is sharper by its multiple.
    """
    return float(np.median([at / max(round(at / order), 1) for at in comb])) if comb else order


def largest_factor(log_p: float) -> float:
    """Return the largest Bayes factor that a p-value permits [nats]: ``1 / (-e p ln p)`` (Sellke et al. 2001)."""
    return -1.0 - log_p - log(-log_p) if log_p < -1.0 else 0.0
