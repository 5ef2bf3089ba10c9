"""Channels that start earlier or later than the first one."""

from __future__ import annotations

from collections.abc import Mapping

# share of a sample from which a difference shifts the channels against each other
_NOTICED = 0.1


def late_starts(starts: Mapping[str, float], rates: Mapping[str, float]) -> tuple[str, ...]:
    """Return a sentence for each channel that starts a tenth of a sample or more before or after the first.

    Parameters
    ----------
    starts : mapping of str to float
        The time of the first sample [s], for the channels whose file states it.
    rates : mapping of str to float
        Sample rates [Hz].
    """
    first = next((name for name in starts if name in rates), None)
    if first is None:
        return ()
    return tuple(
        f"{name} starts {start - starts[first]:.6g} s after {first}; the samples are read as if they started together"
        for name, start in starts.items()
        if name in rates and abs(start - starts[first]) * rates[name] > _NOTICED
    )
