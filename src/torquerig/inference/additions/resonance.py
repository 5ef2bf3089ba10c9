"""Nameless noise: a hump of the spectrum, a wide band, or a torque that changes slowly at random.

All have one log-normal density behind the amplifier, in all runs the same. A slow one moves the mean torques too: the
covariance of the levels holds it.
"""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import SHARE_OF_SIGNAL, Context
from torquerig.inference.knobs import Knob

_LOG_ODDS, _LOG_ODDS_WIDE = -6.0, -8.0  # wide noise is what nobody knows of a load, and sizes of the load follow first
_STRONGEST = 4  # bands from which a hump is started
_WIDTH, _WIDTH_SPREAD = 0.08, 0.8  # one sigma of the frequency's logarithm, and of the width's
_PLACE_SPREAD = 0.1  # of the frequency's logarithm
_WIDE, _WIDE_SPREAD, _WIDE_PLACE_SPREAD = 0.7, 0.5, 0.4  # the same of wide noise
_SLOW = 0.5  # [1] of the lowest band: noise of seconds, such as that of contacts that open and of what clumps
_STARTS = tuple((size, 0.0, 0.0) for size in (-1.0, -0.5, 0.0, 0.5, 1.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield humps and wide noise at the bands that exceed the model most in all runs together, and slow noise."""
    strongest = context.bands_above()[:_STRONGEST]
    for frequency in strongest:
        yield _noise(context, frequency, _WIDTH, label=f"a hump of the spectrum near {frequency:.4g} Hz")
    for frequency in strongest[:2]:
        yield _noise(context, frequency, _WIDE, label=f"noise in a wide band near {frequency:.4g} Hz")
    slowest = min(float(seen.bands.low[0]) for seen in context.data.seen)
    yield _noise(context, _SLOW * slowest, _WIDE, label="a torque that changes slowly at random", kind="level_course")


def _noise(context: Context, frequency: float, width: float, *, label: str, kind: str = "resonance") -> Addition:
    name, wide = free_name(context.rig, "unnamed_hump"), width == _WIDE
    rms = SHARE_OF_SIGNAL * context.signal / context.unit
    return Addition(
        kind=kind, variant="wide" if wide else "", log_odds=_LOG_ODDS_WIDE if wide else _LOG_ODDS, label=label,
        parts=(mechanisms.NoiseHump(name=name, rms=rms, frequency=frequency, width=width),),
        knobs=(Knob(name, "rms", DECADE), Knob(name, "frequency", _WIDE_PLACE_SPREAD if wide else _PLACE_SPREAD),
               Knob(name, "width", _WIDE_SPREAD if wide else _WIDTH_SPREAD)),
        starts=_STARTS,
    )  # fmt: skip
