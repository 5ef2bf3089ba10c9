"""The sample rate of a recording, from its sidecar, from the file, or from a time column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.sidecar import Sidecar

# largest deviation of a time from the even grid [samples]; one lost sample makes half a sample or more
_UNEVEN = 0.25
# largest relative difference of two stated rates (a rounded time column) [1]
_CONTRADICTION = 1e-3


def sample_rate_of(table: Table, names: Iterable[str], *, sidecar: Sidecar | None, where: str) -> float:
    """Return the sample rate of the channels ``names`` [Hz]: the sidecar's, else the file's, else the time column's.

    Raises
    ------
    RecordingError
        When the rate is not stated, or two statements differ by more than 0.1 %.
    """
    time = table.time_name()
    by_time = None if time is None else rate_of_times(table.columns[time], name=time, where=where)
    return agreed_rate(table.rates, names, by_time=by_time, time_name=time, sidecar=sidecar, where=where)


def refuse_two_rates(rates: Mapping[str, float], names: Iterable[str], *, where: str) -> None:
    """Raise RecordingError, with both rates, where the file states two rates for the channels ``names``."""
    stated = {name: rates[name] for name in names if name in rates}
    first = next(iter(stated), "")
    for other, rate in stated.items():
        if abs(rate - stated[first]) > _CONTRADICTION * stated[first]:
            raise RecordingError(
                f"{where}: {first} has {stated[first]:.10g} samples per second and {other} has {rate:.10g}; name only "
                f"channels of one rate in the sidecar's channels, or resample them with: torquerig join {where}"
            )


def agreed_rate(
    rates: Mapping[str, float], names: Iterable[str], *, by_time: float | None, time_name: str | None,
    sidecar: Sidecar | None, where: str,
) -> float:  # fmt: skip
    """Return the rate that sidecar, file and time column agree upon [Hz]; RecordingError as :func:`sample_rate_of`."""
    stated: dict[str, float] = {}
    if sidecar is not None and sidecar.sample_rate is not None:
        stated[f"{sidecar.path.name} (sample_rate_Hz)"] = sidecar.sample_rate
    for name in names:
        if name in rates:
            stated[f"the file's entry for {name}"] = rates[name]
    if by_time is not None:
        stated[f"the column {time_name}"] = by_time
    if not stated:
        raise RecordingError(
            f"{where}: the sample rate is not stated; write it into a sidecar {_stem(where)}.yaml as "
            "sample_rate_Hz: NUMBER, or add a column time_s"
        )
    (first, rate), *rest = stated.items()
    for other, value in rest:
        if abs(value - rate) > _CONTRADICTION * rate:
            raise RecordingError(
                f"{where}: {first} states {rate:.10g} samples per second and {other} states {value:.10g}; "
                "correct one of them"
            )
    return rate


def rate_of_times(times: NDArray[np.float64], *, name: str, where: str) -> float:
    """Return the sample rate [Hz] of evenly spaced ``times`` [s], shape (samples,): the shortest decimal that fits.

    Raises
    ------
    RecordingError
        When a time is not a number, or deviates from the even grid by more than a quarter of a sample; with place and
        deviation. A lost sample makes a deviation of at least half a sample.
    """
    steps = np.diff(times)
    rising = steps > 0
    if not np.all(rising & np.isfinite(steps)):
        broken = int(np.argmin(rising & np.isfinite(steps))) + 1
        raise RecordingError(
            f"{where}: {name} does not rise at sample {broken} ({times[broken - 1]:.9g} s, then {times[broken]:.9g}); "
            "put the rows in order and remove doubles, or join parts only where time continues"
        )
    rate = (times.size - 1) / float(times[-1] - times[0])
    off = np.abs((times - times[0]) * rate - np.arange(times.size))
    worst = float(off.max())
    if worst > _UNEVEN:
        step = int(np.argmax(np.abs(steps * rate - 1)))
        raise RecordingError(
            f"{where}: {name} is not evenly spaced: it is up to {worst:.3g} samples off an even {rate:.6g} Hz, and the "
            f"step after sample {step} is {steps[step]:.6g} s instead of {np.median(steps):.6g} s; resample the "
            "recording evenly, or, if only the printed times are coarse, leave the column out and state sample_rate_Hz"
        )
    return shortest_rate(rate, tolerance=max(1e-11, 2 * worst / (times.size - 1)))


def shortest_rate(rate: float, *, tolerance: float) -> float:
    """Return the shortest decimal within the relative ``tolerance`` of ``rate``: 25000, not 24999.9999999987."""
    for digits in range(1, 17):
        candidate = float(f"{rate:.{digits}g}")
        if abs(candidate - rate) <= tolerance * rate:
            return candidate
    return rate


def _stem(where: str) -> str:
    return where.rpartition(".")[0] or where
