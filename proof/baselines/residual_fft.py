"""Baseline that names each line of the residual spectrum after the nearest line of the kinematic table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from proof.baselines.calibrated import Calibrated, CalibratedRun
from proof.baselines.named_lines import NamedLine, named_lines
from proof.baselines.verdict import Named, verdict
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of

CLEAR = 36.0  # [1] power over the local median; noise exceeds it in one bin of 1e10
NEAR = 0.004  # [1] largest relative distance to the nearest line of the table
_LOWEST, _TOP_SHARE = 3.0, 0.4  # [Hz], share of the sample rate
_LINE_BINS, _LINE_WIDTH = 5, 0.006  # [bins], and share of the frequency, masked on both sides of a known line
LEAST = 0.002  # [N m] smaller lines are ignored
_NEIGHBOURS = 60  # bins on both sides for the local median


@dataclass(frozen=True)
class Line:
    """A line of the residual: frequency [Hz], amplitude [N m], and its row of the table, or None."""

    frequency: float
    amplitude: float
    named: NamedLine | None


def residual_fft(start: Calibrated) -> dict[str, Any]:
    """Return the verdict: each mechanism by its strongest line; ``unexplained`` if a line has no name.

    Only steady runs count. Frequencies of the calibrated model are excluded.
    """
    rig = start.rig
    lines = [line for run in start.runs if run.steady for line in lines_of(run, rig)]
    strongest: dict[str, Line] = {}
    for line in sorted(lines, key=lambda one: -one.amplitude):
        if line.named is not None:
            strongest.setdefault(line.named.mechanism, line)
    found = [_named(line, lines) for line in strongest.values()]
    nameless = any(line.named is None for line in lines)
    return verdict("unexplained" if nameless else "missing_physics" if found else "adequate", start, found)


def lines_of(run: CalibratedRun, rig: Rig) -> Iterator[Line]:
    """Yield the significant lines of a run that ``rig`` lacks."""
    from scipy.ndimage import median_filter

    speed, window = run.mean_speed, np.hanning(run.torque.size)
    spectrum = np.abs(np.fft.rfft((run.torque - run.torque.mean()) * window)) * 2 / window.sum()
    step = run.rate / run.torque.size
    power = spectrum**2
    floor = median_filter(power, size=2 * _NEIGHBOURS + 1, mode="nearest")
    power[_modelled(rig, speed, step, power.size)] = 0.0
    table = named_lines(rig, motor_speed=speed)
    for at in _tops(power / np.maximum(floor, 1e-30), step):
        frequency = at * step
        if spectrum[at] > LEAST:
            yield Line(frequency, float(spectrum[at]), _nearest(frequency, table))


def _modelled(rig: Rig, speed: float, step: float, bins: int) -> NDArray[np.bool_]:
    """Return a mask of the bins around the lines of the model and their sidebands.

    A speed variation once per turn of one shaft gives sidebands to the lines of the other; they are no mechanism.
    """
    marked = np.zeros(bins, dtype=bool)
    turn = 1.0 / kinematics_of(rig).ratio
    for line in Twin(rig).lines():
        for order in (line.order - turn, line.order, line.order + turn):
            at = abs(order * speed) / (2 * pi) / step
            width = max(_LINE_BINS, _LINE_WIDTH * at)
            marked[max(int(at - width), 0) : int(at + width) + 2] = True
    return marked


def _tops(excess: NDArray[np.float64], step: float) -> list[int]:
    above = np.flatnonzero(excess > CLEAR)
    kept = (above * step > _LOWEST) & (above < 2 * _TOP_SHARE * excess.size)
    return [int(at) for at in above[kept] if excess[at] == excess[max(at - 3, 0) : at + 4].max()]


def _nearest(frequency: float, table: Sequence[NamedLine]) -> NamedLine | None:
    row = min(table, key=lambda one: abs(one.frequency - frequency))
    return row if abs(row.frequency / frequency - 1) < NEAR else None


def _named(line: Line, lines: Sequence[Line]) -> Named:
    row = line.named
    assert row is not None
    total = sum(one.amplitude**2 for one in lines)
    return Named(
        mechanism=row.mechanism,
        confidence=min(0.99, line.amplitude**2 / total),
        explanation=f"A line of {line.amplitude:.3g} N m at {line.frequency:.2f} Hz is nearest to {row.mechanism}.",
        parameters={row.parameter: row.value},
    )
