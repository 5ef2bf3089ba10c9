"""The sample rate of a recording, from its sidecar, from the file, or from a time column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.long_format import refuse_long_format
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.sidecar import Sidecar
from torquerig.recordings.files.time_unit import in_unit, unit_evidence
from torquerig.recordings.files.timing import Timing, timing_of

# largest relative difference of two stated rates (a rounded time column) [1]
_CONTRADICTION = 1e-3
EVENLY = "cut the recording there, or resample it with 'torquerig join'"
"""What to do with uneven times."""


def sample_rate_of(table: Table, names: Iterable[str], *, sidecar: Sidecar | None, where: str) -> float:
    """Return the sample rate of the channels ``names`` [Hz]: the sidecar's, else the file's, else the time column's.

    Raises
    ------
    RecordingError
        When the rate is not stated, or two statements differ by more than 0.1 %.
    """
    time, used = table.time_name(), list(names)
    timing = None
    if time is not None:
        times, stated = table.columns[time], stated_rate(table.rates, used, sidecar=sidecar)
        signals = {name: values for name, values in table.columns.items() if name != time}
        refuse_long_format(times, signals, skipped=table.skipped, name=time, where=where)
        timing = timing_of(times, name=time, stated=stated)
        refuse_problem(timing, name=time, where=where)
        if not table.time_has_unit:
            seconds, _ = unit_evidence(
                timing, first=float(times[0]), samples=times.size, stated=stated, name=time, where=where
            )
            timing = in_unit(timing, seconds)
    return agreed_rate(table.rates, used, timing=timing, time_name=time, sidecar=sidecar, where=where)


def stated_rate(rates: Mapping[str, float], names: Iterable[str], *, sidecar: Sidecar | None) -> float | None:
    """Return the rate that the sidecar states, else the file for the first of ``names``, else None [Hz]."""
    if sidecar is not None and sidecar.sample_rate is not None:
        return sidecar.sample_rate
    return next((rates[name] for name in names if name in rates), None)


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
    rates: Mapping[str, float], names: Iterable[str], *, timing: Timing | None, time_name: str | None,
    sidecar: Sidecar | None, where: str,
) -> float:  # fmt: skip
    """Return the rate that sidecar, file and time column agree upon [Hz]; RecordingError as :func:`sample_rate_of`."""
    stated: dict[str, float] = {}
    if sidecar is not None and sidecar.sample_rate is not None:
        stated[f"{sidecar.path.name} (sample_rate_Hz)"] = sidecar.sample_rate
    for name in names:
        if name in rates:
            stated[f"the file's entry for {name}"] = rates[name]
    if timing is not None:
        stated[f"the column {time_name}"] = timing.rate
    if not stated:
        raise RecordingError(
            f"{where}: the sample rate is not stated; write it into a sidecar {_stem(where)}.yaml as "
            "sample_rate_Hz: NUMBER, or add a column time_s"
        )
    (first, rate), *rest = stated.items()
    for other, value in rest:
        allowed = max(_CONTRADICTION, timing.uncertainty if timing is not None and value == timing.rate else 0.0)
        if abs(value - rate) > allowed * rate:
            raise RecordingError(
                f"{where}: {first} states {rate:.10g} samples per second and {other} states {value:.10g}; "
                "correct one of them"
            )
    return rate


def rate_of_times(times: NDArray[np.float64], *, name: str, where: str) -> float:
    """Return the sample rate [Hz] of evenly spaced ``times`` [s], shape (samples,); see :func:`timing_of`.

    Raises
    ------
    RecordingError
        When a time is not a number, or the samples are not even; with places and counts.
    """
    timing = timing_of(times, name=name)
    refuse_problem(timing, name=name, where=where)
    return timing.rate


def usual_rate(times: NDArray[np.float64], *, name: str, where: str) -> float:
    """Return the sample rate [Hz] of ``times`` [s] that may have gaps, from the steps that are one sample long.

    Raises
    ------
    RecordingError
        Where the time does not rise at all.
    """
    timing = timing_of(times, name=name)
    if not timing.rate > 0:
        refuse_problem(timing, name=name, where=where)
    return timing.rate


def refuse_problem(timing: Timing, *, name: str, where: str) -> None:
    """Raise RecordingError where times show lost, doubled or uneven samples."""
    if not timing.problem:
        return
    remedies = {
        "does not rise": "put the rows in order and remove doubles, or join parts only where time continues",
        "has ": "record it again",
    }
    remedy = next((one for start, one in remedies.items() if timing.problem.startswith(start)), EVENLY)
    raise RecordingError(f"{where}: {name} {timing.problem}; {remedy}")


def _stem(where: str) -> str:
    return where.rpartition(".")[0] or where
