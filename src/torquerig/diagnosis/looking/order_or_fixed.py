"""Whether a line seen at one speed turns with the shaft or stays at its frequency: what the speed's wander tells."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.signal import zoom_fft

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.steady_tone import steady_frequency
from torquerig.inference.places import SAME_ORDER, Place
from torquerig.orders.angle.speed_from_torque import motor_angle_from_torque
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of

DECIDED = 20.0  # twice the log-likelihood; chance over two fits of a frequency reaches 9 in one of a hundred
ONE_SPEED = 0.03  # speeds nearer than this are one, relative
_REACH = 3  # bins either way in which a line may be found
_COVERED = 9.0  # power over the floor: the noise of one bin in ten thousand is larger
_BETWEEN = 16  # points a bin at which it is sought: a Hann window loses 0.1 % beside them
_FLOOR = 40  # bins either way that make the local floor


def may_be_fixed(runs: Sequence[Observed], peak: Peak, known: Sequence[Place], rig: Rig) -> bool:
    """Whether a line of an order, known at one speed alone, may keep its frequency as far as these runs tell.

    Where its frequency falls on a line that the model has anyway, or noise would bury it, another speed tells nothing;
    where the speed wanders, an angle that owes nothing to the line may tell.
    """
    shown = [run for run in runs if run.steady and run.name in peak.runs]
    if peak.place.domain == "frequency" or peak.speeds > 1 or not shown:
        return False
    speed, fixed = shown[0].mean_speed, peak.place.frequency(shown[0].mean_speed)
    others = [run for run in runs if run.steady and abs(run.mean_speed / speed - 1) > ONE_SPEED]
    if not all(_hidden(fixed, run, known) or _buried(fixed, run, shown) for run in others):
        return False
    return evidence([followed_by(known, run, rig) for run in shown], peak.place) < DECIDED


def _hidden(fixed: float, run: Observed, known: Sequence[Place]) -> bool:
    """Whether a tone at ``fixed`` [Hz] would stand in a line that the model has anyway."""
    near = _REACH / run.recording.duration
    return any(abs(place.frequency(run.mean_speed) - fixed) < near for place in known)


def _buried(fixed: float, run: Observed, shown: Sequence[Observed]) -> bool:
    """Whether noise would cover a tone at ``fixed`` [Hz] in a run that is as large as in those that show it."""
    floor, tones = float(np.median(_bins_around(run, fixed))) / float(np.log(2)), []
    for other in shown:
        near = _bins_around(other, fixed)
        tones.append(near[_FLOOR - _REACH : _FLOOR + _REACH + 1].max())
    return bool(min(tones) < _COVERED * floor)


def _bins_around(run: Observed, fixed: float) -> NDArray[np.float64]:
    """Return the power of a tone in each bin near ``fixed`` [Hz], as one of amplitude 1 has it in any run."""
    part = run.seen
    torque = run.torque[part] - run.torque[part].mean()
    phase = np.asarray(2 * np.pi * fixed / run.rate * np.arange(torque.size), dtype=np.float64)
    return np.asarray(_around(torque, phase) / (np.hanning(torque.size).sum() / 2) ** 2, dtype=np.float64)


def rather_fixed(runs: Sequence[Observed], place: Place) -> bool:
    """Whether wander shows that a line at ``place`` (an order) keeps its frequency; only a measured angle can."""
    measured = [run for run in runs if run.steady and run.angle_measured]
    return bool(measured) and evidence(measured, place) < -DECIDED


def followed_by(known: Sequence[Place], run: Observed, rig: Rig) -> Observed:
    """Return the run with its measured angle, or one that is followed by the lines at ``known`` alone.

    Followed in the whole comb of the kinematics, a line that nobody asked for would follow itself.
    """
    if run.angle_measured:
        return run
    asked = [place.at for place in known if place.domain == "order"]
    lines = [
        line for line in kinematics_of(rig).lines() if any(abs(line.motor_order - at) < SAME_ORDER for at in asked)
    ]
    return replace(run, angle=motor_angle_from_torque(run.recording, lines).values)


def evidence(runs: Sequence[Observed], place: Place) -> float:
    """Return twice the logarithm of the likelihood that the line at an order turns, over that it keeps its frequency.

    Under either assumption the line is a peak of one bin: of the torque taken back by the shaft's angle, or by the time
    at the mean speed; both may lie some bins off. A line of amplitude A in noise of density S over T seconds has
    2 log L = A^2 T / S beyond the noise alone. Near 0 where the speed does not wander. Where nobody measured the speed
    the line stands where it is seen, and the order is one of those near it.
    """
    total = 0.0
    for run in runs:
        at = place.frequency(run.mean_speed)
        turned, still = _powers(run, place.at, at if run.angle_measured else steady_frequency(run, at))
        total += 2 * (turned - still)
    return total


def _powers(run: Observed, order: float, at: float) -> tuple[float, float]:
    """Power over the floor of the line as one that turns, and as one that stays.

    Where it stands on the whole is known from itself; only how the speed strays from its mean is asked of the angle.
    """
    part = run.seen
    torque, angle = run.torque[part] - run.torque[part].mean(), run.angle[part]
    strays = order * (angle - np.linspace(angle[0], angle[-1], angle.size))
    still = np.asarray(2 * np.pi * at / run.rate * np.arange(angle.size), dtype=np.float64)
    phases = (np.asarray(still + strays), still)
    # one floor for both: its chance would outweigh what a strong line loses
    floor = max(float(np.median([_around(torque, phase) for phase in phases])) / float(np.log(2)), 1e-30)
    turned, fixed = (_tallest(torque, phase) / floor for phase in phases)
    return turned, fixed


def _tallest(torque: NDArray[np.float64], phase: NDArray[np.float64]) -> float:
    """Return the largest power near a phase, between the bins: beside one a strong line loses more than by wander."""
    taken = torque * np.hanning(torque.size) * np.exp(-1j * phase)
    near = zoom_fft(taken, [-_REACH, _REACH], m=2 * _REACH * _BETWEEN + 1, fs=taken.size, endpoint=True)
    return float((np.abs(near) ** 2).max())


def _around(torque: NDArray[np.float64], phase: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the power of each bin near that of a phase, shape (2 _FLOOR + 1,)."""
    taken = np.fft.fft(torque * np.hanning(torque.size) * np.exp(-1j * phase))
    around = np.concatenate([taken[-_FLOOR:], taken[: _FLOOR + 1]])
    return np.asarray(around.real**2 + around.imag**2)
