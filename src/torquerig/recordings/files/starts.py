"""Channels that start earlier or later than the first one: noted below one sample, refused from there on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from torquerig.errors import RecordingError

# share of a sample from which a difference shifts the channels against each other
_NOTICED = 0.1
# samples from which channels that are read as if they started together would be misread; start times are rounded [1]
_REFUSED = 0.99


def late_starts(starts: Mapping[str, float], rates: Mapping[str, float]) -> tuple[str, ...]:
    """Return a sentence for each channel that starts a tenth of a sample or more before or after the first.

    Parameters
    ----------
    starts : mapping of str to float
        The time of the first sample [s], for the channels whose file states it.
    rates : mapping of str to float
        Sample rates [Hz].
    """
    first, late = _late(starts, rates, _NOTICED)
    return tuple(
        f"{name} starts {_apart(seconds)} {first}; torquerig join brings them together"
        for name, seconds in late.items()
    )


def refuse_late_starts(
    starts: Mapping[str, float], rates: Mapping[str, float], names: Iterable[str], *, where: str
) -> None:
    """Raise RecordingError where one of the channels ``names`` starts a sample or more before or after the first."""
    used = set(names)
    first, late = _late({name: start for name, start in starts.items() if name in used}, rates, _REFUSED)
    for name, seconds in late.items():
        raise RecordingError(
            f"{where}: {name} starts {_apart(seconds)} {first}; bring them to one time with: torquerig join {where}"
        )


def remedy_for_lengths(rates: Mapping[str, float], names: Iterable[str], *, where: str) -> str:
    """Return what brings channels of unequal lengths to one span; empty where the file does not state their rates."""
    return f"cut them to the time that all have with: torquerig join {where}" if set(names) <= set(rates) else ""


def _late(starts: Mapping[str, float], rates: Mapping[str, float], limit: float) -> tuple[str, dict[str, float]]:
    """Return the first channel, and how much later those start that differ by more than ``limit`` samples [s]."""
    first = next((name for name in starts if name in rates), "")
    return first, {
        name: start - starts[first]
        for name, start in starts.items()
        if name in rates and abs(start - starts[first]) * rates[name] > limit
    }


def _apart(seconds: float) -> str:
    return f"{abs(seconds):.6g} s {'after' if seconds > 0 else 'before'}"
