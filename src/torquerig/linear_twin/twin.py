"""What the linear twin of a rig passes on to the reading: transfers, lines and the spectrum of random loads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from math import pi, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.linear_twin.transfer import Response, on_grid
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.rig.host_changes import lowest_cutoff
from torquerig.rig.steady import steady_torque_in
from torquerig.rig.terms import GROUND, BladeTorque, Drive, HarmonicTorque, Load, Spring, Term

Floats = NDArray[np.float64]

_TURN = np.linspace(-pi, pi, 4096, endpoint=False)
_PULSE = np.maximum(0.0, np.cos(_TURN)) ** 2
BLADE_MEAN = float(_PULSE.mean())
_NOTHING = 1e-30  # [(N m)^2/Hz]
_BLADE_SERIES = tuple(float(2 * np.mean(_PULSE * np.cos(k * _TURN))) for k in range(1, 8))  # zero to peak


class Passage(NamedTuple):
    """The transfer of something to the reading: ``response`` of the shafts on their grid, then the sensor's low-pass.

    Where ``answer`` is given it is multiplied by the size of that response at ``slower`` times the frequency. ``sway``
    is the response of the motor's angle to the same thing [rad], None without a speed loop. ``acts`` holds the torques
    on nodes that the thing is for the shafts, each per unit of it, a number or on their grid.
    """

    twin: Twin
    response: Response
    sway: Response | None = None
    answer: Response | None = None
    slower: float = 1.0
    acts: tuple[tuple[str, Response | float], ...] = ()

    def __call__(self, frequencies: Floats) -> Response:
        """Return the transfer at frequencies [Hz], shape (points,)."""
        return np.asarray(passed([self], frequencies[None])[0])


class LineSource(NamedTuple):
    """A line that follows the shafts: order on the motor shaft, amplitude at its source, transfer to the reading.

    ``by_load`` marks amplitudes that are a share of the motor's torque; ``node`` is what turns by the line's angle.
    ``phase`` is the stated one [rad], None where each run may have another.
    """

    owner: str
    order: float
    amplitude: float
    transfer: Passage
    by_load: bool = False
    node: str = ""
    phase: float | None = None


def sources(lines: Sequence[LineSource], motor: Floats) -> Floats:
    """Return the lines' amplitudes at their sources, shape (lines, stretches), the motor's torque being (stretches,).

    In the unit of each line's own source.
    """
    amplitude, by_load = np.array([line.amplitude for line in lines]), np.array([line.by_load for line in lines])
    return np.asarray(amplitude[:, None] * np.where(by_load[:, None], np.abs(motor), 1.0))


class _Torque(NamedTuple):
    """A wave of torque between two nodes, by the angle of a third: order on the motor shaft, amplitude [N m]."""

    owner: str
    on: str
    against: str
    turning: str
    order: float
    amplitude: float
    phase: float | None = None


def _torque(passed: dict[str, Response], node: str, against: str) -> Response:
    """Return what a torque between two nodes does, from what a torque on each does."""
    return passed[node] if against == GROUND else passed[node] - passed[against]


def _error(passed: dict[str, Response], spring: Spring, force: Response) -> Response:
    """Return the same of a kinematic error in a spring of so much force per turn."""
    return np.asarray(force * (passed[spring.b] - passed[spring.a] / (spring.ratio * spring.efficiency)))


def passed(passages: Sequence[Passage], frequencies: Floats, which: NDArray[np.intp] | None = None) -> Response:
    """Return the transfers of a twin's passages at frequencies [Hz], shape (n, points).

    Each is asked at its own row of frequencies; else ``which``, shape (n,), says whose each row is.
    """
    shafts, amplifier = passages[0].twin.shafts, passages[0].twin.amplifier(frequencies)
    answer = shafts.each_at([each.response for each in passages], frequencies, which) * amplifier
    answers = [each.answer for each in passages if each.answer is not None]
    if answers:
        own = np.arange(len(passages)) if which is None else which
        order = np.cumsum([each.answer is not None for each in passages]) - 1  # among those that answer
        answering = np.flatnonzero(np.array([each.answer is not None for each in passages])[own])
        slower = np.array([each.slower for each in passages])[own[answering], None]
        answered = shafts.each_at(answers, slower * frequencies[answering], order[own[answering]])
        answer[answering] *= np.abs(answered)
    return answer


class Twin:
    """The rig at its run, linear, with its speed loop closed and its sensor's low-pass behind it."""

    def __init__(self, rig: Rig) -> None:
        self.rig = rig
        self.terms: tuple[Term, ...] = rig.terms()
        self.springs = {term.name: term for term in self.terms if isinstance(term, Spring)}
        self.drives = [term for term in self.terms if isinstance(term, Drive)]
        self.shafts = on_grid(rig, self.terms)

    @cached_property
    def cutoff(self) -> float:
        """Cutoff of the sensor's low-pass [Hz], infinite where there is no amplifier."""
        sensor = self.rig.part(self.rig.measured)
        if not isinstance(sensor, AmplifiedTorqueSensor):
            return float("inf")
        return lowest_cutoff(sensor.bandwidth, self.rig.changes_in(sensor.name))

    @cached_property
    def scale(self) -> float:
        """True over stated sensitivity of the sensor [1]."""
        sensor = self.rig.part(self.rig.measured)
        return float(getattr(sensor, "scale", 1.0)) if sensor.is_sensor else 1.0

    def amplifier(self, frequencies: Floats) -> Response:
        """Return the sensor's scale times its second-order Butterworth low-pass [1]."""
        ratio = frequencies / self.cutoff
        square = ratio**2
        return np.asarray(self.scale * (1 - square - 1j * sqrt(2) * ratio) / (1 + square**2))

    def amplifier_power(self, frequencies: Floats) -> Floats:
        """Return what scale and low-pass leave of a density [1]."""
        return np.asarray(self.scale**2 / (1 + (frequencies / self.cutoff) ** 4))

    def torque_on(self, node: str, against: str = GROUND) -> Passage:
        """Return the transfer of a torque between two nodes to the reading [N m per N m]."""
        sway = _torque(self.shafts.angle, node, against) if self.shafts.angle else None
        acts = ((node, 1.0), *([] if against == GROUND else [(against, -1.0)]))
        return Passage(self, _torque(self.shafts.reading, node, against), sway, acts=acts)

    def error_in(self, spring: str) -> Passage:
        """Return the transfer of a kinematic error in ``spring`` [rad at its b side] to the reading [N m per rad]."""
        term = self.springs[spring]
        force = np.asarray(term.stiffness + 2j * pi * self.shafts.frequency * term.damping, dtype=np.complex128)
        sway = _error(self.shafts.angle, term, force) if self.shafts.angle else None
        response = _error(self.shafts.reading, term, force)
        acts = (term.b, force), (term.a, -force / (term.ratio * term.efficiency))
        return Passage(self, response + force if spring == self.rig.measured else response, sway, acts=acts)

    def lines(self) -> tuple[LineSource, ...]:
        """Return every line of the rig that follows a shaft."""
        return self._lines

    @cached_property
    def _lines(self) -> tuple[LineSource, ...]:
        return tuple(self._each_line())

    def _each_line(self) -> Iterator[LineSource]:
        for term in self.terms:
            if isinstance(term, Spring):
                yield from self._of_spring(term)
            elif isinstance(term, Drive):
                yield from self._of_drive(term)
        through: dict[tuple[str, str], Passage] = {}
        for each in self._torques():
            if (each.on, each.against) not in through:
                through[each.on, each.against] = self.torque_on(each.on, each.against)
            yield LineSource(
                each.owner, each.order, each.amplitude, through[each.on, each.against], node=each.turning,
                phase=each.phase,
            )  # fmt: skip

    def _of_spring(self, spring: Spring) -> Iterator[LineSource]:
        """Yield its errors; a varying stiffness as the error that, to first order, has its torque."""
        errors = [(wave.order, wave.amplitude) for wave in spring.error]
        if spring.stiffness_waves:
            twist = abs(steady_torque_in(self.rig, spring.name, motor=self.drives[0].on)) / spring.stiffness
            errors += [(wave.order, wave.amplitude * twist) for wave in spring.stiffness_waves]
        if errors:
            passed, turns = self.error_in(spring.name), self.turns[spring.b]
            yield from (LineSource(spring.name, order * turns, error, passed, node=spring.b) for order, error in errors)

    def _of_drive(self, drive: Drive) -> Iterator[LineSource]:
        """Yield its ripple, and what its speed loop answers to an angle error of the encoder at the set-point."""
        passed, turns = self.torque_on(drive.on, drive.against), self.turns[drive.on]
        for wave in drive.ripple:
            yield LineSource(drive.name, wave.order * turns, wave.amplitude, passed, by_load=True, node=drive.on)
            yield from self._beside(wave.order * turns, wave.amplitude, drive)
        for wave in drive.sensing.error:
            s = 1j * wave.order * (self.rig.run.speed or 0.0) * turns
            seen = (drive.kp * s + drive.ki) * wave.amplitude / (1 + drive.sensing.filter_time * s)
            yield LineSource(drive.name, wave.order * turns, abs(seen / (1 + drive.lag * s)), passed, node=drive.on)

    def _beside(self, order: float, depth: float, drive: Drive) -> Iterator[LineSource]:
        """Yield the side lines of a ripple in proportion to the motor's torque.

        Where the speed loop answers a slower line of order m with a torque ``Re(t exp(i m theta))``, ripple of depth d
        and order n makes ``d |t| / 2`` of it at n + m and at n - m.
        """
        passed, answers = self.torque_on(drive.on, drive.against), dict[tuple[str, str], Response]()
        for slow in self._torques() if self.shafts.drive else ():
            if slow.order < order and depth * slow.amplitude > 0:
                between = slow.on, slow.against
                if between not in answers:
                    answers[between] = _torque(self.shafts.drive, *between)
                for side in (order - slow.order, order + slow.order):
                    sideways = Passage(self, passed.response, passed.sway, answers[between], slow.order / side)
                    yield LineSource(drive.name, side, 0.5 * depth * slow.amplitude, sideways, node=drive.on)

    def _torques(self) -> Iterator[_Torque]:
        """Yield the torques that follow a shaft, wave by wave."""
        for term in self.terms:
            if isinstance(term, HarmonicTorque):
                for wave in term.waves:
                    order = wave.order * self.turns[term.angle]
                    yield _Torque(term.name, term.on, term.against, term.angle, order, wave.amplitude, wave.phase)
            elif isinstance(term, BladeTorque):
                for harmonic, share in enumerate(_BLADE_SERIES, start=1):
                    order = harmonic * term.order * self.turns[term.on]
                    yield _Torque(term.name, term.on, GROUND, term.on, order, share * term.amplitude)

    @cached_property
    def turns(self) -> dict[str, float]:
        """Turns of each node per turn of the motor, without sign."""
        return {node: abs(ratio) for node, ratio in self._ratios.items()}

    def direction(self, node: str) -> float:
        """Return 1 where a node turns forward with the motor, -1 where it turns backward."""
        return 1.0 if self._ratios[node] > 0 else -1.0

    @cached_property
    def forward(self) -> bool:
        """Whether the sensor turns the way of the motor; else it reads a torque that drives as negative."""
        return self._ratios[self.springs[self.rig.measured].b] > 0

    @cached_property
    def _ratios(self) -> dict[str, float]:
        return self.rig.speed_ratios(self.drives[0].on)

    def load_power(self, frequencies: Floats) -> Floats:
        """Return the one-sided spectral density that random loads leave in the reading [(N m)^2/Hz]."""
        return np.asarray(np.exp(np.interp(np.log(frequencies), np.log(self.shafts.frequency), np.log(self._load))))

    def answered_power(self, frequencies: Floats) -> Floats:
        """Return the density of the torque that the speed loop answers to random loads with [(N m)^2/Hz]."""
        return np.asarray(np.interp(frequencies, self.shafts.frequency, self._answered))

    def sway(self, node: str, *, followed: float) -> Floats:
        """Return the density of a node's angle about the known one under random loads, on the shafts' grid.

        The angle is in turns of the motor [rad^2/Hz]. What is known of it is its mean course and, up to the frequency
        ``followed`` [Hz], the motor's angle.
        """
        shafts, drives = self.shafts, [drive.on for drive in self.drives]
        own = shafts.angles.get(node, {}) if node in self._ratios else {}
        if not own:
            return np.zeros(shafts.frequency.size)
        motor = shafts.angles[drives[0]]
        known = shafts.frequency <= followed
        loaded = {term.on for term in self.terms if isinstance(term, Load)} & own.keys()
        return self._driven({on: own[on] / self._ratios[node] - np.where(known, motor[on], 0.0) for on in loaded})

    def load_power_between(self, low: Floats, high: Floats) -> Floats:
        """Return the mean of that density between two frequencies [Hz] each: a sharp mode is narrower than a band."""
        grid = self.shafts.frequency
        steps = 0.5 * (self._load[1:] + self._load[:-1]) * np.diff(grid)
        summed = np.concatenate([[0.0], np.cumsum(steps)])
        return np.asarray((np.interp(high, grid, summed) - np.interp(low, grid, summed)) / (high - low))

    @cached_property
    def _load(self) -> Floats:
        """Density of random loads in the reading on the grid of the shafts."""
        passed = self.amplifier_power(self.shafts.frequency)
        return np.asarray(self._driven(self.shafts.reading) * passed + _NOTHING)

    @cached_property
    def _answered(self) -> Floats:
        """The same of what the speed loop answers to them."""
        return self._driven(self.shafts.drive) if self.shafts.drive else np.zeros(self.shafts.frequency.size)

    def _driven(self, passed: dict[str, Response]) -> Floats:
        power = np.zeros(self.shafts.frequency.size)
        for term in self.terms:
            density = getattr(term.process, "density", None) if isinstance(term, Load) else None
            if isinstance(term, Load) and density is not None:
                power += np.abs(passed[term.on]) ** 2 * density(self.shafts.frequency)
        return power
