"""A rig whose lines have the phases that a run shows, so that a simulation repeats the run itself."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.motor_angle.smoothed_speed import turns_back
from torquerig.inference.places import order
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import LineSource, Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_PIECE = 2.0  # [s] a phase is followed over pieces of this length
_THINNED = 2500.0  # [Hz] samples that the regression takes
_SLOWEST = 0.05  # [Hz]
_SEEN = 0.25  # share of a piece without which it tells no phases


@dataclass(frozen=True, kw_only=True)
class Samples:
    """The samples of a run in which phases are measured.

    Parameters
    ----------
    run : Run
    rate : float
        Samples per second [Hz].
    torque : ndarray, shape (samples,)
        [N m]
    angle, speed : ndarray, shape (samples,)
        Of the motor [rad], [rad/s].
    used : ndarray of bool, shape (samples,)
        Which of them the phases are measured in.
    """

    run: Run
    rate: float
    torque: Floats
    angle: Floats
    speed: Floats
    used: NDArray[np.bool_]


def with_measured_phases(rig: Rig, samples: Samples) -> Rig:
    """Return ``rig`` with the phase of every torque ripple as measured in a run.

    The phase of a line at its source is that of the reading less that of the transfer between them (linear twin).
    """
    twin = Twin(rig.at(samples.run))
    sources = {(line.owner, round(line.order, 6)): line for line in twin.lines()}
    orders = sorted({order for _, order in sources})
    pieces = _amplitudes(twin, samples, orders)
    for ripple in rig.parts_of(TorqueRipple):
        turns = twin.turns[rig.node(ripple.at)]
        phases = {
            own: _phase(sources[ripple.name, round(own * turns, 6)], pieces, orders.index(round(own * turns, 6)))
            for own in ripple.amplitudes
        }
        rig = rig.changed(replace(ripple, phases=phases))
    return rig


def _amplitudes(twin: Twin, samples: Samples, orders: Sequence[float]) -> list[tuple[NDArray[np.complex128], Floats]]:
    """Complex amplitude and frequency [Hz] of every order in each piece of the run that has enough used samples."""
    step = max(1, int(samples.rate / _THINNED))
    angle, speed, torque = samples.angle[::step], samples.speed[::step], samples.torque[::step]
    weight = samples.used[::step].astype(float)
    rate = samples.rate / step
    if turns_back(samples.speed):
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
