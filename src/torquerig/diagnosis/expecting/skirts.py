"""What surrounds a line because a random load shakes the speed, and with it the line's phase or its size."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.kept import kept
from torquerig.linear_twin.twin import Twin
from torquerig.rig.terms import Inertia

Floats = NDArray[np.float64]

FOLLOWED = 2.0  # [Hz] slower than this an angle that was not measured is followed in the torque
_TAKEN_OUT = 0.5  # of the smearing width beside a line no bin counts


def skirts(twin: Twin, seen: Features) -> Floats:
    """Return the density [(N m)^2/Hz] in each band of what random loads put beside the lines of a run."""
    if not twin.drives:
        return np.zeros(seen.band.size)
    beside = _by_size(twin, seen)
    return beside if seen.observed.angle_measured else beside + _by_phase(twin, seen)


def _by_phase(twin: Twin, seen: Features) -> Floats:
    """Phase modulation, where the angle was not measured; else the lines are taken out along it.

    A line of amplitude A and order n has ``A^2 / 4 n^2 S(f - f_n)`` beside it, S being the density of the motor's
    angle: the random load over the turns to it, through the motor's impedance ``J s + kp + ki / s``, all shafts taken
    as rigid.
    """
    lines = _lines(seen)
    return np.asarray((0.25 * lines.power * lines.order**2) @ _straying(twin, lines.apart))


class _Lines(NamedTuple):
    """Mean squares [(N m)^2] and orders of the lines that a run shows, shape (lines,), and how far bands are from them.

    The latter is of shape (lines, bands) [Hz].
    """

    power: Floats
    order: Floats
    apart: Floats


@kept
def _lines(seen: Features) -> _Lines:
    turning = [column for column, place in enumerate(seen.places) if place.domain == "order"]
    shown = np.isfinite(seen.amplitude[:, turning])
    square = np.where(shown, np.abs(seen.amplitude[:, turning]) ** 2, 0.0).sum(axis=0)
    power = square / np.maximum(shown.sum(axis=0), 1)
    orders = np.array([seen.places[column].at for column in turning])[power > 0]
    at = orders[:, None] * abs(seen.observed.mean_speed) / (2 * pi)
    apart = np.maximum(
        np.abs(seen.band - at), np.maximum(FOLLOWED, _TAKEN_OUT * seen.observed.smearing * at)
    )  # fmt: skip
    return _Lines(power[power > 0], orders, apart)


def _by_size(twin: Twin, seen: Features) -> Floats:
    """Amplitude modulation of a ripple in proportion to the motor's torque.

    A ripple of depth d at the frequency f_n has ``d^2 / 4 S(f - f_n) |H(f)|^2`` beside it, S being the density of what
    the speed loop answers to the load and H the transfer of a motor's torque to the reading.
    """
    lines = [line for line in twin.lines() if line.by_load and line.amplitude > 0]
    if not lines:
        return np.zeros(seen.band.size)
    at = np.array([line.order for line in lines])[:, None] * abs(seen.observed.mean_speed) / (2 * pi)
    through = {id(line.transfer): line.transfer for line in lines}
    passing = {name: np.abs(transfer(seen.band)) ** 2 for name, transfer in through.items()}
    answered = twin.answered_power(np.abs(seen.band - at))
    depths = np.array([0.25 * line.amplitude**2 for line in lines])[:, None]
    return np.asarray((depths * answered * np.array([passing[id(line.transfer)] for line in lines])).sum(axis=0))


def _straying(twin: Twin, frequencies: Floats) -> Floats:
    """Density of the motor's angle [rad^2/Hz]."""
    drive, square = twin.drives[0], (2 * pi * frequencies) ** 2
    inertia = sum(
        term.inertia * twin.turns[term.node] ** 2
        for term in twin.terms
        if isinstance(term, Inertia) and term.node in twin.turns
    )
    turns = min(twin.turns.values())
    stiffness = (drive.ki - inertia * square) ** 2 + drive.kp**2 * square  # of the impedance times s, squared
    return np.asarray(twin.load_power(frequencies) * turns**2 / stiffness)
