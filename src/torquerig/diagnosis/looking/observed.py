"""A recording made ready to be compared: its torque, the motor's angle, and which stretches no fit may see."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run

UNMEASURED = 0.012  # an angle followed in the torque strays by so much from turn to turn [1]
SHORTEST = 2.0  # [s] less holds no turn of a slow shaft and no spectrum of the load
_STEADY_STRETCHES = 6  # the last third of a steady run is held out
_TURNS_PER_STRETCH = 1.5  # of the output shaft, in a ramp: neighbouring orders can just be told apart


@dataclass(frozen=True)
class Stretch:
    """Samples ``start`` to ``stop`` of a run; ``held`` ones are only looked at when a finished model is judged."""

    start: int
    stop: int
    held: bool


@dataclass(frozen=True, kw_only=True)
class Observed:
    """One run of the rig that is diagnosed.

    Parameters
    ----------
    recording : Recording
        As read.
    torque : ndarray, shape (samples,)
        The measured torque [N m] (force on a rig that moves in a line), moments without signal bridged.
    angle : ndarray, shape (samples,)
        Of the motor [rad].
    speed : ndarray, shape (samples,)
        Of the motor [rad/s], smoothed over 50 ms.
    origin : str
        Where the angle comes from, in words.
    angle_measured : bool
        Whether a channel of the recording gave it.
    stretches : tuple of Stretch
        In their order, without gaps.
    rebuilt : bool
        Whether moments at a limit were filled in, whose ends ring through the spectrum, which is then not looked at.
    stepping : bool
        Whether the mean torque of this run or of another steps, or jumps between two levels, of which some may not have
        been seen and stay in it.
    broken : bool
        Whether samples of this run were written twice or lost, so that tones jump in phase that never did.
    swept : tuple of (float, float)
        Lowest and highest frequency [Hz] of each line that swept in this run or in another, and was taken out: some of
        it is left.
    tones : tuple of float
        Lines at one speed that keep their frequency by what the shaft's own lines tell [Hz].
    notches : tuple of float
        Where the spectra of all steady runs have a narrow notch [Hz].
    slipping : bool
        Whether something slipped and gripped again in this run or another, whose smaller blows stay in it.
    struck : tuple of (int, int)
        Moments of this run that such blows took, which were bridged: first sample and one past the last.
    """

    recording: Recording
    torque: NDArray[np.float64]
    angle: NDArray[np.float64]
    speed: NDArray[np.float64]
    origin: str
    angle_measured: bool
    stretches: tuple[Stretch, ...]
    rebuilt: bool = False
    stepping: bool = False
    broken: bool = False
    swept: tuple[tuple[float, float], ...] = ()
    tones: tuple[float, ...] = ()
    notches: tuple[float, ...] = ()
    slipping: bool = False
    struck: tuple[tuple[int, int], ...] = ()

    @property
    def name(self) -> str:
        """The file's name."""
        return self.recording.name

    @property
    def rate(self) -> float:
        """Samples per second [Hz]."""
        return self.recording.sample_rate

    @property
    def run(self) -> Run:
        """The test sheet, with the set-point speed as it was really held."""
        return self.recording.run

    def mask(self, *, held: bool | None) -> NDArray[np.bool_]:
        """Return which samples fits may see (``held`` False), may not see (True), or all (None)."""
        answer = np.zeros(self.torque.size, dtype=bool)
        for stretch in self.stretches:
            answer[stretch.start : stretch.stop] = held is None or stretch.held == held
        return answer

    @property
    def seen(self) -> slice:
        """From the first to the last sample that fits may see; in a steady run all between them."""
        seen = [stretch for stretch in self.stretches if not stretch.held]
        return slice(seen[0].start, seen[-1].stop)

    @property
    def torque_unit(self) -> float:
        """Torque [N m] per unit of the recorded channel."""
        return self.recording.channels[self.recording.torque_name()].si_per_unit

    @property
    def smearing(self) -> float:
        """Share of its frequency over which lines spread because the angle was not measured [1]."""
        return 0.0 if self.angle_measured else UNMEASURED

    @property
    def steady(self) -> bool:
        """Whether the speed was held."""
        return self.run.profile == "steady"

    @cached_property
    def mean_speed(self) -> float:
        """Mean speed of the motor [rad/s]."""
        return float(self.speed.mean())


def observed(recording: Recording, angle: ShaftAngle, *, ratio: float) -> Observed:
    """Return the run ready to compare; ``ratio`` is the motor's turns per turn of the output."""
    if recording.duration < SHORTEST:
        raise RecordingError(
            f"{recording.name}: {recording.duration:.2f} s are too short for a diagnosis; record at least "
            f"{SHORTEST:g} s, better 12 s"
        )
    run = recording.run
    held_at = replace(run, speed=None if run.speed is None else run.speed * angle.factor)
    return Observed(
        recording=replace(recording, run=held_at),
        torque=recording.torque(),
        angle=angle.values,
        speed=speed_of(angle.values, recording.sample_rate),
        origin=angle.origin,
        angle_measured=angle.measured,
        stretches=_stretches(run, angle.values, ratio=ratio),
    )


def _stretches(run: Run, angle: NDArray[np.float64], *, ratio: float) -> tuple[Stretch, ...]:
    """Steady runs in six parts, the last two held out; others by turns of the output shaft, every third held out."""
    if run.profile == "steady":
        edges = np.linspace(0, angle.size, _STEADY_STRETCHES + 1).astype(int)
        return _cut(edges, lambda index: index >= _STEADY_STRETCHES - 2)
    turned = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(angle)))]) / (2 * pi * abs(ratio))
    count = max(6, int(turned[-1] / _TURNS_PER_STRETCH))
    edges = np.searchsorted(turned, np.linspace(0.0, turned[-1], count + 1))
    edges[0], edges[-1] = 0, angle.size
    return _cut(np.unique(edges), lambda index: index % 3 == 2)


def _cut(edges: NDArray[np.int64], held: object) -> tuple[Stretch, ...]:
    pairs: Sequence[tuple[int, int]] = list(zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True))
    return tuple(Stretch(start, stop, bool(held(index))) for index, (start, stop) in enumerate(pairs))  # type: ignore[operator]
