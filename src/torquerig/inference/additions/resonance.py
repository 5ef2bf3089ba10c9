"""A nameless hump of the spectrum: noise in a band of fixed frequency."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.diagnosis.fitting.knobs import Knob
from torquerig.inference.addition import DECADE, Addition, free_name
from torquerig.inference.context import SHARE_OF_SIGNAL, Context

_LOG_ODDS = -6.0
_STRONGEST = 4  # bands from which a hump is started
_WIDTH, _WIDTH_SPREAD = 0.08, 0.8  # one sigma of the frequency's logarithm, and of the width's
_FREQUENCY_SPREAD = 0.1  # of the frequency's logarithm
_STARTS = tuple((size, 0.0, 0.0) for size in (-1.0, -0.5, 0.0, 0.5, 1.0))


def propose(context: Context) -> Iterator[Addition]:
    """Yield a hump at each of the bands that exceed the model most in all runs together."""
    name = free_name(context.rig, "unnamed_hump")
    rms = SHARE_OF_SIGNAL * context.signal / context.unit
    for frequency in context.bands_above()[:_STRONGEST]:
        yield Addition(
            kind="resonance", log_odds=_LOG_ODDS, label=f"a hump of the spectrum near {frequency:.4g} Hz",
            parts=(mechanisms.NoiseHump(name=name, rms=rms, frequency=frequency, width=_WIDTH),),
            knobs=(Knob(name, "rms", DECADE), Knob(name, "frequency", _FREQUENCY_SPREAD),
                   Knob(name, "width", _WIDTH_SPREAD)),
            starts=_STARTS,
        )  # fmt: skip
