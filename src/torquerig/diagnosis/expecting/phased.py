"""A rig whose lines have the phases that a run shows, so that a simulation repeats the run itself."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.linear.quasi_static import quasi_static
from torquerig.diagnosis.linear.twin import LineSource, Twin
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.places import order
from torquerig.diagnosis.looking.regression import regressed
from torquerig.diagnosis.looking.turning import turns_back
from torquerig.diagnosis.looking.waves import Waves
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Gear

Floats = NDArray[np.float64]

_PIECE = 2.0  # [s] a phase is followed over pieces of this length
_THINNED = 2500.0  # [Hz] samples that the regression takes
_SLOWEST = 0.05  # [Hz]
_SEEN = 0.25  # share of a piece without which it tells no phases


def with_phases_of(rig: Rig, observed: Observed, *, held: bool | None = None) -> Rig:
    """Return ``rig`` at the run with the phase of every torque ripple as measured there.

    The phase of a line at its source is that of the reading less that of the transfer between them (linear twin).

    Parameters
    ----------
    rig : Rig
    observed : Observed
    held : bool or None
        Measured in which stretches: those that fits may see (False), may not see (True), or all (None).
    """
    twin = Twin(rig.at(observed.run))
    sources = {(line.owner, round(line.order, 6)): line for line in twin.lines()}
    orders = sorted({order for _, order in sources})
    pieces = _amplitudes(twin, observed, orders, observed.mask(held=held))
    for ripple in rig.parts_of(TorqueRipple):
        turns = twin.turns[rig.node(ripple.at)]
        phases = {
            own: _phase(sources[ripple.name, round(own * turns, 6)], pieces, orders.index(round(own * turns, 6)))
            for own in ripple.amplitudes
        }
        rig = rig.changed(replace(ripple, phases=phases))
    return rig


def phases_tell(rig: Rig) -> bool:
    """Whether more than the lines depends on their phases: flanks may part where several meet."""
    return any(part.gap > 0 for part in rig.of_kind("backlash")) or any(
        part.backlash > 0 for part in rig.parts_of(Gear)
    )


def as_in_runs(rig: Rig, seen: Sequence[Features]) -> list[Rig]:
    """Return ``rig`` for every run, with the phases that are measured where fits may see it."""
    return [with_phases_of(rig, features.observed, held=False) for features in seen]


def _amplitudes(
    twin: Twin, observed: Observed, orders: Sequence[float], wanted: NDArray[np.bool_]
) -> list[tuple[NDArray[np.complex128], Floats]]:
    """Complex amplitude and frequency [Hz] of every order in each piece of the run that has wanted samples enough."""
    step = max(1, int(observed.rate / _THINNED))
    angle, speed, torque = observed.angle[::step], observed.speed[::step], observed.torque[::step]
    weight = wanted[::step].astype(float)
    rate = observed.rate / step
    if turns_back(observed):
        slow = quasi_static(twin, speed=speed, acceleration=np.gradient(speed) * rate).sensor
        torque, edges = torque - slow, np.array([0, angle.size])
    else:
        edges = np.linspace(0, angle.size, max(1, round(angle.size / rate / _PIECE)) + 1).astype(int)
    answer = []
    for start, stop in itertools.pairwise(edges):
        time, window = np.arange(start, stop) / rate, weight[start:stop]
        if window.mean() < _SEEN:
            continue
        turning = Waves([order(each) for each in orders], angle[start:stop], time)
        found = regressed(torque[start:stop], turning, window=window)
        at = np.maximum(np.array(orders) * float(np.abs(speed[start:stop]).mean()) / (2 * np.pi), _SLOWEST)
        answer.append((found.amplitude, at))
    return answer


def _phase(line: LineSource, pieces: list[tuple[NDArray[np.complex128], Floats]], row: int) -> float:
    turned = [size[row] * np.conj(line.transfer(at[row : row + 1])[0]) for size, at in pieces]
    return float(np.angle(np.sum(turned)))
